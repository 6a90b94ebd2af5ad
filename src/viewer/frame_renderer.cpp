#include "viewer/frame_renderer.h"

#include <algorithm>
#include <cmath>

#include "annotate/ticks.h"
#include "render/stage_trial.h"
#include "spacetime/registry.h"
#include "viewer/streamline_layer.h"
#include "viewer/window.h"

namespace nullscope::viewer {
namespace {

constexpr double kAtOnce_ms =
    1e-9;  // of a ray, taken where a picture is no longer than the window may wait: it is one band
constexpr int kLightInMotion_px = 96, kLight_px = 256;  // longest side of the light for telescopes
constexpr double kLeastSide_px = 32.0;                  // of a coarse picture: with less there is nothing to see

// For pictures that follow each other.
void prepare_flight(Renderer& renderer) {
    renderer.keep_finer_sky();
    renderer.follow_camera();
    renderer.limit_tiles_once_built(Tiles::kInterpolated);
}

// What the programs of a job's pictures in motion depend on.
std::pair<EffectSet, Method> motion_kind(const PaintJob& job) {
    return {with_one_ray(effect_set(required_effects(job.scene))), job.method};
}

}  // namespace

FrameRenderer::FrameRenderer() { prepare_flight(renderer_); }

bool FrameRenderer::renderers_build_next() {
    return renderer_.build_next() || (right_ != nullptr && right_->build_next());
}

bool FrameRenderer::build_next() { return renderers_build_next() || (side_b_ != nullptr && side_b_->build_next()); }

void FrameRenderer::warm_up(const PaintJob& job, const TexturesInUse& avoid, const DrawWatch& watch) {
    if (job.side_b != nullptr && side_b_ != nullptr) side_b_->warm_up(*job.side_b, avoid, watch);
    if (is_warm(job) || job.rays) return;
    const double ray_ms = ray_ms_, picture_ms = picture_ms_, compile_ms = compile_ms_;
    const auto half_ray_ms = half_ray_ms_;
    warm_ = motion_kind(job);
    bool warm = static_cast<bool>(prepare(in_motion(job), job, {true, watch.give_up}));
    while (warm && renderers_build_next()) warm = !watch.give_up();
    // As large as can be: what it takes while nothing else is drawn tells how large pictures in motion may be.
    const auto drawn = warm ? one_picture(job, 1.0, true, avoid, watch) : std::nullopt;
    if (!drawn) warm_.reset();
    quiet_ray_ms_ = drawn ? drawn->draw_ms / (static_cast<double>(drawn->width) * drawn->height) : 0.0;
    ray_ms_ = ray_ms, half_ray_ms_ = half_ray_ms, picture_ms_ = picture_ms, compile_ms_ = compile_ms;
}

bool FrameRenderer::is_warm(const PaintJob& job) const { return warm_ == motion_kind(job); }

// Of one ray a pixel; once its programs are there without what more rays on edges need: light is kept, looked at and developed for those, which
// takes as much again as a sky's picture.
Scene FrameRenderer::in_motion(const PaintJob& job) const {
    Scene scene = job.scene;
    scene.picture.samples = 1;
    scene.picture.refine = scene.picture.refine && !is_warm(job);
    return scene;
}

// As ray_picture_ms(), of pictures that were drawn unseen.
double FrameRenderer::quiet_ray_ms(const PaintJob& job) const {
    if (!is_warm(job)) return 0.0;
    if (job.side_b == nullptr) return quiet_ray_ms_;
    const double other = side_b_ != nullptr ? side_b_->quiet_ray_ms(*job.side_b) : 0.0;
    return quiet_ray_ms_ > 0.0 && other > 0.0 ? quiet_ray_ms_ + other : 0.0;
}

// Of a picture in motion, both sides together; 0: not known.
double FrameRenderer::ray_picture_ms(const PaintJob& job) const {
    if (stage_ != job.stage || std::pair(effects_, method_) != motion_kind(job)) return 0.0;
    if (job.side_b == nullptr) return picture_ms_;
    const double other = side_b_ != nullptr ? side_b_->ray_picture_ms(*job.side_b) : 0.0;
    return picture_ms_ > 0.0 && other > 0.0 ? picture_ms_ + other : 0.0;
}

bool FrameRenderer::drafts(const PaintJob& job) const {
    const EffectSet effects = effect_set(required_effects(job.scene));
    return takes_samples(effects) || interpolates_matter(effects) || searches_stars() || shows_streamlines(job.scene) ||
           (job.side_b != nullptr && side_b_ != nullptr && side_b_->drafts(*job.side_b));
}

double FrameRenderer::coarseness(const PaintJob& job) {
    if (!job.coarse_first || job.rays) return 1.0;
    const CameraSpec& camera = job.scene.camera;
    const double pixels = static_cast<double>(camera.width) * camera.height;
    const double times =
        motion_size_.next({ray_picture_ms(job) * pixels / (coarseness_ * coarseness_), quiet_ray_ms(job) * pixels,
                           interpolates_matter(effect_set(required_effects(job.scene)))});
    const double most = std::min(camera.width, camera.height) / kLeastSide_px;
    return coarseness_ = std::clamp(times, 1.0, std::max(most, 1.0));
}

Status FrameRenderer::prepare(const Scene& scene, const PaintJob& job, const StarField::Search& search) {
    renderer_.search_stars(search);
    renderer_.refine(!search.quick);  // by the same programs
    renderer_.draft(search.quick);
    renderer_.set_method(job.method);
    renderer_.set_adaptation(job.adaptation);
    split_ = job.rays ? std::nullopt : halves(scene);
    if (!split_) right_.reset();
    Status ready = renderer_.prepare(split_ ? split_->left : scene);
    const bool compute = ready && stages_.computes(renderer_, job.stage);
    renderer_.compute(compute);
    if (!ready || !split_) return ready;
    if (right_ == nullptr) {
        right_ = std::make_unique<Renderer>();
        prepare_flight(*right_);
    }
    right_->search_stars(search);
    right_->refine(!search.quick);
    right_->draft(search.quick);
    right_->compute(compute);
    // The right half's spacetime may not have the left one's method.
    const SpacetimeSpec& other = split_->right.spacetime;
    const auto spacetime = make_spacetime(other.metric, other.parameters);
    right_->set_method(spacetime && has_method(**spacetime, job.method) ? job.method : Method{});
    return right_->prepare(split_->right);
}

std::optional<DrawTimes> FrameRenderer::draw(const gl::Target& target, bool at_once, const DrawWatch& watch) {
    double least = kAtOnce_ms;
    if (!split_) return draw_in_bands(renderer_, target, at_once ? least : ray_ms_, watch);
    DrawTimes sum;
    int x = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        least = kAtOnce_ms;
        const CameraSpec& camera = (i == 0 ? split_->left : split_->right).camera;
        if (halves_[i].width != camera.width || halves_[i].height != camera.height)
            halves_[i] = gl::make_target(camera.width, camera.height, gl::Format::kRgba8);
        const auto times =
            draw_in_bands(i == 0 ? renderer_ : *right_, halves_[i], at_once ? least : half_ray_ms_[i], watch);
        if (!times) return std::nullopt;
        sum.draw_ms += times->draw_ms, sum.compile_ms += times->compile_ms;
        gl::blit(halves_[i].colours.front().id(), camera.width, camera.height, target.framebuffer.id(), camera.width,
                 camera.height, x);
        x += camera.width;
    }
    gl::finish();
    return sum;
}

std::optional<Painting> FrameRenderer::picture(const PaintJob& job, double coarseness, bool first,
                                               const TexturesInUse& avoid, const DrawWatch& watch) {
    const bool b_in_use = avoid[1] != 0 || avoid[3] != 0;
    if (job.side_b == nullptr && !b_in_use) side_b_.reset();
    auto painting = one_picture(job, coarseness, first, avoid, watch);
    if (!painting || !painting->ready || job.side_b == nullptr) return painting;
    if (side_b_ == nullptr) side_b_ = std::make_unique<FrameRenderer>();
    auto other = side_b_->one_picture(*job.side_b, coarseness, first, avoid, watch);
    if (!other) return std::nullopt;
    if (!other->ready) {
        Error error = other->ready.error();
        error.file = "side B";  // where it is, as a file's name says it
        painting->ready = std::move(error);
        painting->texture = 0;
        return painting;
    }
    painting->texture_b = other->texture;
    painting->stokes_b = std::move(other->stokes);
    painting->draft |= other->draft;
    painting->draw_ms += other->draw_ms;
    return painting;
}

std::optional<Painting> FrameRenderer::one_picture(const PaintJob& job, double coarseness, bool first,
                                                   const TexturesInUse& avoid, const DrawWatch& watch) {
    if (watch.give_up()) return std::nullopt;
    Painting painting;
    painting.job = job;
    Scene scene = first ? in_motion(job) : job.scene;
    scene.camera.width = painting.width = static_cast<int>(std::lround(scene.camera.width / coarseness));
    scene.camera.height = painting.height = static_cast<int>(std::lround(scene.camera.height / coarseness));
    watch.tell({PaintProgress::Stage::kPreparing, 0, painting.height});
    painting.ready = prepare(scene, job, {first, watch.give_up});
    if (watch.give_up()) return std::nullopt;
    if (painting.ready) {
        painting.draft = first && drafts(job);
        const EffectSet effects = with_one_ray(renderer_.tables().effects());
        const bool compute = renderer_.computed().draws();
        if (effects != effects_ || job.method != method_ || compute != computes_) ray_ms_ = 0.0, half_ray_ms_ = {};
        effects_ = effects, method_ = job.method, stage_ = job.stage, computes_ = compute;
        const gl::Target& drawn = target(painting.width, painting.height, avoid);
        const double expected_ms = picture_ms_ * painting.width * painting.height;
        const auto times = draw(drawn, first && expected_ms > 0.0 && expected_ms <= kMotionInMatter_ms, watch);
        if (!times) return std::nullopt;
        painting.draw_ms = times->draw_ms;
        compile_ms_ += times->compile_ms;
        const int samples = scene.picture.samples;
        if (first || !renderer_.tables().effects().contains(Effect::kRefine))  // of pictures in motion
            picture_ms_ = times->draw_ms / (static_cast<double>(painting.width) * painting.height * samples * samples);
        painting.texture = drawn.colours.front().id();
        if (!painting.coarse() && shows_streamlines(job.scene)) {
            if (watch.give_up()) return std::nullopt;
            lay_streamlines(renderer_, job.scene, drawn);
        }
        if (job.scene.picture.ticks && is_polarised(job.scene) && !split_) painting.stokes = tick_stokes(job.scene);
        if (job.light)
            painting.light = light_.draw(job, first ? kLightInMotion_px : kLight_px, {first, watch.give_up});
        else
            light_.drop();
    }
    add_facts(painting);
    return painting;
}

bool FrameRenderer::asks_to_try_stages(const PaintJob& job) const {
    return !job.rays && !split_ && stages_.asks(renderer_, job.stage);
}

// As in motion: what a scene takes matters there.
bool FrameRenderer::try_stages(const PaintJob& job, const DrawWatch& watch) {
    const Scene scene = in_motion(job);
    if (watch.give_up() || !prepare(scene, job, {true, watch.give_up}) || !asks_to_try_stages(job)) return false;
    const gl::Target drawn = gl::make_target(scene.camera.width, scene.camera.height, gl::Format::kRgba8);
    std::array<double, 2> ray_ms{};
    const auto trial = nullscope::try_stages(renderer_, [&]() -> std::optional<double> {
        const auto times = draw_in_bands(renderer_, drawn, ray_ms[renderer_.computed().draws() ? 1 : 0], watch);
        return times ? std::optional(times->draw_ms) : std::nullopt;
    });
    if (!trial) return false;
    stages_.take(renderer_, *trial);
    stages_.computes(renderer_, job.stage);  // says it
    return true;
}

// In motion too: as many pixels as there are ticks.
Image<float> FrameRenderer::tick_stokes(const Scene& scene) {
    if (!renderer_.prepare(tick_scene(scene, scene.camera.width, scene.camera.height))) return {};
    return draw_stokes(renderer_);
}

Painting FrameRenderer::rays(const PaintJob& job) {
    Painting painting;
    painting.job = job;
    painting.ready = prepare(job.scene, job, {});
    if (painting.ready) painting.rays = renderer_.ray_data();
    if (painting.ready && job.side_b != nullptr) {
        if (side_b_ == nullptr) side_b_ = std::make_unique<FrameRenderer>();
        painting.rays_b = side_b_->rays(*job.side_b).rays;
    }
    add_facts(painting);
    return painting;
}

void FrameRenderer::add_facts(Painting& painting) {
    painting.notes = renderer_.take_notes();
    painting.programs = renderer_.picture_programs();
    painting.compile_ms = compile_ms_;
    painting.table_ms = renderer_.tables().path().table_ms;
    painting.rows_ms = renderer_.tables().path().rows_ms;
}

const gl::Target& FrameRenderer::target(int width, int height, const TexturesInUse& avoid) {
    gl::Target* free = nullptr;
    for (gl::Target& each : targets_) {
        const unsigned id = each.colours.empty() ? 0 : each.colours.front().id();
        if (id != 0 && std::find(avoid.begin(), avoid.end(), id) != avoid.end()) continue;
        if (id != 0 && each.width == width && each.height == height) return each;
        if (free == nullptr || id == 0) free = &each;
    }
    *free = gl::make_target(width, height, gl::Format::kRgba8);
    return *free;
}

}  // namespace nullscope::viewer
