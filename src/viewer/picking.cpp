#include "viewer/picking.h"

#include "reference/frame_tracer.h"
#include "scene/split.h"

namespace nullscope::viewer {

std::optional<std::size_t> body_at(const Scene& scene, double x, double y) {
    if (const auto parts = halves(scene)) {
        const double middle = parts->left.camera.width;
        return x < middle ? body_at(parts->left, x, y) : body_at(parts->right, x - middle, y);
    }
    const auto tracer = reference::FrameTracer::make(scene);
    if (!tracer) return std::nullopt;
    const auto ray = tracer->ray(x, y);
    const auto hit = ray->first_hit();
    if (!hit) return std::nullopt;
    const auto disc = tracer->disc_hits(*ray, 1);
    if (!disc.empty() && disc.front().along < hit->along && scene.disc->opacity == 1.0) return std::nullopt;
    return hit->body;
}

}  // namespace nullscope::viewer
