// All images of a point star in a frame, found another way than the renderer does: the angle of each ray by bracketing
// the reference's own orbits, between which the swept angle is a sum of Chebyshev's polynomials; its light by the Jacobians of the camera's
// view, differenced numerically, and of that sum.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "base/vec.h"
#include "image/image.h"
#include "reference/frame_tracer.h"
#include "sky/point_stars.h"

namespace nullscope::reference {

struct StarImage {
    double x, y;         // px: column, row from the top
    int order;           // 0: the direct one; -1 where rays stay in no plane (images_by_mesh)
    double solid_angle;  // of sky that a pixel's area at (x, y) covers, sr/px^2
    double g;            // frequency in the camera over frequency at infinity
};

class StarImages {
public:
    // Images 0 ... orders - 1. Some milliseconds. tracer: of rays that stay in planes; outlives this.
    StarImages(const FrameTracer& tracer, const Scene& scene, int orders);
    // Those in the frame or at most margin px beside it, by order; some 5 microseconds an image.
    std::vector<StarImage> of(Vec3 direction, double margin_px) const;

private:
    static constexpr std::size_t kTerms = 18;
    struct Sample {
        double place, swept;
    };
    // By place, where its sum is exact but for the roundings of the angles: to 1e-13 and those.
    struct Stretch {
        bool settles = false;
        std::array<double, kTerms> swept{}, slope{};
    };
    struct Found {
        double inward, alpha;  // angles from inward and outward, each with its digits
        double slope;          // of the swept angle by alpha
    };
    Found find(double wanted) const;
    void add_image(double x, double y, int order, double margin_px, double sky_per_view,
                   std::vector<StarImage>& images) const;
    double off(double place) const;  // of a ray's angle from inward, beyond that of the last ray that reaches the sky
    double swept(double inward) const;  // NaN for rays that do not reach the sky
    double swept_at(double place) const { return swept(last_ + off(place)); }
    void make_stretches();

    const FrameTracer& tracer_;
    CameraSpec camera_;
    int orders_;
    double last_ = 0;              // of the last ray that reaches the sky, from inward
    std::vector<Sample> samples_;  // swept grows
    std::vector<Stretch> stretches_;
};

// Linear Rec. 709 times sr: what an image adds to the picture, before its point spread.
Vec3 star_light(const PointStar& star, double g, const LightSpec& light);

// What finds them whatever the metric, by a mesh of rays: within the margin, order -1. A ray a pixel of the picture
// with its margin, more along the shadow's edge (about a rotating hole 0.3 ms each); then some 5 ms an image. Images
// closer to that edge than 1/8 px are not found. tracer: outlives it.
std::function<std::vector<StarImage>(Vec3)> images_by_mesh(const FrameTracer& tracer, const Scene& scene,
                                                           double margin_px);

// What finds a star's images that a picture can show, whatever the metric: from its direction. tracer: outlives it.
std::function<std::vector<StarImage>(Vec3)> images_of(const FrameTracer& tracer, const Scene& scene);

// Adds the stars, spread as sky/point_stars.h says, to a picture in linear light. transmission: what of a point behind
// the pixel position (column, row) shines through.
void add_point_stars(const FrameTracer& tracer, const Scene& scene, const std::vector<PointStar>& stars,
                     const std::function<double(double x, double y)>& transmission, Image<float>& picture);

}  // namespace nullscope::reference
