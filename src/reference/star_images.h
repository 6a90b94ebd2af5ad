// All images of a point star in a frame, found another way than the renderer does: the angle of each ray by bracketing
// the reference's own orbits, its light by the Jacobian of the frame's ray map, differenced numerically.
#pragma once
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
    // Those in the frame or at most margin px beside it, by order; some 30 microseconds a star.
    std::vector<StarImage> of(Vec3 direction, double margin_px) const;

private:
    struct Sample {
        double alpha, swept;
    };
    void add_image(double x, double y, int order, double margin_px, std::vector<StarImage>& images) const;
    double swept(double alpha) const;  // NaN for rays that do not reach the sky

    const FrameTracer& tracer_;
    CameraSpec camera_;
    int orders_;
    std::vector<Sample> samples_;  // swept grows
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
