// Light times along the rays of one camera, asked of very many of them: between those of a grid of rays.
#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "reference/light_time.h"
#include "reference/orbit.h"

namespace nullscope::reference {

class LightTimes {
public:
    // A ray in its plane, by the angle of its view direction from inward, which has more digits than that from outward where it counts:
    // next to the last ray; and its E r_s/L.
    struct Ray {
        std::unique_ptr<Orbit> orbit;
        double q;
    };
    using RayAt = std::function<Ray(double inward)>;
    // metric: outlives this. Outside of a horizon.
    LightTimes(const OrbitMetric& metric, RayAt ray_at, double camera_r, bool falls);
    // As LightClock::delay of that ray, to the same error; nothing where the grid does not reach that: next to the last ray that escapes, and
    // of rays that do not. Some microseconds, and once in a while a ray of the grid.
    std::optional<double> operator()(double inward, double angle) const;

private:
    struct Known {
        std::once_flag made;
        std::mutex mutex;
        Ray ray;
        double place = 0;
        std::optional<LightClock> clock;
    };
    double place_of(double inward) const;  // on the grid
    double delay(std::size_t i, double angle) const;
    const OrbitMetric& metric_;
    RayAt ray_at_;
    double camera_r_;
    bool falls_;
    double last_;   // of the last ray that escapes
    double least_;  // what a ray must be off that
    mutable std::vector<Known> grid_;
};

}  // namespace nullscope::reference
