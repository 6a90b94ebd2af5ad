// Where the images of stars are about a spinning hole, where the lens has two dimensions and no table: a mesh of rays is laid over the
// picture, traced by the shader core in double; the triangles of sky that its cells cover say which stars have an image there.
#pragma once
#include <vector>

#include "base/vec.h"
#include "render/star_glow.h"
#include "shadercore/core_trace.h"
#include "sky/point_stars.h"

namespace nullscope {

struct MeshImage {
    double x, y;  // px from the picture's middle, y up
    double g;     // frequency in the camera over frequency at infinity
    double area;  // of sky that a pixel's area at (x, y) covers, sr/px^2
    int star;     // number in the list
};

class StarMesh {
public:
    StarMesh(const std::vector<PointStar>& stars, bool bolometric);

    // Number i of the list.
    double light(int star) const {
        return made_[static_cast<std::size_t>(star)].light;
    }  // log2 of flux over a black body's brightness
    double temperature(int star) const { return made_[static_cast<std::size_t>(star)].temperature; }  // log2 of K

    // The images that can be seen within margin_px of the picture, by star: each within 0.01 px and 1 % of its area, next to the shadow
    // too. Closer to the shadow's edge than kMeshFinest cells there are none. kMeshCells rays and some six times as many along the edge
    // for the whole catalogue, on all cores: half a second on two. Thread-safe; same result for the same input.
    struct Seeing {
        bool shift = true, beaming = true;  // LightSpec
        double faintest = 0.0;  // log2 of the light of an image's brightest primary over the sky in a pixel, 1/(px^2)
    };
    std::vector<MeshImage> images(const CoreInput& input, int width, int height, double margin_px,
                                  const Seeing& seeing) const;

private:
    friend class MeshWalk;
    struct Made {
        double light, temperature;
    };
    // Stars of like brightness, by cell of a grid of equal steps of z and of the azimuth.
    struct Level {
        double brightest = 0.0,
               coldest = 0.0;  // log2 of flux in the brightest primary; log2 of K, of this and of all fainter levels
        int rows = 1, columns = 1;
        std::vector<Vec3> places;
        std::vector<int> numbers;  // of those in the list
        std::vector<int> first;    // of each cell, and the end
    };
    template <class Visit>
    static void visit_near(const Level& level, Vec3 middle, double radius, const Visit& visit);

    StarGlow glow_;
    std::vector<Made> made_;
    std::vector<Level> levels_;  // brightest first
};

inline constexpr int kMeshCells = 60000;
inline constexpr double kMeshFinest = 1.0 / 16;  // of a cell of the mesh

}  // namespace nullscope
