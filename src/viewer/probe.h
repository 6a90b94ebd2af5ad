// The ray of the pixel under the cursor, by the reference tracer: its numbers, and an inset that draws its way.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "reference/disc_light.h"
#include "reference/frame_tracer.h"
#include "reference/ray_curve.h"
#include "reference/traced_ray.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"
#include "studio/number_words.h"
#include "viewer/potential_plot.h"

namespace nullscope::viewer {

// In the ray's plane, about a rotating hole as seen from its pole, r_s, the camera on the positive x axis; r: the metric's own radius there.
struct PathPoint {
    double x, y, r;
};

struct ProbeFacts {
    Fate fate = Fate::kNoSky;
    int hit = 0;                            // number of what it meets first (object_name)
    double hit_r = kNotANumber;             // and where, r_s
    double zeta0 = 0;                       // r_s/r of the camera
    double impact = kNotANumber;            // impact parameter b = L/E (without spin), r_s
    double of_critical = kNotANumber;       // over that of the light that spirals to the photon sphere
    double turn_r = kNotANumber;            // turning point, r_s
    double windings = 0;                    // swept angle over a full turn; about a rotating hole that of the azimuth
    double delay = kNotANumber;             // r_s/c, of rays that reach the sky
    std::optional<reference::Shift> shift;  // from what is seen to the camera; of captured rays there is none
    std::vector<PathPoint> path;
    std::optional<double> disc;             // swept angle where the equatorial plane is first met
    std::optional<PotentialRay> potential;  // of rays in a plane
};

class Probe {
public:
    // Looks at pixel position (x, y) of the scene's picture, from its top left. Under a millisecond, about a rotating hole some milliseconds; some more for another spacetime.
    void look(const Scene& scene, double x, double y);
    void forget() { facts_.reset(); }
    // Between NewFrame and Render, in the lower right corner of what lies between `left`, `top` and `bottom`. potential: with the effective
    // potential of the ray. Where there is little room, with one chart and the first numbers.
    void draw(float left, float top, float bottom, bool potential, const NumberStyle& numbers);
    // Of what was looked at last, if it was in this spacetime; else nullptr.
    const ProbeFacts* facts_in(const SpacetimeSpec& spacetime) const {
        return facts_ && scene_.spacetime == spacetime ? &*facts_ : nullptr;
    }
    float width() const { return facts_ ? width_ : 0.0f; }  // that it took in its last frame, with the gap at its right

private:
    bool follow(const Scene& scene);
    void meet_disc(const reference::TracedRay& ray, const reference::DiscHit& hit, ProbeFacts& facts) const;
    void see_from_pole(double x, double y, double end, double g, ProbeFacts& facts) const;
    ProbeFacts facts_of(const reference::TracedRay& ray, double x, double y) const;

    Scene scene_;
    std::optional<reference::FrameTracer> tracer_;
    std::unique_ptr<reference::Metric> metric_;
    std::optional<reference::DiscLight> matter_;  // how it moves about metric_
    std::shared_ptr<const Spacetime> spacetime_;
    std::vector<LandmarkCircle> circles_;
    std::optional<ProbeFacts> facts_;
    float width_ = 0.0f;
};

}  // namespace nullscope::viewer
