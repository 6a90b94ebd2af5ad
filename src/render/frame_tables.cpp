#include "render/frame_tables.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "render/frame_numbers.h"
#include "scene/pixel_angle.h"
#include "table/star_lens.h"

namespace nullscope {
namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// What of the rows an effect set asks for.
struct Rows {
    bool orbits, delays, points;
};
Rows rows_of(const EffectSet& effects) {
    const bool delays = effects.contains(Effect::kDelay);
    return {meets_objects(effects) || delays, delays, effects.contains(Effect::kPointStars)};
}

}  // namespace

Status FrameTables::update(const Scene& scene) {
    auto planned = plan_frame(scene, delays_wanted_, plan_.light != nullptr ? &plan_ : nullptr);
    if (!planned) return planned.error();
    std::optional<BallPath> path;
    if (planned->effects.contains(Effect::kBallPath)) {
        auto made = nullscope::ball_path(*planned->matter, scene);
        if (!made) return made.error();
        path = std::move(*made);
    }
    ball_path_ = std::move(path);
    const FramePlan before = std::exchange(plan_, std::move(*planned));
    bool stale = before.light != plan_.light;
    if (stale) {
        table_.reset();
        if (plan_.light->photon_sphere()) {
            const auto start = std::chrono::steady_clock::now();
            table_ = std::make_shared<DeflectionTable>(*plan_.light->spherical());
            table_ms_ = milliseconds_since(start);
        }
    }
    const Rows wanted = rows_of(plan_.effects), had = rows_of(before.effects);
    stale = stale || before.scene.camera.r != scene.camera.r || !(before.observer.frame == plan_.observer.frame) ||
            (wanted.orbits && !had.orbits) || (wanted.delays && !had.delays) || (wanted.points && !had.points) ||
            (fan_ && fan_->w0() != camera_fan().w0());
    if (stale) {
        build_rows();
        return Done{};
    }
    // What nothing calls for any more goes, the strip stays.
    if ((!wanted.orbits && had.orbits) || (!wanted.delays && had.delays) || (!wanted.points && had.points)) {
        if (!wanted.orbits) orbit_map_ = {};
        if (!wanted.delays) orbit_map_.delays = {};
        if (!wanted.points) star_lens_ = {};
        ++revision_;
    }
    return Done{};
}

void FrameTables::build_rows() {
    fan_.reset();
    strip_ = {};
    orbit_map_ = {};
    star_lens_ = {};
    ++revision_;
    if (!plan_.effects.contains(Effect::kLensing)) return;
    const Rows wanted = rows_of(plan_.effects);
    const auto start = std::chrono::steady_clock::now();
    fan_ = camera_fan();
    strip_ = build_strip(*fan_);
    if (wanted.orbits) orbit_map_ = build_orbit_map(*fan_, wanted.delays);
    if (wanted.points) star_lens_ = star_lens_row(*fan_);
    rows_ms_ = milliseconds_since(start);
}

RayFan FrameTables::camera_fan() const {
    const CameraSpec& camera = plan_.scene.camera;
    const double speed = plan_.scene.light.aberration ? length(plan_.observer.velocity) : 0.0,
                 squeeze = std::sqrt((1.0 - speed) / (1.0 + speed));
    return {{plan_.light, plan_.light->spherical()},
            table_,
            camera.r,
            plan_.observer.frame,
            squeeze * smallest_pixel_angle(camera)};
}

CoreInput FrameTables::core_input() const {
    const EffectSet& effects = plan_.effects;
    CoreInput input;
    input.frame = frame_numbers(plan_, fan(), {}, ball_path());
    input.strip = strip_.sky.view();
    input.ends = strip_.ends.view();
    input.orbit = orbit_map_.places.view();
    input.delay = orbit_map_.delays.view();
    input.lensing = effects.contains(Effect::kLensing);
    input.spin = effects.contains(Effect::kSpin);
    input.spin_fall = effects.contains(Effect::kSpinFall);
    input.spin_delay = input.spin && effects.contains(Effect::kDelay);
    input.aberration = effects.contains(Effect::kAberration);
    return input;
}

}  // namespace nullscope
