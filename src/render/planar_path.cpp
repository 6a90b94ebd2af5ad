#include "render/planar_path.h"

#include <fmt/format.h>

#include <cmath>

#include "base/stopwatch.h"
#include "scene/projection.h"
#include "spacetime/tortoise.h"
#include "table/critical_images.h"
#include "table/star_lens.h"

namespace nullscope {
namespace {

PlanarPath::Rows rows_of(const EffectSet& effects) {
    const bool delays = effects.contains(Effect::kLightTimes);
    return {{meets_objects(effects) || delays, delays}, effects.contains(Effect::kPointStars)};
}

// Roots of A, and the camera's part of light times, of rays to the sky and of others (planar/delay.glsl).
FrameVector delay_numbers(const CameraSpec& camera, const SphericalMetric& metric) {
    const auto roots = metric.lapse_roots();
    if (!roots) return {0, 0, 0, 0};
    if (camera.r <= roots->outer) return {roots->outer, roots->inner, 0, 0};  // only the sky's light is seen inside
    const double ahead = time_ahead(metric, camera.r);
    // Scene::time of a camera that falls is v - r.
    return {roots->outer, roots->inner, falls(camera) ? 0.0 : ahead, falls(camera) ? -2.0 * ahead : -ahead};
}

// How much wider an angle of the camera's is to an observer who does not move, at most; at least it is as much narrower.
double stretch_of(const FramePlan& plan) {
    const double speed = plan.scene.light.aberration ? length(plan.observer.velocity) : 0.0;
    return std::sqrt((1.0 + speed) / (1.0 - speed));
}

// As an observer sees it that does not move, rad.
double smallest_pixel(const FramePlan& plan) { return smallest_pixel_angle(plan.scene.camera) / stretch_of(plan); }

// From the line of sight, with room for pixels beside the picture; likewise.
double farthest_pixel(const FramePlan& plan) {
    constexpr double kRoom = 1.25;
    return std::min(kRoom * stretch_of(plan) * reach_angle(plan.scene.camera), M_PI);
}

}  // namespace

PlanarPath::PlanarPath(std::shared_ptr<const SphericalMetric> metric) : metric_(std::move(metric)) {
    if (metric_->chi() == nullptr) return;
    const Stopwatch watch;
    table_ = std::make_shared<DeflectionTable>(*metric_);
    table_ms = watch.ms();
}

bool PlanarPath::update(const FramePlan& plan) {
    const CameraSpec& camera = plan.scene.camera;
    const Rows wanted = rows_of(plan.effects), had = rows_;
    const bool stale = !family_ || family_->camera_r() != camera.r || !(family_->frame() == plan.observer.frame) ||
                       (wanted.tables.orbits && !had.tables.orbits) || (wanted.tables.delays && !had.tables.delays) ||
                       (wanted.points && !had.points) || !family_->same_cells(camera_family(plan));
    rows_ = wanted;
    if (stale) {
        build(plan);
        return true;
    }
    // What nothing calls for any more goes, the strip stays.
    if (!wanted.tables.orbits) tables_.orbits = {};
    if (!wanted.tables.delays) tables_.orbits.delays = {};
    if (!wanted.points) star_lens_ = {};
    return wanted != had;
}

void PlanarPath::build(const FramePlan& plan) {
    const Stopwatch watch;
    family_.emplace(camera_family(plan));
    if (!follows_camera || plan.ring)
        steps_.reset();
    else if (!steps_)
        steps_.emplace(metric_, table_);
    auto between = steps_ ? steps_->tables(*family_, smallest_pixel(plan), rows_.tables) : std::nullopt;
    tables_ = between ? std::move(*between) : build_camera_tables(*family_, rows_.tables);
    // The star lens knows no zoom: images come from all directions.
    star_lens_ = rows_.points
                     ? star_lens_row({metric_, table_, plan.scene.camera.r, plan.observer.frame, smallest_pixel(plan)})
                     : TexelGrid{};
    rows_ms = watch.ms();
}

RayFamily PlanarPath::camera_family(const FramePlan& plan) const {
    return {metric_,
            table_,
            plan.scene.camera.r,
            plan.observer.frame,
            smallest_pixel(plan),
            plan.ring ? std::optional(farthest_pixel(plan)) : std::nullopt};
}

void PlanarPath::write(const FramePlan& plan, FrameData& frame) const {
    const bool comes_back = metric_->inner_end() == InnerEnd::kSameSky;
    const auto series = table_ ? table_->series() : DeflectionTable::Series{};
    const int sky = family_->octaves(Segment::kSky), captured = sky + family_->octaves(Segment::kCaptured);
    frame.strip = {family_->critical_cosine(), family_->critical_sine(), 1.0 / family_->w0(), static_cast<double>(sky)};
    frame.orbit = {std::sin(family_->critical_angle()), std::cos(family_->chi0()), series.a0, series.a1};
    frame.series = {series.a2, family_->chi0(), static_cast<double>(comes_back ? captured : 0),
                    comes_back ? std::tan(0.25 * family_->critical_angle()) : 0};
    if (const auto& disc = plan.scene.disc) {
        const CriticalImages images = critical_images(*family_, disc->inner, disc->outer);
        frame.critical = {images.inner, images.outer, images.per_angle * M_LOG2E, images.from_angle};
        if (plan.ring) frame.ring.w = angle_about_disc(*family_, disc->inner, disc->outer);
        frame.critical_bend = {images.inner_bend.constant, images.inner_bend.logarithm, images.outer_bend.constant,
                               images.outer_bend.logarithm};
    }
    frame.delay = delay_numbers(plan.scene.camera, *metric_);
    if (metric_->by_proper_length())
        frame.throat = {metric_->length_unit(), metric_->logarithm_length() / metric_->length_unit(), 0, 0};
}

void PlanarPath::give(const FramePlan&, CoreInput& input) const {
    input.lensing = true;
    input.strip = tables_.strip.sky.view();
    input.ends = tables_.strip.ends.view();
    input.orbit = tables_.orbits.places.view();
    input.delay = tables_.orbits.delays.view();
}

std::vector<NamedTexels> PlanarPath::tables() const {
    std::vector<NamedTexels> list;
    for (const NamedTexels& one : {NamedTexels{"strip", &tables_.strip.sky},
                                   {"ray ends", &tables_.strip.ends},
                                   {"star lens", &star_lens_},
                                   {"orbit table", &tables_.orbits.places},
                                   {"light-time table", &tables_.orbits.delays}})
        if (one.texels->width > 0) list.push_back(one);
    return list;
}

Status PlanarPath::check(const Method& method, const FramePlan& plan) const {
    if (counts_steps(method)) return rotating_only(method);
    if (family_->frame().infall() > 0.0 && method.kind != MethodKind::kStrip)
        return bad_input(fmt::format("camera.observer = \"{}\" works only with method strip",
                                     observer_name(plan.scene.camera.observer)),
                         "--method strip or auto, or a static observer");
    if (has_method(*metric_, method)) return Done{};
    return bad_input(
        fmt::format("method {} does not work for metric \"{}\"", method_name(method), plan.scene.spacetime.metric),
        fmt::format("{}", methods_of(*metric_)));
}

}  // namespace nullscope
