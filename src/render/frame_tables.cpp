#include "render/frame_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "render/frame_numbers.h"
#include "scene/pixel_angle.h"
#include "scene/sides.h"
#include "table/star_lens.h"

namespace nullscope {
namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Status FrameTables::update(const Scene& scene) {
    bool rows_stale = false;
    if (spacetime_ == nullptr || !(spec_ == scene.spacetime) || lensing_ != scene.light.lensing) {
        auto made = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
        if (!made) return made.error();
        matter_ = *made;
        spacetime_ = scene.light.lensing ? matter_ : *make_spacetime("minkowski", {});
        spec_ = scene.spacetime;
        lensing_ = scene.light.lensing;
        table_.reset();
        if (spacetime_->photon_sphere()) {
            const auto start = std::chrono::steady_clock::now();
            table_ = std::make_shared<DeflectionTable>(*spacetime_);
            table_ms_ = milliseconds_since(start);
        }
        rows_stale = true;
    }
    const auto observer = observer_of(*matter_, scene.camera);
    if (!observer) return observer.error();
    if (Status parts = check_light_parts(*matter_, scene); !parts) return parts.error();
    EffectSet wanted = effect_set(required_effects(scene));
    if (Status bodies = check_sides(*matter_, scene); !bodies) return bodies.error();
    if ((wanted.contains(Effect::kDisc) && !matter_->can_have_disc()) ||
        (has_solids(wanted) && !matter_->can_have_bodies()))
        return bad_input(fmt::format("metric \"{}\" has neither discs nor bodies; allowed: a scene without them",
                                     scene.spacetime.metric));
    // Ray data have delays wherever the shader can tell them.
    const bool straight = !wanted.contains(Effect::kLensing) && !wanted.contains(Effect::kSpin),
               known = straight || spacetime_->spin() != 0.0 || spacetime_->lapse_roots();
    if (delays_wanted_ && known) wanted.insert(Effect::kDelay);
    if (wanted.contains(Effect::kDelay) && !known) wanted.erase(Effect::kDelay);
    if (wanted.contains(Effect::kDelay) && !straight && spacetime_->has_inner_horizon())
        wanted.insert(Effect::kInnerHorizon);
    const auto orbits_of = [](const EffectSet& effects) {
        return meets_objects(effects) || effects.contains(Effect::kDelay);
    };
    const bool orbits = orbits_of(wanted), had_orbits = orbits_of(effects_);
    const bool delays = wanted.contains(Effect::kDelay), had_delays = effects_.contains(Effect::kDelay);
    const bool points = wanted.contains(Effect::kPointStars), had_points = effects_.contains(Effect::kPointStars);
    rows_stale = rows_stale || radius_ != scene.camera.r || !(frame_ == observer->frame) || (orbits && !had_orbits) ||
                 (delays && !had_delays) || (points && !had_points) ||
                 (fan_ && fan_->w0() != fan_for(scene, *observer).w0());
    effects_ = wanted;
    ball_path_.reset();
    if (wanted.contains(Effect::kBallPath)) {
        auto path = nullscope::ball_path(*matter_, scene);
        if (!path) return path.error();
        ball_path_ = std::move(*path);
    }
    if (((!orbits && had_orbits) || (!delays && had_delays) || (!points && had_points)) &&
        !rows_stale) {  // what nothing calls for any more goes, the strip stays
        if (!orbits) orbit_map_ = {};
        if (!delays) orbit_map_.delays = {};
        if (!points) star_lens_ = {};
        ++revision_;
    }
    if (!rows_stale) return Done{};
    radius_ = scene.camera.r;
    frame_ = observer->frame;
    fan_.reset();
    strip_ = {};
    orbit_map_ = {};
    star_lens_ = {};
    ++revision_;
    if (!effects_.contains(Effect::kLensing)) return Done{};
    const auto start = std::chrono::steady_clock::now();
    fan_ = fan_for(scene, *observer);
    strip_ = build_strip(*fan_);
    if (orbits) orbit_map_ = build_orbit_map(*fan_, delays);
    if (points) star_lens_ = star_lens_row(*fan_);
    rows_ms_ = milliseconds_since(start);
    return Done{};
}

RayFan FrameTables::fan_for(const Scene& scene, const Observer& observer) const {
    const double speed = scene.light.aberration ? length(observer.velocity) : 0.0,
                 squeeze = std::sqrt((1.0 - speed) / (1.0 + speed));
    return {spacetime_, table_, scene.camera.r, observer.frame, squeeze * smallest_pixel_angle(scene.camera)};
}

CoreInput FrameTables::core_input(const Scene& scene) const {
    CoreInput input;
    input.frame = frame_numbers(scene, *spacetime_, fan(), {}, &*matter_, ball_path());
    input.strip = strip_.sky.view();
    input.ends = strip_.ends.view();
    input.orbit = orbit_map_.places.view();
    input.delay = orbit_map_.delays.view();
    input.lensing = effects_.contains(Effect::kLensing);
    input.spin = effects_.contains(Effect::kSpin);
    input.spin_fall = effects_.contains(Effect::kSpinFall);
    input.spin_delay = input.spin && effects_.contains(Effect::kDelay);
    input.aberration = effects_.contains(Effect::kAberration);
    return input;
}

}  // namespace nullscope
