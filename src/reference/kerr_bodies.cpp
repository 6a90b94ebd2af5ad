#include "reference/kerr_bodies.h"

#include <algorithm>
#include <cmath>

namespace nullscope::reference {
namespace {

constexpr double kPartOfThinnestBody = 0.2;  // of a body's smallest extent between two looks, where it can be met
constexpr double kPartOfWay = 0.5;           // of the way to where it can be met, elsewhere
constexpr double kAim = 0.9;                 // of the longest step: what the last one says of the next is so good
constexpr double kBack = 1e-4;               // of a radius: over which the ray's direction is taken, to second order
constexpr int kMostKerrSamples = 200'000;    // a ray

}  // namespace

BodyWatch::BodyWatch(const Bodies& bodies, bool delay) : bodies_(bodies), delay_(delay) {
    for (const BodyPart& part : bodies.parts()) tracks_.push_back({&part});
}

KerrWatch BodyWatch::watch() {
    if (bodies_.empty()) return {};
    return [this](const KerrStep& step) { see(step); };
}

// A dip that begins in one step and ends in the next may lie before what another body was met at: one more step is looked at.
void BodyWatch::see(const KerrStep& step) {
    if (hit_ && previous_ && hit_->along < previous_->from) return;
    for (Track& track : tracks_) follow(track, step);
    previous_ = step;
}

// Of place, and of light's time where the body moves: none moves faster than light.
double BodyWatch::way(const BodyPart& part, const KerrPlace& from, const KerrPlace& to) const {
    return way_between(from, to) + (part.moves && delay_ ? std::abs(to.delay - from.delay) : 0.0);
}

void BodyWatch::follow(Track& track, const KerrStep& step) {
    const BodyPart& part = *track.part;
    const double fine = kPartOfThinnestBody * part.thinnest,
                 rim = part.reach * 1.001 + 3 * fine;  // a sample beyond every dip
    if (step.nearest > rim) {
        track.here.reset(), track.before.reset();
        return;
    }
    if (!track.here) track.here = PlacedLook{{step.from, value_of(part, step.begin)}, step.begin};
    double turn = step.to - step.from, went = way(part, step.begin, step.end);  // what the next step is aimed by
    while (track.here->along < step.to && track.looks < kMostKerrSamples) {
        if (hit_ && track.before && hit_->along < track.before->along) return;
        const PlacedLook& here = *track.here;
        const double clear = part.clear ? here.value : kPartOfWay * (here.place.r - part.reach),
                     longest = std::max(fine, clear);
        if (went > kAim * longest)
            turn *= kAim * longest / went;
        else
            turn = std::min(2 * turn, turn * kAim * longest / std::max(went, 1e-3 * longest));
        const double next = here.along + turn < step.to ? here.along + turn : step.to;
        turn = next - here.along;
        if (!(turn > 0)) break;
        const KerrPlace place = next == step.to ? step.end : step.between(next);
        ++track.looks;
        went = way(part, here.place, place);
        if (went > longest && here.along + 0.5 * turn > here.along) continue;
        const PlacedLook there{{next, value_of(part, place)}, place};
        if (const auto along = entry(track, there, step)) meet(part, *along, step);
        track.before = track.here, track.here = there;
    }
}

// Where between the sample before the last one and this one the ray enters.
std::optional<double> BodyWatch::entry(const Track& track, const PlacedLook& there, const KerrStep& step) const {
    const BodyPart& part = *track.part;
    const PlacedLook &here = *track.here, &before = track.before ? *track.before : here;
    if (part.clear && there.value > 0 &&
        here.value > std::max(way(part, before.place, here.place), way(part, here.place, there.place)))
        return std::nullopt;
    return entry_between([&](double along) { return value_of(part, place_at(along, step)); }, before, here, there);
}

void BodyWatch::meet(const BodyPart& part, double along, const KerrStep& step) {
    if (hit_ && hit_->along <= along) return;
    const KerrPlace at = along < step.from && previous_ ? previous_->at(along) : step.at(along);
    const double whole = way_between(step.begin, step.end), first = kBack * (step.to - step.from),
                 moves = way_between(place_at(along - first, step), at),
                 h = whole > 0 && moves > 0 ? kBack * at.r * first / moves : 0;
    const Vec3 place = at.flat(),
               back = 4 * (place_at(along - h, step).flat() - place) - (place_at(along - 2 * h, step).flat() - place);
    const double t = time_at(part, at);
    const Vec3 normal = part.normal(place, t);
    hit_ = BodyHit{along,
                   place,
                   part.number,
                   part.body,
                   normal,
                   cosine_between(normal, back),
                   part.middle ? part.middle(t) : Vec3{0, 0, 0},
                   at.delay,
                   back};
    part.tell(*hit_, t);
}

}  // namespace nullscope::reference
