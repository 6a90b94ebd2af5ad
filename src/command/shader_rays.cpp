#include "command/shader_rays.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "command/session.h"
#include "observer/observer.h"
#include "observer/spin_ring.h"
#include "reference/ray_plane.h"
#include "render/listed_start.h"
#include "scene/disc_shape.h"
#include "scene/leaning_disc.h"
#include "scene/orbit_sense.h"
#include "spacetime/spherical_metric.h"

namespace nullscope::cli {
namespace {

constexpr std::size_t kBatch = 65536;  // rays traced between two reports of progress: a draw
constexpr int kMostCrossings = 12;     // that the shader looks for (DISC_MOST_CROSSINGS)

// A ray as the shader takes it: an observer and a view direction.
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

// The camera at the start that looks along n; roll is free. Unrotated it looks along -e_r, up is -e_theta, right e_phi.
Scene view_along(Scene scene, const Start& start) {
    CameraSpec& camera = scene.camera;
    camera = {.r = start.r, .theta = start.theta, .phi = start.phi, .observer = start.observer};
    camera.yaw = std::atan2(start.n.z, -start.n.x);
    camera.pitch = std::atan2(-start.n.y, std::hypot(start.n.x, start.n.z));
    camera.width = camera.height = 1;
    camera.plane_width = 1e-6;  // a narrow pixel: tables resolve what is next to the critical direction
    return scene;
}

// Where rays start, as the shader takes it. What follows from a place alone is kept from ray to ray.
class Starts {
public:
    Starts(const Scene& scene, const Spacetime& spacetime) : scene_(scene), spacetime_(spacetime) {}

    // Nothing: the camera cannot stand there.
    std::optional<Start> of(const RayQuery& query) {
        const bool by_length =
            spacetime_.by_proper_length();  // wormholes: zeta0 holds l0, and s = +1 is towards the throat
        const double r = query.orbit ? (by_length ? query.orbit->zeta0 : 1.0 / query.orbit->zeta0) : query.r;
        if (std::fabs(r) > kFarthestCamera) return std::nullopt;
        const bool rests = camera_can_rest(spacetime_, r),
                   falls = query.orbit ? !rests : query.frame == LocalFrame::kRain;
        // As the reference has it.
        const ObserverKind rest = spacetime_.planar_rays() ? ObserverKind::kStatic : ObserverKind::kZamo;
        const ObserverKind kind = falls ? ObserverKind::kRain : rest;
        if (!observer(r, query.orbit ? M_PI / 2 : query.theta, kind)) return std::nullopt;
        if (query.orbit && falls) {
            if (query.orbit->s > 0)
                return std::nullopt;  // no view direction of anybody inside: it would have come from the hole
            return Start{r, M_PI / 2, 0.0, rain_direction(spacetime_, r, query.orbit->q), kind};
        }
        if (query.orbit) {  // sin(alpha) = sqrt(V)/q; its cosine as a product
            const double v = spacetime_.spherical()->root_v(r), q = std::max(query.orbit->q, v),
                         inward = by_length && r < 0 ? -query.orbit->s : query.orbit->s;
            return Start{r, M_PI / 2, 0.0, {-inward * std::sqrt((q - v) / q * ((q + v) / q)), 0.0, v / q}};
        }
        return Start{r, query.theta, query.phi, query.n, kind};
    }

    // About a rotating hole: does a narrow view along it need the peak from the host (observer/spin_ring.h)?
    bool is_next_to_ring(const Start& start) {
        if (!spacetime_.rotates() || !scene_.light.lensing || !spacetime_.bends_light()) return false;
        const Observer* seen = observer(start.r, start.theta, start.observer);
        if (seen == nullptr) return false;
        if (!ring_) ring_.emplace(spacetime_, camera_, *seen);
        if (!(std::fabs(ring_->of(seen->turn * start.n).distance()) < kMaybeNext)) return false;
        return nullscope::is_next_to_ring(spacetime_, view_along(scene_, start).camera, *seen, scene_.light);
    }

private:
    static constexpr double kMaybeNext = 1e-2;  // e, far above that of pixels of 1e-6 rad
    const Observer* observer(double r, double theta, ObserverKind kind) {
        if (!has_camera_ || camera_.r != r || camera_.theta != theta || camera_.observer != kind) {
            camera_ = {.r = r, .theta = theta, .observer = kind};
            has_camera_ = true;
            ring_.reset();
            auto made = observer_of(spacetime_, camera_);
            observer_ = made ? std::optional(*made) : std::nullopt;
        }
        return observer_ ? &*observer_ : nullptr;
    }

    const Scene& scene_;
    const Spacetime& spacetime_;
    bool has_camera_ = false;
    CameraSpec camera_;
    std::optional<Observer> observer_;
    std::optional<RingOfRays> ring_;
};

// By its swept angle the azimuth of a place is known but for rounding: the value of (x, y)'s next to it.
double unwrapped(double expected, double x, double y) {
    return expected + std::remainder(std::atan2(y, x) - expected, 2 * M_PI);
}

struct Job {
    std::size_t row;
    Start start;
    std::optional<double> at_angle;
    bool next_to_ring;  // of a rotating hole: a program of its own keeps its digits
    bool reduced;
};

// What the rays of one draw have in common besides tables.
struct Common {
    const ListedStart& start;
    int crossings;
    bool planes, delays;   // planes: rays keep to one, and sweep an angle in it; delays: the shader knows them
    DiscPlane disc;        // whose crossings they are
    double shifts_beyond;  // r_s, the horizon's radius where crossings have a shift; else infinite
    const PolarisationSpec* polarisation;  // of their light; or null
};

using Plane = std::optional<reference::RayPlane>;  // of rays that keep to one

// Of one ray: everything but its crossings.
RayRecord record_of(const Job& job, const ListedRay& ray, const Common& common, const Plane& plane) {
    const RayPixel& end = ray.end;
    RayRecord record;
    record.fate = end.fate;
    if (end.fate == Fate::kHit) record.hit = end.hit;
    if (plane) record.angle = end.angle;
    if (job.at_angle == 0.0)
        record.at = 1.0 / job.start.r;
    else if (job.at_angle && ray.at > 0.0)
        record.at = ray.at;
    if (end.fate != Fate::kEscaped && end.fate != Fate::kOtherSide) return record;
    record.sky = end.sky;
    record.g = end.g;
    if (common.delays && end.fate == Fate::kEscaped) record.delay = end.delay;
    record.theta_inf = std::atan2(std::hypot(end.sky.x, end.sky.y), end.sky.z);
    record.phi_inf = unwrapped(plane ? plane->azimuth(end.angle) : job.start.phi, end.sky.x, end.sky.y);
    return record;
}

void add_crossings(const Job& job, const RayNumbers& numbers, const ListedRay& ray, const Common& common,
                   const Plane& plane, RayRecord& record) {
    for (int k = 0; k < ray.count; ++k) {
        const ListedRay::Crossing& met = ray.crossings[static_cast<std::size_t>(k)];
        const int number = static_cast<int>(record.crossings.size()) + 1;
        const Vec3 at = common.disc.place(met.x, met.y);
        RayRecord::Crossing crossing{
            std::hypot(met.x, met.y),
            unwrapped(plane ? plane->azimuth(plane->crossing(number)) : job.start.phi, at.x, at.y)};
        if (crossing.r > common.shifts_beyond && !job.reduced) {
            crossing.g = common.start.g(numbers, met);
            if (common.polarisation != nullptr) {
                const auto light = common.start.polarised(*common.polarisation, numbers, job.start.n, met, number);
                crossing.chi = 0.5 * std::arg(light), crossing.p = std::abs(light);
            }
        }
        record.crossings.push_back(crossing);
    }
}

// The shader's own text, by the driver or as C++.
class Lister {
public:
    static Result<Lister> make(const ShaderRun& run) {
        Lister lister(run.tracer == "core64");
        if (run.tracer != "gl") return lister;
        TRY(opened, open_session(run.context));
        lister.session_ = std::move(*opened);
        lister.session_->renderer->set_method(run.method);
        lister.session_->renderer->compute(run.compute);
        lister.session_->renderer->want_delays(true);
        return lister;
    }
    std::vector<std::string> take_notes() {
        return session_ ? session_->renderer->take_notes() : std::vector<std::string>();
    }
    const FrameTables& tables() const { return session_ ? session_->renderer->tables() : tables_; }
    Status prepare(const Scene& scene, bool crossings) {
        if (session_) return session_->renderer->prepare_list(scene, crossings);
        tables_.want_crossings(crossings);
        return tables_.update(scene);
    }
    void list(const ListedCrossings& asked, std::span<const RayNumbers> rays, ListedRay* found) {
        if (session_)
            session_->renderer->list_rays(asked, rays, found);
        else
            tables_.list_rays(in_double_, asked, rays, found);
    }

private:
    explicit Lister(bool in_double) : in_double_(in_double) { tables_.want_delays(true); }
    bool in_double_;
    std::optional<Session> session_;  // of gl
    FrameTables tables_;
};

// Rays that one preparation serves, in draws of kBatch.
class Group {
public:
    Group(Lister& lister, const Common& common, bool hunts_disc, const TraceOutput& output)
        : lister_(lister), common_(common), hunts_disc_(hunts_disc), output_(output) {}

    void trace(std::span<const Job> jobs) {
        for (std::span<const Job> rest = jobs; !rest.empty();) {
            const auto now = rest.first(std::min(kBatch, rest.size()));
            trace_batch(now);
            output_.done(static_cast<long long>(now.size()));
            rest = rest.subspan(now.size());
        }
    }

private:
    struct Open {  // a ray that is not done
        const Job* job;
        RayNumbers numbers;
        RayRecord record;
    };

    void trace_batch(std::span<const Job> jobs) {
        std::vector<Open> open;
        open.reserve(jobs.size());
        for (const Job& job : jobs)
            open.push_back(
                {&job,
                 common_.start.numbers(job.start.theta, job.start.phi, job.start.n, job.at_angle.value_or(0.0)),
                 {}});
        for (int first = 0; !open.empty(); first += kListedCrossings) {
            const int most = std::clamp(common_.crossings - first, 0, kListedCrossings);
            numbers_.clear();
            for (const Open& ray : open) numbers_.push_back(ray.numbers);
            found_.resize(open.size());
            lister_.list({first, most}, numbers_, found_.data());
            std::vector<Open> left;
            for (std::size_t i = 0; i < open.size(); ++i) {
                take(open[i], found_[i], first == 0);
                if (goes_on(open[i].record, found_[i], first + kListedCrossings))
                    left.push_back(std::move(open[i]));
                else
                    output_.take(open[i].job->row, std::move(open[i].record));
            }
            open = std::move(left);
        }
    }

    void take(Open& ray, const ListedRay& found, bool is_first) const {
        const Start& start = ray.job->start;
        Plane plane;
        if (common_.planes) plane.emplace(start.theta, start.phi, start.n, common_.disc.normal);
        if (is_first || found.end.fate == Fate::kHit) {
            auto crossings = std::move(ray.record.crossings);
            ray.record = record_of(*ray.job, found, common_, plane);
            ray.record.crossings = std::move(crossings);
        }
        add_crossings(*ray.job, ray.numbers, found, common_, plane, ray.record);
    }

    // Are there crossings that are asked for, or that may be of the disc that ends the ray?
    bool goes_on(const RayRecord& record, const ListedRay& found, int next) const {
        if (!found.more || next >= kMostSteps) return false;
        return next < common_.crossings || (hunts_disc_ && record.fate != Fate::kHit);
    }

    static constexpr int kMostSteps = 512;  // of a ray about a rotating hole: so often it crosses at most
    Lister& lister_;
    const Common common_;
    bool hunts_disc_;
    const TraceOutput& output_;
    std::vector<RayNumbers> numbers_;
    std::vector<ListedRay> found_;
};

// What rays must have in common: tables and the frame's numbers.
auto key_of(const Job& job, bool planes, bool bodies) {
    const Start& start = job.start;
    return std::tuple(start.r, static_cast<int>(start.observer), job.next_to_ring,
                      planes && !bodies ? 0.0 : start.theta, bodies ? start.phi : 0.0);
}

std::vector<Job> jobs_of(const Scene& scene, const Spacetime& spacetime, std::span<const RayQuery> rays, bool angles) {
    std::vector<Job> jobs;
    jobs.reserve(rays.size());
    Starts starts(scene, spacetime);
    for (std::size_t row = 0; row < rays.size(); ++row) {
        const RayQuery& query = rays[row];
        if (const auto start = starts.of(query))
            jobs.push_back({row, *start, angles ? query.at_angle : std::nullopt, starts.is_next_to_ring(*start),
                            query.orbit.has_value()});
    }
    return jobs;
}

}  // namespace

Status trace_with_shader(const Scene& scene, const Spacetime& spacetime, std::span<const RayQuery> rays,
                         const ShaderRun& run, const TraceOutput& output) {
    const bool bodies = has_solids(effect_set(required_effects(scene)));
    if (run.tracer != "gl" && bodies)
        return bad_input("--with core64 and core32 do not support solid bodies",
                         "reference or gl, or a scene without bodies");
    TRY(lister, Lister::make(run));
    const bool planes = spacetime.planar_rays(), plane = spacetime.can_have_disc();  // the plane is where discs may be
    std::vector<Job> jobs = jobs_of(scene, spacetime, rays, plane && planes);
    const auto before = [&](const Job& a, const Job& b) {
        return key_of(a, planes, bodies) < key_of(b, planes, bodies);
    };
    if (!std::ranges::is_sorted(jobs, before)) std::ranges::stable_sort(jobs, before);
    Scene drawn = scene;
    const bool opaque = scene.disc && scene.disc->opacity >= 1.0;
    if (!opaque && !(run.crossings > 0 && disc_leans(scene))) drawn.disc.reset();  // it ends no ray
    if (run.tracer != "gl" && disc_leans(scene) && !planes)
        return bad_input("--with core64 and core32 have no disc that leans about a rotating hole", "reference or gl");
    if (disc_warps(scene))
        return bad_input("of a disc with a warp or rings the reference alone lists crossings", "--with reference");
    const Sense sense = scene.disc ? sense_about(spacetime, scene.disc->sense) : Sense::kEastward;
    const int crossings = plane ? std::min(run.crossings, kMostCrossings) : 0;
    const double shifts_beyond = run.shifts ? spacetime.horizon_radius().value_or(0.0) : INFINITY;
    const bool places = std::ranges::any_of(jobs, [](const Job& job) { return job.at_angle.has_value(); });
    for (std::span<const Job> rest = jobs; !rest.empty();) {
        const auto end = std::ranges::upper_bound(rest, rest.front(), before);
        const auto now = rest.first(static_cast<std::size_t>(end - rest.begin()));
        TRY(ready, lister->prepare(view_along(drawn, now.front().start), crossings > 0 || places));
        const ListedStart start(lister->tables(), sense);
        const Common common{start,
                            crossings,
                            planes,
                            spacetime.knows_light_time(),
                            disc_plane_of(scene),
                            shifts_beyond,
                            run.polarised ? &scene.disc->polarisation : nullptr};
        Group(*lister, common, opaque && !planes, output).trace(now);
        rest = rest.subspan(now.size());
    }
    for (const std::string& note : lister->take_notes()) output.note(note);
    return Done{};
}

}  // namespace nullscope::cli
