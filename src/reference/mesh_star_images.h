// All images of a point star, whatever the metric: the pixels' grid of the reference's rays, divided along the shadow's edge, says in
// which triangles of directions a star lies; from there Newton's steps on traced rays, until nothing moves any more.
#pragma once
#include <vector>

#include "reference/star_images.h"

namespace nullscope::reference {

class MeshStarImages {
public:
    // A ray a pixel of the picture with its margin and more along the edge (about a rotating hole 0.3 ms a pixel), on all cores. tracer: outlives this.
    MeshStarImages(const FrameTracer& tracer, const Scene& scene, double margin_px);
    // Those within the margin; some 5 ms an image. order is -1: no ray stays in a plane. Images closer to the shadow's edge than
    // 1/8 px are not found.
    std::vector<StarImage> of(Vec3 direction) const;

private:
    struct Ray {
        Vec3 sky;
        bool escaped;
    };
    struct Cell {
        double x, y, size;           // px: column, row from the top
        std::array<Ray, 4> corners;  // (0, 0), (1, 0), (1, 1), (0, 1)
    };
    Ray ray(double x, double y) const;
    void add(const Cell& cell, std::vector<Cell>& cells) const;
    bool settle(Vec3 direction, StarImage& image) const;

    const FrameTracer& tracer_;
    double left_, top_, right_, bottom_;
    std::vector<Cell> cells_;
};

}  // namespace nullscope::reference
