// Where the images of stars are about a rotating hole, where the lens has two dimensions and no table: a mesh of rays is laid over the
// picture, traced by the shader core in double; the triangles of sky that its cells cover say which stars have an image there.
#pragma once
#include <functional>
#include <vector>

#include "render/star_grid.h"
#include "scene/scene.h"
#include "shadercore/core_trace.h"

namespace nullscope {

struct MeshImage {
    double x, y;  // px of a pixel's height from the line of sight, y up
    double g;     // frequency in the camera over frequency at infinity
    double area;  // of sky that a pixel's area at (x, y) covers, sr/px^2
    int star;     // number in the list
};

struct MeshArea {
    double left, right, bottom, top;  // as MeshImage's x and y
};
MeshArea mesh_area(const CameraSpec& camera, double margin_px);  // the whole picture, and so much more on every side

class StarMesh {
public:
    StarMesh(const std::vector<PointStar>& stars, bool bolometric) : stars_(stars, bolometric) {}

    const StarLight& light(int star) const { return stars_.light(star); }  // number i of the list

    // The images that can be seen in this part of the picture, by star: each within 0.01 px and 1 % of its area, next to the shadow
    // too. Closer to the shadow's edge than kMeshFinest cells there are none. kMeshCells rays and some six times as many along the edge
    // for the whole catalogue, on all cores: half a second on two. Thread-safe; same result for the same input.
    // quick: kQuickCells rays and no more, a fifth of the time: 93 of 100 images are found; those next to the shadow are missing.
    struct Seeing {
        bool shift = true, beaming = true;  // LightSpec
        // Log2 of the light of an image's brightest primary over the sky in a pixel, 1/(px^2).
        double magnitude_limit = 0.0;
        bool quick = false;
    };
    // give_up: asked between rows of cells; once it is true, the list is of no use.
    std::vector<MeshImage> images(
        const CoreInput& input, const MeshArea& area, const Seeing& seeing,
        const std::function<bool()>& give_up = [] { return false; }) const;

private:
    StarGrid stars_;
};

inline constexpr int kMeshCells = 60000, kQuickCells = 40000;
inline constexpr double kMeshFinest = 1.0 / 16;  // of a cell of the mesh

}  // namespace nullscope
