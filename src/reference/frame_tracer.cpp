#include "reference/frame_tracer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "observer/observer.h"
#include "observer/pose.h"
#include "observer/ring_view.h"
#include "plan/glow.h"
#include "plan/medium.h"
#include "plan/moving.h"
#include "plan/sides.h"
#include "reference/reference.h"
#include "scene/disc_shape.h"
#include "scene/leaning_disc.h"
#include "scene/projection.h"
#include "spacetime/registry.h"

namespace nullscope::reference {
namespace {

// Of a ray that is integrated: each half turn nearer to the critical ray brings one more.
constexpr int kMostCrossings = 16;

double finite_or_zero(double value) { return std::isfinite(value) ? value : 0.0; }

Status check_disc(const DiscSpec& disc) {
    if (!(disc.inner > 0 && disc.inner < disc.outer && std::isfinite(disc.outer)))
        return bad_input(
            fmt::format("disc: 0 < inner < outer is required, not inner = {}, outer = {}", disc.inner, disc.outer));
    if (!(disc.opacity >= 0 && disc.opacity <= 1))
        return bad_input(fmt::format("disc: opacity = {} must lie in [0, 1]", disc.opacity));
    return Done{};
}

// Of bodies in this metric.
Status check_there(const Spacetime& spacetime, const Scene& scene) {
    Status sides = check_sides(spacetime, scene);
    return sides ? check_glow(spacetime, scene) : sides;
}

std::shared_ptr<const DiscShape> shared_shape(const Scene& scene) {
    return disc_warps(scene) ? std::make_shared<const DiscShape>(*scene.disc, scene.time) : nullptr;
}

}  // namespace

Result<FrameTracer> FrameTracer::make(const Scene& given) {
    TRY(spacetime, make_spacetime(given.spacetime.metric, given.spacetime.parameters));
    TRY(plain, without_zoom(**spacetime, given.camera, given.light));
    Scene scene = given;
    scene.camera = *plain;
    FrameTracer tracer;
    tracer.camera_ = scene.camera;
    tracer.disc_ = scene.disc, tracer.plane_ = disc_plane_of(scene), tracer.shape_ = shared_shape(scene);
    const CameraSpec& camera = scene.camera;
    if (camera.width < 1 || camera.height < 1)
        return bad_input(fmt::format("camera: size {}x{} must be at least 1x1", camera.width, camera.height));
    if (!(camera.theta >= 0 && camera.theta <= M_PI && std::isfinite(camera.phi)))
        return bad_input(
            fmt::format("camera: theta = {} must lie in [0, pi] and phi = {} be finite", camera.theta, camera.phi));
    if (Status ok = scene.disc ? check_disc(*scene.disc) : Done{}; !ok) return ok.error();
    TRY(metric, make_metric(scene.spacetime));
    if (Status followed = check_bodies(scene, **metric); !followed) return followed.error();
    if (Status bodies = check_there(**spacetime, scene); !bodies) return bodies.error();
    if (const auto observer = observer_of(**spacetime, camera); !observer) return observer.error();
    if (Status parts = check_light_parts(**spacetime, scene); !parts) return parts.error();
    if (scene.disc && !(*spacetime)->can_have_disc())
        return bad_input(fmt::format("metric \"{}\" has no discs", scene.spacetime.metric), "a scene without [disc]");
    tracer.matter_ = std::move(*metric);
    if (Status medium = check_medium(**spacetime, scene); !medium) return medium.error();
    if (Status read = scene.medium ? read_matter(**spacetime, scene) : Done{}; !read) return read.error();
    if (scene.picture.polariser && has_polarised_disc(scene))
        return bad_input("picture.polariser: the reference draws no polarised disc through one",
                         "a scene without a polariser, or disc.polarisation = \"off\"");
    const bool polarised = has_polarised_medium(scene);
    if (polarised && (scene.disc || !scene.bodies.empty() || (*spacetime)->inner_end() == InnerEnd::kSurface))
        return bad_input("medium.polarisation: the reference polarises matter before a sky alone",
                         "a scene without disc and bodies, or polarisation = \"off\"");
    if (polarised) {
        TRY(stokes, MatterStokes::make(scene));
        TRY(axes, stokes->axes_of(camera));
        tracer.stokes_ = std::make_shared<const MatterStokes>(std::move(*stokes));
        tracer.axes_ = *axes;
    } else if (scene.medium) {
        tracer.medium_ = std::make_shared<Medium>(scene, *tracer.matter_);
    }
    tracer.bodies_ = std::make_shared<Bodies>(scene, *tracer.matter_);
    const bool late = scene.light.delay && !moving_parts(scene).empty(),
               disc_moves = scene.disc && (!scene.spots.empty() || scene.disc->flow != DiscFlowKind::kStill);
    RayTask task{tracer.bodies_.get(), late, late && disc_moves, scene.disc ? kMostCrossings : 0};
    task.plane = tracer.plane_, task.shape = tracer.shape_.get();
    TRY(rays, tracer.matter_->rays(scene, **spacetime, task));
    tracer.rays_ = tracer.bare_rays_ = std::move(*rays);
    if (tracer.medium_) {
        task.medium = tracer.medium_.get();
        TRY(through_matter, tracer.matter_->rays(scene, **spacetime, task));
        tracer.rays_ = std::move(*through_matter);
    }
    tracer.many_rays_ = tracer.rays_;
    if (scene.sky.kind == SkyKind::kPoints && task.delays_disc) {
        task.many = true;
        TRY(many, tracer.matter_->rays(scene, **spacetime, task));
        tracer.many_rays_ = std::move(*many);
    }
    return tracer;
}

RayPtr FrameTracer::ray(double x, double y) const { return rays_->ray(pixel_direction(camera_, x, y)); }

void FrameTracer::stretches(double x, double y, double energy, const StretchWatch& watch) const {
    rays_->stretches(pixel_direction(camera_, x, y), energy, watch);
}

RayPtr FrameTracer::ray_of_many(double x, double y) const { return many_rays_->ray(pixel_direction(camera_, x, y)); }

std::optional<RayStokes> FrameTracer::stokes(double x, double y) const {
    if (!stokes_) return std::nullopt;
    return stokes_->at(axes_, normalized(pixel_direction(camera_, x, y)));
}

std::vector<Vec3> FrameTracer::directions(const std::vector<std::array<double, 2>>& positions) const {
    std::vector<Vec3> found;
    found.reserve(positions.size());
    for (const auto& [x, y] : positions) found.push_back(pixel_direction(camera_, x, y));
    return found;
}

std::vector<RayPtr> FrameTracer::rays(const std::vector<std::array<double, 2>>& positions) const {
    return rays_->rays(directions(positions));
}

std::vector<DiscHit> FrameTracer::disc_hits(const TracedRay& ray, int max_hits) const {
    std::vector<DiscHit> hits;
    if (!disc_) return hits;
    for (const PlaneCrossing& c : ray.crossings(shape_ ? kMostCrossings : max_hits, disc_->inner, disc_->outer)) {
        if (shape_ && !(shape_->within(c.r) >= 0)) continue;
        if (static_cast<int>(hits.size()) == max_hits) break;
        hits.push_back(
            {c.along, c.r * std::cos(c.bearing), c.r * std::sin(c.bearing), c.climb, c.delay, c.l, c.cosine, c.across});
    }
    return hits;
}

RayPixel FrameTracer::pixel(double x, double y, bool with_delay) const {
    if (!shows(camera_, x, y)) return {};
    return pixel_of(*bare_rays_->ray(pixel_direction(camera_, x, y)), with_delay);
}

std::vector<RayPixel> FrameTracer::pixels(const std::vector<std::array<double, 2>>& positions, bool with_delay) const {
    std::vector<RayPixel> pixels(positions.size());
    std::vector<std::size_t> places;
    std::vector<std::array<double, 2>> together;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (shows(camera_, positions[i][0], positions[i][1])) places.push_back(i), together.push_back(positions[i]);
        if (together.size() < kRaysTogether && i + 1 < positions.size()) continue;
        const std::vector<RayPtr> traced = bare_rays_->rays(directions(together));
        for (std::size_t k = 0; k < traced.size(); ++k) pixels[places[k]] = pixel_of(*traced[k], with_delay);
        places.clear(), together.clear();
    }
    return pixels;
}

RayPixel FrameTracer::pixel_of(const TracedRay& traced, bool with_delay) const {
    RayPixel pixel;
    double end = traced.end();
    pixel.fate = traced.fate();
    pixel.g = traced.g > 0 && std::isfinite(traced.g) ? traced.g
                                                      : 0;  // light of no positive energy has no frequency at infinity
    if (pixel.fate == Fate::kHit) {                         // a star
        const Vec3 place = traced.end_direction();
        pixel.hit = kStarHit;
        pixel.u = std::atan2(place.y, place.x);
        pixel.v = std::atan2(place.z, std::hypot(place.x, place.y));
    }
    const std::vector<DiscHit> hits = disc_hits(traced, 1);
    const std::optional<BodyHit> body = traced.first_hit();
    if (body) {  // solid: it ends the ray, whatever a translucent disc before it
        pixel.fate = Fate::kHit;
        end = body->along;
        pixel.hit = body->number;
        pixel.u = body->place.x, pixel.v = body->place.y, pixel.w = body->place.z;
    }
    if (!hits.empty() && !(body && body->along < hits.front().along)) {
        pixel.hit = kDiscHit;
        const double x = hits.front().x, y = hits.front().y;
        const Vec3 place = (shape_ ? shape_->plane(std::hypot(x, y)) : plane_).place(x, y);
        pixel.u = place.x, pixel.v = place.y, pixel.w = place.z;
        if (disc_->opacity == 1) {
            pixel.fate = Fate::kHit;
            end = hits.front().along;
        }
    }
    pixel.angle = finite_or_zero(traced.swept(end));
    if (pixel.fate == Fate::kEscaped || pixel.fate == Fate::kOtherSide) {
        pixel.sky = traced.end_direction();
        if (with_delay) pixel.delay = finite_or_zero(traced.delay());
    }
    if (with_delay && pixel.fate == Fate::kHit && pixel.hit != kStarHit)
        pixel.delay = finite_or_zero(traced.delay(end));
    // In a wormhole's tube rays wind without end.
    pixel.order = static_cast<int>(std::min(std::floor(pixel.angle / M_PI), 1e9));
    return pixel;
}

Result<RayFrame> trace_frame(const Scene& scene, const std::function<void(long long)>& done) {
    TRY(tracer, FrameTracer::make(scene));
    const int width = scene.camera.width, height = scene.camera.height;
    RayFrame frame{width, height, std::vector<RayPixel>(static_cast<std::size_t>(width) * height)};
    tbb::parallel_for(0, height, [&](int y) {
        for (int from = 0; from < width; from += kRaysTogether) {
            std::vector<std::array<double, 2>> positions;
            for (int x = from; x < std::min(from + kRaysTogether, width); ++x) positions.push_back({x + 0.5, y + 0.5});
            std::ranges::copy(tracer->pixels(positions),
                              frame.pixels.data() + static_cast<std::size_t>(y) * width + from);
        }
        if (done) done(width);
    });
    return frame;
}

Result<std::vector<RayPixel>> trace_pixels(const Scene& scene, const std::vector<std::array<double, 2>>& positions,
                                           bool with_delay) {
    TRY(tracer, FrameTracer::make(scene));
    for (const auto& [x, y] : positions)
        if (!std::isfinite(x) || !std::isfinite(y)) return bad_input("pixel positions must be finite");
    constexpr std::size_t kTogether = kRaysTogether;
    std::vector<RayPixel> pixels(positions.size());
    tbb::parallel_for(std::size_t{0}, (positions.size() + kTogether - 1) / kTogether, [&](std::size_t part) {
        const auto from = positions.begin() + static_cast<std::ptrdiff_t>(part * kTogether),
                   to = positions.begin() +
                        static_cast<std::ptrdiff_t>(std::min((part + 1) * kTogether, positions.size()));
        std::ranges::copy(tracer->pixels({from, to}, with_delay), pixels.data() + part * kTogether);
    });
    return pixels;
}

}  // namespace nullscope::reference
