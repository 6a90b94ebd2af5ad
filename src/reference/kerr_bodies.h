// Where a ray about a rotating hole meets the solid bodies: shown the ray's steps one by one, it looks along them.
#pragma once
#include <optional>
#include <vector>

#include "reference/bodies.h"
#include "reference/first_change.h"
#include "reference/kerr_ray.h"

namespace nullscope::reference {

class BodyWatch {
public:
    // Of one ray. bodies: outlives this. delay: light takes time, and what moves is seen where it was.
    BodyWatch(const Bodies& bodies, bool delay);
    BodyWatch(const BodyWatch&) = delete;
    BodyWatch& operator=(const BodyWatch&) = delete;
    // For trace_kerr, while this lives; empty where there are no bodies. A sample is 1 microsecond, a ray past a body takes some hundred.
    KerrWatch watch();
    const std::optional<BodyHit>& hit() const { return hit_; }  // the first body that the ray enters

private:
    struct PlacedLook : Look {
        KerrPlace place;
    };
    struct Track {  // of one body: the last two looks, where the ray is near it
        const BodyPart* part;
        std::optional<PlacedLook> before{}, here{};
        int looks = 0;
    };
    void see(const KerrStep& step);
    void follow(Track& track, const KerrStep& step);
    std::optional<double> entry(const Track& track, const PlacedLook& there, const KerrStep& step) const;
    void meet(const BodyPart& part, double along, const KerrStep& step);
    KerrPlace place_at(double along, const KerrStep& step) const {
        return along < step.from && previous_ ? previous_->between(along) : step.between(along);
    }
    double time_at(const BodyPart& part, const KerrPlace& place) const {
        return part.changes() && delay_ ? bodies_.time() - place.delay : bodies_.time();
    }
    double value_of(const BodyPart& part, const KerrPlace& place) const {
        return part.value(place.flat(), time_at(part, place));
    }
    double way(const BodyPart& part, const KerrPlace& from, const KerrPlace& to) const;

    const Bodies& bodies_;
    bool delay_;
    std::vector<Track> tracks_;
    std::optional<KerrStep> previous_;
    std::optional<BodyHit> hit_;
};

}  // namespace nullscope::reference
