#include "reference/plane_ray.h"

#include <cmath>

namespace nullscope::reference {

std::vector<PlaneCrossing> PlaneRay::crossings(int most, double inner, double outer) const {
    std::vector<PlaneCrossing> list;
    std::optional<LightClock> clock;
    if (task_.late_disc) clock.emplace(this->clock());
    for (int k = 1; static_cast<int>(list.size()) < most; ++k) {
        const double angle = plane_.crossing(k);
        if (!(angle < end())) break;
        const double r = radius_at(angle);
        if (!(r >= inner && r <= outer)) continue;
        // Traced inward is really moving outward.
        const bool outward = 1 / r > orbit_->zeta_at(angle * (1 - 1e-6));
        const double cosine2 = 1 - metric_.lapse2(r) * (photon_.l * photon_.l) / (r * r);
        list.push_back({angle, r, plane_.azimuth(angle), std::sqrt(std::max(cosine2, 0.0)) * (outward ? 1 : -1),
                        clock ? clock->late(angle) : 0.0});
    }
    return list;
}

std::optional<BodyHit> PlaneRay::first_hit() const {
    std::optional<BodyHit> first;
    if (!task_.bodies || task_.bodies->empty()) return first;
    const bool by_length = metric_.by_proper_length();
    std::optional<LightClock> clock;
    if (task_.late_bodies && task_.bodies->move() && !by_length) clock.emplace(this->clock());
    for (const BodyPart& part : task_.bodies->parts()) {
        const auto time_at = [&](double angle) {
            return part.moves && clock ? task_.bodies->time() - clock->late(angle) : task_.bodies->time();
        };
        const auto angle = by_length ? entry_by_length(*this, part, task_.bodies->time()) : entry(*this, part, time_at);
        if (!angle || (first && first->along <= *angle)) continue;
        const Vec3 place = place_at(*angle);
        const double turn = 1e-6, t = time_at(*angle);
        const Vec3 earlier = place_at(*angle > turn ? *angle - turn : 0);
        first = BodyHit{*angle, place, part.object, part.cosine(place, earlier - place, t),
                        part.middle ? part.middle(t) : Vec3{0, 0, 0}};
    }
    return first;
}

double PlaneRay::late(double along) const { return metric_.by_proper_length() ? kNotANumber : clock().late(along); }

}  // namespace nullscope::reference
