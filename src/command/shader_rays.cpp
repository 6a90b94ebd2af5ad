#include "command/shader_rays.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "command/session.h"
#include "observer/observer.h"
#include "reference/ray_plane.h"
#include "render/frame_tables.h"
#include "spacetime/spherical_metric.h"

namespace nullscope::cli {
namespace {

constexpr std::size_t kBatch = 1024;  // rays traced between two reports of progress; bounds what is held of views

// A ray as the shader core takes it: an observer and a view direction.
struct Start {
    double r, theta, phi;
    Vec3 n;
    ObserverKind observer = ObserverKind::kStatic;
};

// The direction in the rain frame of the ray with this q that is traced outward: t = tan(alpha/2) = outward/(R (q + sqrt(q^2 - V)))
// (table/ray_family.h).
Vec3 rain_direction(const Spacetime& spacetime, double r, double q) {
    const double lapse2 = spacetime.lapse_squared(r), areal = spacetime.areal_radius(r);
    const double o = falling_frame(lapse2, 1.0).outward,
                 sum = q + std::sqrt(std::max(q * q - lapse2 / (areal * areal), 0.0));
    const double t = o / (areal * sum), by = 1.0 / (1.0 / t + t);
    return {(1.0 / t - t) * by, 0.0, 2.0 * by};
}

std::optional<Start> start_of(const RayQuery& query, const Spacetime& spacetime) {
    const bool by_length = spacetime.by_proper_length();  // wormholes: zeta0 holds l0, and s = +1 is towards the throat
    const double r = query.orbit ? (by_length ? query.orbit->zeta0 : 1.0 / query.orbit->zeta0) : query.r;
    if (std::fabs(r) > kFarthestCamera) return std::nullopt;
    const bool rests = camera_can_rest(spacetime, r), falls = query.orbit ? !rests : query.frame == LocalFrame::kRain;
    // As the reference has it.
    const ObserverKind rest = spacetime.planar_rays() ? ObserverKind::kStatic : ObserverKind::kZamo;
    const ObserverKind observer = falls ? ObserverKind::kRain : rest;
    CameraSpec there;
    there.r = r, there.observer = observer;
    if (!observer_of(spacetime, there)) return std::nullopt;
    if (query.orbit && falls) {
        if (query.orbit->s > 0)
            return std::nullopt;  // no view direction of anybody inside: it would have come from the hole
        return Start{r, M_PI / 2, 0.0, rain_direction(spacetime, r, query.orbit->q), observer};
    }
    if (query.orbit) {  // sin(alpha) = sqrt(V)/q; its cosine as a product
        const double v = spacetime.spherical()->root_v(r), q = std::max(query.orbit->q, v),
                     inward = by_length && r < 0 ? -query.orbit->s : query.orbit->s;
        return Start{r, M_PI / 2, 0.0, {-inward * std::sqrt((q - v) / q * ((q + v) / q)), 0.0, v / q}};
    }
    return Start{r, query.theta, query.phi, query.n, observer};
}

// The camera at the start that looks along n; roll is free. Unrotated it looks along -e_r, up is -e_theta, right e_phi.
Scene view_along(Scene scene, const Start& start) {
    CameraSpec& camera = scene.camera;
    camera = {.r = start.r, .theta = start.theta, .phi = start.phi, .observer = start.observer};
    camera.yaw = std::atan2(start.n.z, -start.n.x);
    camera.pitch = std::atan2(-start.n.y, std::hypot(start.n.x, start.n.z));
    camera.width = camera.height = 1;
    camera.plane_width = 1e-6;  // a narrow pixel: footprints, which nobody looks at here, stay finite far out
    return scene;
}

// A disc from `inner` to 1e30 r_s. From kPlane it is the whole equatorial plane: a ray hits its first crossing. From
// kOutOfReach no ray meets it: all views of a camera then share their effects, hence their tables.
Scene with_disc_from(Scene scene, double inner) {
    scene.disc = DiscSpec{};
    scene.disc->inner = inner, scene.disc->outer = 1e30;
    return scene;
}
constexpr double kPlane = 1e-30, kOutOfReach = 1e29;

// By symmetry a ray is at `angle` where it meets the equator if it starts that far from it along a meridian: southward
// from the northern side, or northward over the pole. angle in (0, pi].
Start moved_to_meet_equator(Start start, double angle) {
    const double across = std::hypot(start.n.y, start.n.z);
    const bool over_pole = angle > M_PI / 2;
    start.theta = std::fabs(M_PI / 2 - angle);
    start.phi = 0.0;
    start.n = {start.n.x, over_pole ? -across : across, 0.0};
    return start;
}

// The azimuth of `direction`, unwrapped: the value next to what the swept angle says (reference/ray_plane.h).
double unwrapped_azimuth(const Start& start, double angle, double x, double y) {
    const double expected = reference::RayPlane(start.theta, start.phi, start.n).azimuth(angle);
    return expected + std::remainder(std::atan2(y, x) - expected, 2 * M_PI);
}

RayRecord record_of(const Start& start, const RayPixel& pixel, bool delays) {
    RayRecord record;
    record.fate = pixel.fate;
    if (pixel.fate == Fate::kHit) record.hit = pixel.hit;
    record.angle = pixel.angle;
    if (pixel.fate != Fate::kEscaped && pixel.fate != Fate::kOtherSide) return record;
    record.sky = pixel.sky;
    record.g = pixel.g;
    if (delays && pixel.fate == Fate::kEscaped) record.delay = pixel.delay;
    record.theta_inf = std::atan2(std::hypot(pixel.sky.x, pixel.sky.y), pixel.sky.z);
    record.phi_inf = unwrapped_azimuth(start, pixel.angle, pixel.sky.x, pixel.sky.y);
    return record;
}

struct Job {
    std::size_t row;
    Start start;
    std::optional<double> at_angle;
    bool asks_place() const { return at_angle && *at_angle > 0.0 && *at_angle <= M_PI; }
};

// The views of a ray: the scene, one for each crossing of the equatorial plane that is asked for, the place at at_angle.
class Batch {
public:
    Batch(const Scene& scene, const Spacetime& spacetime, int crossings, bool probes)
        : scene_(scene),
          plane_(with_disc_from(scene, kPlane)),
          bare_plane_(plane_),
          crossings_(crossings),
          planes_(spacetime.planar_rays()),
          delays_(spacetime.knows_light_time()) {
        bare_plane_.bodies.clear();
        if (scene_.disc && scene_.disc->opacity < 1.0) scene_.disc.reset();  // it ends no ray
        if (probes && !scene_.disc) scene_ = with_disc_from(scene, kOutOfReach);
    }

    std::vector<Scene> views(std::span<const Job> jobs) const {
        std::vector<Scene> views;
        for (const Job& job : jobs) {
            views.push_back(view_along(scene_, job.start));
            for (int k = 0; k < crossings_; ++k) {
                views.push_back(view_along(plane_, job.start));
                views.back().disc->passed = k;
            }
            if (job.asks_place())
                views.push_back(view_along(bare_plane_, moved_to_meet_equator(job.start, *job.at_angle)));
        }
        return views;
    }

    // The views' pixels, in their order.
    void write(std::span<const Job> jobs, const std::vector<RayPixel>& pixels, const TraceOutput& output) const {
        auto next = pixels.begin();
        for (const Job& job : jobs) {
            RayRecord record = record_of(job.start, *next++, delays_);
            if (!planes_) record.angle = kNotANumber;
            for (int k = 0; k < crossings_; ++k) {
                const RayPixel& met = *next++;
                const double r = std::hypot(met.u, met.v);
                if (met.hit == kDiscHit)
                    record.crossings.push_back({r, unwrapped_azimuth(job.start, met.angle, met.u, met.v)});
            }
            if (job.asks_place()) {
                const RayPixel& met = *next++;
                if (met.hit == kDiscHit) record.at = 1.0 / std::hypot(met.u, met.v);
            } else if (job.at_angle && *job.at_angle == 0.0) {
                record.at = 1.0 / job.start.r;
            }
            output.take(job.row, std::move(record));
        }
    }

private:
    Scene scene_, plane_, bare_plane_;  // bare: without bodies, which end the ray but not the question where it is
    int crossings_;
    bool planes_, delays_;  // planes: rays keep to one, and sweep an angle in it; delays: the shader knows them
};

}  // namespace

Status trace_with_shader(const Scene& scene, const Spacetime& spacetime, std::span<const RayQuery> rays,
                         const ShaderRun& run, const TraceOutput& output) {
    if (run.tracer != "gl" && has_solids(effect_set(required_effects(scene))))
        return bad_input("--with core64 and core32 know no solid bodies", "reference or gl, or a scene without bodies");
    std::optional<Session> session;  // of gl
    FrameTables tables;
    tables.want_delays(true);
    if (run.tracer == "gl") {
        TRY(opened, open_session(run.context));
        session = std::move(*opened);
        session->renderer->set_method(run.method);
        session->renderer->want_delays(true);
    }
    // The middle pixel of every view.
    const auto trace = [&](const std::vector<Scene>& views) -> Result<std::vector<RayPixel>> {
        if (session) return session->renderer->trace_middles(views);
        std::vector<RayPixel> pixels;
        for (const Scene& view : views) {
            TRY(ready, tables.update(view));
            const CoreInput input = tables.core_input();
            pixels.push_back((run.tracer == "core64" ? trace_core64 : trace_core32)(input, 0, 0));
            output.done(0);  // a chance to stop: a view with a new strip takes milliseconds
        }
        return pixels;
    };
    std::vector<Job> jobs;
    const bool plane = spacetime.can_have_disc();          // the plane is found by a disc in it
    const bool angles = plane && spacetime.planar_rays();  // of orbits that stay in a plane
    bool places = false;
    for (std::size_t row = 0; row < rays.size(); ++row) {
        const RayQuery& query = rays[row];
        if (const auto start = start_of(query, spacetime))
            jobs.push_back({row, *start, angles ? query.at_angle : std::nullopt});
        places = places || (angles && query.at_angle);
    }
    // Rows of one radius share strip and orbit table.
    std::ranges::stable_sort(jobs, {}, [](const Job& job) { return job.start.r; });
    constexpr int kMostCrossings = 12;  // that the shader looks for (DISC_MOST_CROSSINGS)
    const int crossings = plane ? std::min(run.crossings, kMostCrossings) : 0;
    const Batch batch(scene, spacetime, crossings, crossings > 0 || places);
    for (std::span<const Job> rest = jobs; !rest.empty();) {
        const auto now = rest.first(std::min(kBatch, rest.size()));
        TRY(pixels, trace(batch.views(now)));
        batch.write(now, *pixels, output);
        output.done(static_cast<long long>(now.size()));
        rest = rest.subspan(now.size());
    }
    return Done{};
}

}  // namespace nullscope::cli
