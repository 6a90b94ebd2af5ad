#include "table/throat_orbit.h"

#include <algorithm>
#include <cmath>

#include "numeric/nystrom.h"

namespace nullscope {
namespace {

// w below which the forces are their first terms: differences of large numbers lose 1e-16/W there, their slopes 1e-16/W^2.
constexpr double kNearSky = 1e-6;
constexpr double kLargestThroatStep = 0.08;  // rad
// Of the distance to the singularities of R's course, which lie flare() off the rim.
constexpr double kPartOfFlare = 0.2;
constexpr double kFlares = 8.0;                        // from the rim, beyond which steps are long again
constexpr double kPartOfSky = 0.3, kFirstStep = 1e-4;  // of W next to a sky, where there is a logarithm
constexpr double kAtRim = 1e-12;                       // of W: taken as on the rim
constexpr double kBehindRim =
    1.5 * kAtRim;  // and set this far beyond it: within the tube, or out of it, whatever the last digits

using State = OrbitState;  // of W

// One ray: q over the throat's radius and its derivative by delta.
struct Pull {
    const ThroatShape& shape;
    double q, q_slope, tube_slope;
    std::array<double, 2> operator()(double w, double vary) const {
        const ThroatShape::Force f = shape.force(w);
        return {q * q * f.steep - f.flat, (q * q * f.steep_slope - f.flat_slope) * vary + 2.0 * q * q_slope * f.steep};
    }
};

State step(const Pull& pull, const State& s, double h) {
    return nystrom_step<State>({s, pull(s.at, s.vary)}, h, pull).state;
}

// How long a step may be: as the forces change, and next to the tube's rims as R changes its course.
double longest_step(const Pull& pull, const State& s) {
    const ThroatShape& shape = pull.shape;
    const ThroatShape::Force f = shape.force(s.at);
    double longest =
        kLargestThroatStep / std::sqrt(std::max(1.0, std::fabs(pull.q * pull.q * f.steep_slope - f.flat_slope)));
    const double off = std::fabs(std::fabs(shape.length(s.at)) - shape.rim());
    if (off < kFlares * shape.flare()) {
        const double speed = std::fabs(s.slope * shape.length_slope(s.at));
        longest = std::min(longest, kPartOfFlare * (shape.flare() + off) / std::max(speed, 1e-300));
    }
    if (shape.mu() > 0.0) {  // R = L + ln L: forces hold W ln W at the sky
        const double from_sky = std::min(s.at, M_PI - s.at);
        longest = std::min(longest, std::max(kPartOfSky * from_sky, kFirstStep) / std::max(std::fabs(s.slope), 1e-300));
    }
    return longest;
}

// Of a step over a rim, where a derivative of the forces jumps: to there. h: what it may take, then what it took.
State to_rim(const Pull& pull, const State& s, double& h, double rim) {
    double low = 0.0, high = h, low_value = s.at - rim, high_value = step(pull, s, h).at - rim;
    double part = h;
    for (int i = 0; i < 40 && high - low > 1e-15 * h; ++i) {
        part = i % 3 == 2 ? 0.5 * (low + high) : low + (high - low) * low_value / (low_value - high_value);
        const double value = step(pull, s, part).at - rim;
        if (std::fabs(value) < kAtRim) break;
        if ((value > 0.0) == (low_value > 0.0))
            low = part, low_value = value;
        else
            high = part, high_value = value;
    }
    State there = step(pull, s, part);
    there.at = rim + std::copysign(kBehindRim, there.slope);
    h = part;
    return there;
}

// Within the tube L grows evenly with the angle, however often the ray winds: at most as far as the rim. h: what it may take, then what it took.
State through_tube(const Pull& pull, const State& s, double& h) {
    const ThroatShape& shape = pull.shape;
    const double length = shape.length(s.at), slope = shape.length_slope(s.at), bend = shape.length_bend(s.at);
    // Of a ray that passes (dL/dphi)^2 = q^2 - 1, known without what steps have lost.
    const bool known = pull.tube_slope > 0.0;
    const double speed = known ? std::copysign(pull.tube_slope, s.slope * slope) : s.slope * slope,
                 vary = s.vary * slope;
    const double vary_speed = known ? pull.q * pull.q_slope / speed : s.vary_slope * slope + s.slope * bend * s.vary;
    h = std::min(h, (shape.rim() - std::copysign(1.0, speed) * length) / std::fabs(speed) + kAtRim);
    const double w = shape.angle(length + h * speed), slope_there = shape.length_slope(w);
    State next{w, speed / slope_there, (vary + h * vary_speed) / slope_there, 0.0};
    next.vary_slope = (vary_speed - next.slope * shape.length_bend(w) * next.vary) / slope_there;
    return next;
}

// So close to the critical ray that steps no longer say whether a ray passes the throat (sqrt(q^2 - 1) below some 1e-7): one that passes
// does not turn before the tube but has come to its rim, and one that turns does not come to the other side of the throat.
State on_its_side(const Pull& pull, const State& before, State next, double rim) {
    const double from_middle = before.at - M_PI_2;
    if (pull.tube_slope > 0.0) {
        if (before.slope * from_middle < 0.0 && next.slope * from_middle > 0.0) {
            next.at = M_PI_2 + std::copysign(M_PI_2 - rim, from_middle) - std::copysign(2.0 * kAtRim, from_middle);
            next.slope = std::copysign(pull.tube_slope / pull.shape.length_slope(next.at), before.slope);
        }
    } else if (from_middle * (next.at - M_PI_2) < 0.0) {
        next = before;
        next.slope = -before.slope;
    }
    return next;
}

State advance(const Pull& pull, State s, double cell) {
    const double rim = pull.shape.angle(pull.shape.rim());
    for (double left = cell; left > 0.0;) {
        if (std::fabs(s.at - M_PI_2) < M_PI_2 - rim - kAtRim) {
            double h = left;
            s = through_tube(pull, s, h);
            left -= h;
            continue;
        }
        const double longest = longest_step(pull, s);
        double h = longest < left ? left / std::ceil(left / longest) : left;
        const State next = step(pull, s, h);
        const auto crosses = [&](double at) {
            return pull.shape.mu() > 0.0 && (s.at - at) * (next.at - at) < 0.0 && std::fabs(s.at - at) > 2.0 * kAtRim;
        };
        const double near = s.at < M_PI_2 ? rim : M_PI - rim;  // a step may go through all of a short tube
        s = crosses(near)          ? to_rim(pull, s, h, near)
            : crosses(M_PI - near) ? to_rim(pull, s, h, M_PI - near)
                                   : on_its_side(pull, s, next, rim);
        left = h < left ? left - h : 0.0;
    }
    return s;
}

}  // namespace

ThroatShape::ThroatShape(const SphericalMetric& spacetime)
    : spacetime_(spacetime),
      throat_(spacetime.length_unit()),
      mu_(spacetime.logarithm_length() / throat_),
      rim_(spacetime.tube_beyond(0.0)),
      flare_(mu_ > 0.0 ? M_PI_2 * mu_ : 1.0) {}

double ThroatShape::length(double angle) const {
    const double sine = std::sin(angle);
    return std::cos(angle) * (1.0 / sine - (mu_ > 0.0 ? mu_ * std::log(sine) : 0.0));
}

double ThroatShape::length_slope(double angle) const {
    const double s = std::sin(angle), c = std::cos(angle);
    return -1.0 / (s * s) + (mu_ > 0.0 ? mu_ * (s * std::log(s) - c * c / s) : 0.0);
}

double ThroatShape::length_bend(double angle) const {
    const double s = std::sin(angle), c = std::cos(angle), s2 = s * s;
    return 2.0 * c / (s2 * s) + (mu_ > 0.0 ? mu_ * (c * std::log(s) + 3.0 * c + c * c * c / s2) : 0.0);
}

// By Newton's steps in cot W, of which L is an odd function that grows by at least 1 per 1.
double ThroatShape::angle(double length) const {
    double m = length;
    for (int i = 0; i < 60 && mu_ > 0.0; ++i) {
        const double m2 = 1.0 + m * m, root = std::sqrt(m2), logarithm = 0.5 * std::log1p(m * m);
        const double off = m + mu_ * logarithm * m / root - length,
                     slope = 1.0 + mu_ * (m * m + logarithm) / (m2 * root);
        m -= off / slope;
        if (std::fabs(off) <= 1e-16 * std::fabs(m)) break;
    }
    return std::atan2(1.0, m);
}

ThroatShape::Force ThroatShape::force(double angle) const {
    const bool other = angle > M_PI_2;  // even about the throat
    const double from_sky = std::max(other ? M_PI - angle : angle, 0.0), w = std::max(from_sky, kNearSky);
    const double s = std::sin(w), c = std::cos(w), s2 = s * s, log_s = mu_ > 0.0 ? std::log(s) : 0.0;
    const double d = -1.0 / s2 + mu_ * (s * log_s - c * c / s);  // D and its derivatives by W
    const double d1 = 2.0 * c / (s2 * s) + mu_ * (c * log_s + 3.0 * c + c * c * c / s2);
    const double d2 = -2.0 / s2 - 6.0 * c * c / (s2 * s2) -
                      mu_ * (s * log_s + 3.0 * s + 2.0 * c * c / s + 2.0 * c * c * c * c / (s2 * s));
    const double l = throat_ * (c * (1.0 / s - (mu_ > 0.0 ? mu_ * log_s : 0.0)));  // length(w)
    const double r = spacetime_.areal_radius(l) / throat_, r1 = spacetime_.radius_slope(l),
                 r2 = throat_ * spacetime_.radius_curvature(l);
    const double turn = d1 / d, bend = d2 / d;
    const double p = r * r / d, q = r / d;
    const double p1 = 2.0 * r * r1 - p * turn, q1 = r1 - q * turn;
    const double p2 = 2.0 * d * (r1 * r1 + r * r2) - 2.0 * r * r1 * turn - p * bend + 2.0 * p * turn * turn;
    const double q2 = r2 * d - r1 * turn - q * bend + 2.0 * q * turn * turn;
    const double near = from_sky / w;  // flat is odd in W next to the sky
    const double sign = other ? -1.0 : 1.0;
    return {sign * p * p1, sign * near * q * q1, p1 * p1 + p * p2, q1 * q1 + q * q2};
}

OrbitTexels throat_column(const RayFamily& family, Segment segment, double delta) {
    const ThroatShape shape(family.spacetime());
    const FanRay ray = family.ray(segment, delta);
    // Of l towards the sky where the ray ends; beta grows with delta as that says.
    const double end = segment == Segment::kSky ? 1.0 : -1.0;
    const double throat = shape.throat(), radius = 1.0 / (family.zeta0() * throat);
    const Pull pull{shape, ray.q * throat, -end * ray.slope * throat / ray.sin_beta, ray.tube_slope};
    const double start = shape.angle(end * family.camera_r() / throat),
                 per_slope = -end * radius * radius * throat / shape.length_slope(start);
    const auto bend = [&](double w) { return pull(w, 0.0)[0]; };
    const int rows = family.orbit_rows();
    const MetOrbit orbit = meet(
        rows, {start, per_slope * ray.slope, 0.0, per_slope * (-end * ray.q / ray.sin_beta)},
        {0.0, pull.q, 0.0, pull.q_slope},
        [&](State* states, int count) {
            for (int row = 0; row < count; ++row) states[row + 1] = advance(pull, states[row], ray.phi_end / rows);
        },
        bend);
    OrbitTexels texels = place_texels(orbit, ray.phi_end, true, bend);
    // The limits at v = 1: W = q phi' + W'' phi'^2/2 of the angle phi' from the sky.
    const double bent = pull(0.0, 0.0)[0], bent_slope = pull(0.0, 0.0)[1], end_per_delta = orbit.end_per_delta;
    texels.back() = {pull.q * ray.phi_end, pull.q_slope * ray.phi_end + pull.q * end_per_delta,
                     -0.5 * bent * ray.phi_end * ray.phi_end / rows,
                     -0.5 * ray.phi_end * (bent_slope * ray.phi_end + 2.0 * bent * end_per_delta) / rows};
    return texels;
}

}  // namespace nullscope
