// A sky, ready to be painted row by row on the faces of a cube map: whoever wants it, in floats or packed, asks for the rows.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"
#include "sky/milky_way.h"
#include "sky/nebula.h"
#include "sky/panorama.h"
#include "sky/sky_rows.h"
#include "sky/star_light.h"

namespace nullscope {

class SkyPainter {
public:
    // face_size: power of two, 16 ... 8192. border: texels about each face that show what lies beside it, 0 or face_size / kBorderOf.
    // Errors: another size, image missing, not an image, asset missing. Parallel.
    static Result<SkyPainter> make(const SkySpec& spec, const std::filesystem::path& assets, int face_size, int border);

    int face_size() const { return size_; }
    int border() const { return border_; }

    // The rows [first, first + count) of a face; first >= -border. Any number of threads may call it, each with rows of its own.
    void paint(int face, int first, int count, SkyRows& rows) const;

    bool is_image() const { return image_.has_value(); }
    double largest() const { return image_->largest(); }  // of an image: none of its light exceeds it

    std::vector<std::string> notes() const { return image_ ? image_->notes() : std::vector<std::string>(); }

private:
    int size_ = 0, border_ = 0;
    std::optional<MilkyWay> haze_;
    std::optional<Nebula> nebula_;
    std::optional<StarPainter> stars_;
    std::optional<Panorama> image_;
};

}  // namespace nullscope
