#include "reference/bodies.h"

#include <algorithm>
#include <cmath>

#include "expr/formula.h"
#include "plan/moving.h"
#include "reference/body_shift.h"
#include "scene/bodies.h"
#include "scene/named_surface.h"

namespace nullscope::reference {
namespace {

constexpr double kInPlane = 1e-9;  // of its radius: how far off the equatorial plane a ball's place may be written
constexpr int kWaySamples = 200;   // at the way of a ball

}  // namespace

Status check_bodies(const Scene& scene, const Metric& matter) {
    if (matter.orbits()) return Done{};
    if (const auto far = late_fall_faults(true, scene); !far.empty())
        return bad_key(far.front().key, far.front().what, far.front().allowed);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const auto* ball = std::get_if<BallSpec>(&scene.bodies[i].shape);
        if (ball == nullptr) continue;
        const std::string section = body_section(scene, i);
        if (ball->motion == BallMotion::kOrbit && std::abs(ball->position.z) > kInPlane * length(ball->position))
            return bad_key(section + ".position",
                           "orbits about a rotating hole that leave its equatorial plane are not followed", "z = 0");
    }
    return Done{};
}

Vec3 BodyPart::normal(Vec3 place, double t) const {
    const double tiny = 1e-6 * thinnest;
    const auto along = [&](Vec3 side) { return value(place + side, t) - value(place - side, t); };
    const Vec3 slope{along({tiny, 0, 0}), along({0, tiny, 0}), along({0, 0, tiny})};
    const double size = length(slope);
    return size > 0 ? slope / size : Vec3{0, 0, 0};
}

void BodyPart::tell(BodyHit& hit, double t) const {
    hit.turn = turn_rate * t;
    if (!glows) return;
    hit.moves = changes(), hit.carries = moves && middle != nullptr;
    hit.velocity = body_velocity(*this, hit.place, t);
}

namespace {

struct PartOf {
    // Of a path by formulas: the largest of differences along it, twice that for what lies between them.
    double path_speed(const std::function<Vec3(double)>& middle) const {
        constexpr int kSamples = 4000;
        const double span = 4.0 * (scene.camera.r + 50.0), step = span / kSamples;
        double fastest = 0;
        Vec3 before = middle(scene.time);
        for (int i = 1; i <= kSamples; ++i) {
            const Vec3 here = middle(scene.time - i * step);
            fastest = std::max(fastest, length(here - before) / step), before = here;
        }
        return 2 * fastest;
    }
    const Scene& scene;
    const Metric& matter;
    BodyPart part;  // number, body and side are there
    BodyPart operator()(const SphereSpec& s) {
        part.thinnest = s.radius * (1 - s.amplitude), part.reach = s.radius * (1 + s.amplitude);
        part.value = [s](Vec3 x, double t) {
            return length(x) - s.radius * (1 + s.amplitude * std::sin(2 * M_PI * t / s.period));
        };
        part.moves = s.amplitude > 0, part.clear = s.amplitude == 0;
        part.speed = s.radius * s.amplitude * 2 * M_PI / s.period;
        part.turn_rate = s.spin_rate;
        return part;
    }
    BodyPart operator()(const CylinderSpec& c) {
        part.thinnest = std::min(2 * c.height, c.outer - c.inner), part.reach = std::hypot(c.outer, c.height);
        part.value = [c](Vec3 x, double) {
            const double rho = std::hypot(x.x, x.y);
            return std::max({rho - c.outer, c.inner - rho, std::abs(x.z) - c.height});
        };
        part.clear = true, part.speed = 0;
        return part;
    }
    BodyPart operator()(const BallSpec& b) {
        part.middle = ball_way(matter, b);
        double reach = length(b.position);
        if (b.moves())  // as far as it goes in the time that light takes
            for (int i = 0; i <= kWaySamples; ++i)
                reach =
                    std::max(reach, length(part.middle(scene.time - 4.0 * (scene.camera.r + 50.0) * i / kWaySamples)));
        const double step = b.moves() ? b.radius : 0.0;  // looks at its way were a step apart
        part.thinnest = b.radius, part.reach = reach + b.radius + step;
        part.value = [b, middle = part.middle](Vec3 x, double t) { return length(x - middle(t)) - b.radius; };
        part.moves = b.moves(), part.clear = b.motion != BallMotion::kPath;
        part.speed = !b.moves() ? 0 : part.clear ? 1 : path_speed(part.middle);
        return part;
    }
    BodyPart operator()(const SurfaceSpec& s) {
        part.thinnest = 2 * s.bound / s.steps, part.reach = s.bound, part.moves = surface_moves(s);
        const auto shape = expr::Formula::parse(surface_shape(s), {"x", "y", "z", "t"});
        if (!shape) return part;
        part.value = [f = *shape, bound = s.bound](Vec3 x, double t) {
            const double place[] = {x.x, x.y, x.z, t};
            return std::max(f.value(place), length(x) - bound);
        };
        return part;
    }
};

// A body that moves, as far as it is seen: nothing within a radius about the centre, and no ball whose middle is there. As steep as a ball
// that falls there needs 1 r_s/c for.
std::function<double(Vec3, double)> above(double unseen, const BodyPart& part) {
    constexpr double kSteep = 100;
    return [=, value = part.value, middle = part.middle](Vec3 x, double t) {
        const double place = unseen - length(x), whole = middle ? kSteep * (unseen - length(middle(t))) : place;
        return std::max({value(x, t), place, whole});
    };
}

}  // namespace

Bodies::Bodies(const Scene& scene, const Metric& matter) : time_(scene.time) {
    const double unseen = unseen_radius(scene, matter.horizon_radius());
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        BodyPart part;
        part.number = object_number(scene, i), part.body = i, part.far = scene.bodies[i].far;
        part.glows = scene.bodies[i].material.temperature_K.has_value();
        part = std::visit(PartOf{scene, matter, part}, scene.bodies[i].shape);
        if (part.moves && unseen > 0) part.value = above(unseen, part);
        moves_ = moves_ || part.changes();
        if (part.value) parts_.push_back(std::move(part));
    }
}

}  // namespace nullscope::reference
