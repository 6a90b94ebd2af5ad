// Where the images of stars are about a spinning hole, where the lens has two dimensions and no table: a mesh of rays is laid over the
// picture, traced by the shader core in double; the triangles of sky that its cells cover say which stars have an image there.
#pragma once
#include <functional>
#include <vector>

#include "base/vec.h"
#include "shadercore/core_trace.h"

namespace nullscope {

struct MeshImage {
    double x, y;    // px from the picture's middle, y up
    double g;       // frequency in the camera over frequency at infinity
    double area;    // of sky that a pixel's area at (x, y) covers, sr/px^2
    int star;       // number in the list
};

class StarMesh {
public:
    // Unit directions on the sky.
    explicit StarMesh(std::vector<Vec3> stars);

    // Could be seen: of this star, this area (sr/px^2, a quarter of what is likely) and this g.
    using Seen = std::function<bool(int star, double area, double g)>;

    // The images that `seen` lets pass within margin_px of the picture, by star. Each is within 0.01 px and 1 % of its area, next to the
    // shadow too; closer to its edge than kMeshFinest_px there are none. kMeshCells rays and some twice that along the shadow's edge, on
    // all cores. Thread-safe; same result for the same input.
    std::vector<MeshImage> images(const CoreInput& input, int width, int height, double margin_px, const Seen& seen) const;

private:
    friend class MeshWalk;
    template <class Visit>
    void near(Vec3 middle, double radius, const Visit& visit) const;   // the stars within an angle of at most pi/2, and some others

    std::vector<Vec3> stars_;     // by cell of the grid
    std::vector<int> numbers_;    // of those in the list that was given
    std::vector<int> first_;      // of each cell, and the end
    int rows_ = 1, columns_ = 1;  // cells of equal area: equal steps of z and of the azimuth
};

inline constexpr int kMeshCells = 60000;
inline constexpr double kMeshFinest_px = 0.25;

}  // namespace nullscope
