// The reference: an independent double-precision tracer. It shares no geodesic code with the shader core or the table.
//
// Orbits are closed forms (Carlson's integrals, Jacobi's functions) of quantities formed without cancellation: angles,
// delays and positions along the ray are good to about 1e-15 relative, times the conditioning of the question.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "scene/ray.h"
#include "scene/scene.h"
#include "sky/point_stars.h"
#include "sky/sky.h"

namespace nullscope::reference {

class DiscLight;

// One ray in the scene's spacetime. crossings: how many crossings of the equatorial plane to list. matter: gives them their g.
// A ray that falls inward from a camera at or inside the horizon has ended where it starts: nothing is listed for it.
// Errors: query outside the metric's domain, frame that does not exist there.
Result<RayRecord> trace_ray(const Scene& scene, const RayQuery& query, int crossings = 0,
                            const DiscLight* matter = nullptr);

// The ray data of a whole frame on all cores, 0.7 to 2 million rays a second and core. delay is always filled in.
// done(n): called from any thread after n more pixels. Deterministic. Errors: bad camera, disc or metric.
Result<RayFrame> trace_frame(const Scene& scene, const std::function<void(long long)>& done = {});

// The same for a list of pixel positions (column, row from the top; centres at +0.5). Delays may cost several times the rest.
Result<std::vector<RayPixel>> trace_pixels(const Scene& scene, const std::vector<std::array<double, 2>>& positions,
                                           bool with_delay = true);

// Images of the scene's objects; without one an object is white. disc: 3 or 4 channels, alpha not multiplied in.
struct Pictures {
    Pictures(const Image<float>* disc_image = nullptr) : disc(disc_image) {}  // NOLINT: a disc alone is the common case
    const Image<float>* disc;
    std::vector<const Image<float>*> bodies;  // as Scene::bodies; nullptr, or none: without an image
    const Image<float>* of(std::size_t body) const { return body < bodies.size() ? bodies[body] : nullptr; }
};

// stars: of kind kPoints, sky/point_stars.h.
// Linear RGB (exposure not applied), samples x samples rays a pixel, averaged in linear light. far_sky: of
// wormholes; without one it is black.
Result<Image<float>> render_frame(const Scene& scene, const SkyCube& sky, const Pictures& pictures, int samples,
                                  const std::function<void(long long)>& done = {}, const SkyCube* far_sky = nullptr,
                                  const std::vector<PointStar>& stars = {});

// The light of single pixels, and half of the difference of the means over every other ray and over the rest: about what the light is
// uncertain by. samples: even.
struct PixelLight {
    Vec3 light, uncertainty;
};
// For columns and rows from the top. Without point stars.
Result<std::vector<PixelLight>> render_pixels(const Scene& scene, const SkyCube& sky, const Pictures& pictures,
                                              int samples, const std::vector<std::array<int, 2>>& pixels,
                                              const SkyCube* far_sky);

}  // namespace nullscope::reference
