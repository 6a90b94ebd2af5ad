// The light of a scene's thermal disc at a place of its picture, by the reference's rays and laws, in double: what derivatives and sums over pictures are judged by.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/disc_light.h"
#include "reference/frame_tracer.h"
#include "scene/scene.h"

namespace nullscope::test {

// Discs with soft rims, plain, of a formula (0.5 + 0.4*sin(12*v)*x/length(x, y)), or without an image.
class KnownLight {
public:
    explicit KnownLight(const Scene& scene)
        : scene_(scene),
          tracer_(std::move(*reference::FrameTracer::make(scene))),
          light_(tracer_.matter(), *scene.disc, scene.light) {}

    Vec3 at(double x, double y) const {
        const DiscSpec& disc = *scene_.disc;
        const auto ray = tracer_.ray(x, y);
        Vec3 sum;
        double through = 1;
        for (const auto& hit : tracer_.disc_hits(*ray, 16)) {
            const double r = std::hypot(hit.x, hit.y), depth = std::min(r - disc.inner, disc.outer - r),
                         t = std::clamp(depth / (disc.outer - disc.inner) / disc.edge, 0.0, 1.0),
                         alpha = disc.opacity * t * t * (3 - 2 * t);
            const reference::PhotonAtDisc photon{r, hit.l, hit.climb, hit.cosine, hit.across};
            const Vec3 light = light_.colour(photon, ray->g * light_.shift(photon).seen(scene_.light));
            const Vec3 paint = through * alpha * disc.brightness * colour(hit.x, hit.y);
            sum = sum + Vec3{paint.x * light.x, paint.y * light.y, paint.z * light.z};
            through *= 1 - alpha;
        }
        return sum;
    }

private:
    Vec3 colour(double x, double y) const {
        const Material& material = scene_.disc->material;
        if (material.texture == TextureKind::kImage) return {1, 1, 1};  // none of its own
        if (material.texture != TextureKind::kFormula) return material.colour;
        const double r = std::hypot(x, y), v = (r - scene_.disc->inner) / (scene_.disc->outer - scene_.disc->inner),
                     share = std::clamp(0.5 + 0.4 * std::sin(12 * v) * x / r, 0.0, 1.0);
        return share * material.colour + (1 - share) * material.second_colour;
    }
    Scene scene_;
    reference::FrameTracer tracer_;
    reference::DiscLight light_;
};

}  // namespace nullscope::test
