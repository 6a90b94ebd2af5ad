// The Milky Way: the equirectangular map of surface brightness that ships, on a cube map's faces.
#pragma once
#include <filesystem>

#include "base/result.h"
#include "base/vec.h"
#include "image/image.h"
#include "sky/face_grid.h"
#include "sky/sky_rows.h"

namespace nullscope {

// Surface brightness of white in the map, in stars of V = 10 per square degree (S10): FULL_S10 of scripts/make_milky_way.py.
inline constexpr double kMapWhite_S10 = 1000.0;

// Radiance of one S10, in the unit of star_flux per sr.
double radiance_of_s10();

class MilkyWay {
public:
    // map: white is kMapWhite_S10; multiplied by brightness. For faces of this size, with a border.
    // Errors: a map that load_image refuses. Cost: the map's decoder, 30 ms.
    static Result<MilkyWay> load(const std::filesystem::path& map, const Mat3& world_from_sky, double brightness,
                                 int size, int border);

    // Writes the rows.
    void paint(SkyRows& rows) const;

private:
    MilkyWay(Image<float> map, const FaceGrid& grid, double scale) : map_(std::move(map)), grid_(grid), scale_(scale) {}

    Image<float> map_;
    FaceGrid grid_;
    double scale_;
};

}  // namespace nullscope
