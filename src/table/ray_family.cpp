#include "table/ray_family.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/gauss.h"
#include "table/bounce.h"
#include "table/ray_sweep.h"

namespace nullscope {

namespace {
constexpr double kMostInTube = 1e6;  // rad; more windings than a float tells apart
// Over the critical angle, and over 1 rad: ratios such as phi/sin(beta) have reached their limit to 1e-17 there.
constexpr double kRadialFloor = 1e-9, kLeastCritical = 1e-10;
constexpr double kNoAngle = 1e-300;  // stands for the dividing ray itself

double square(double x) { return x * x; }
}  // namespace

RayFamily::RayFamily(std::shared_ptr<const SphericalMetric> spacetime, std::shared_ptr<const DeflectionTable> table,
                     double r, RadialFrame frame, double pixel, std::optional<double> zoom)
    : spacetime_(std::move(spacetime)),
      table_(std::move(table)),
      frame_(frame),
      zoom_(zoom),
      r_(r),
      radius_(spacetime_->areal_radius(r)),
      zeta0_(1.0 / radius_) {
    const double lapse2 = spacetime_->lapse_squared(r), v0 = lapse2 * square(zeta0_);
    const auto horizon = spacetime_->horizon_radius();
    inside_ = horizon && r <= *horizon;
    lapse_ = inside_ ? 0.0 : std::sqrt(lapse2);
    barrier_ = spacetime_->barrier();
    potential_ = spacetime_->potential();
    if (barrier_) {
        separate_at_barrier();
    } else if (potential_ != nullptr) {
        separate_at_ridge();
    } else {
        chi0_ = inside_ ? M_PI : spacetime_->chi()->chi_from_radius(r);
        q_crit_ = spacetime_->photon_sphere()->q_crit;
        v_sky_ = spacetime_->v_at_sky();
        of_range_ = square(q_crit_) / (square(q_crit_) - v_sky_);
        const double v_over_q2 = v0 / square(q_crit_);
        photon_ = separatrix_ = separatrix(
            q_crit_, inside_ ? -std::sqrt(std::max(1.0 - v_over_q2, 0.0)) : std::cos(chi0_) / std::sqrt(of_range_),
            v_over_q2);
        if (v_sky_ < 0.0) chi_end_ = spacetime_->chi()->chi_from_radius(*horizon);  // there V = 0
    }
    tube_out_ = spacetime_->tube_beyond(r);
    tube_in_ = spacetime_->tube_beyond(-kAnyRadius) - tube_out_;
    if (const auto surface = spacetime_->surface_radius()) {
        chi_end_ = spacetime_->chi()->chi_from_radius(*surface);
        grazes_ = chi_end_ < M_PI / 2;  // the surface hides the photon sphere: V(surface) is what divides
        const double sine = std::sin(chi_end_);
        if (grazes_)
            separatrix_ =
                separatrix(q_crit_ * sine, std::sqrt(std::sin(chi_end_ - chi0_) * std::sin(chi_end_ + chi0_)) / sine,
                           v0 / square(q_crit_ * sine));
    }
    c_ = separatrix_.c;
    from_inward_ = !(separatrix_.t < 1.0);
    theta_c_ = 2.0 * std::atan(from_inward_ ? 1.0 / separatrix_.t : separatrix_.t);
    const double scale = theta_c_ > 0.0 ? theta_c_ : 1.0;
    const double wanted = std::clamp(kPixelPart * pixel / scale, zoom ? kFinestRing : kFinest, kResolution);
    w0_ = kResolution * std::exp2(4.0 * std::floor(0.25 * std::log2(wanted / kResolution))) * scale;
}

// 1 - c from 1 - c^2 where it is small.
RayFamily::Separatrix RayFamily::separatrix(double q, double c, double v_over_q2) const {
    const double reach = q * radius_, one_minus_c = c > 0.0 ? v_over_q2 / (1.0 + c) : 1.0 - c;
    return {reach, c, frame_.outward / (reach * one_minus_c)};
}

double RayFamily::one_minus_k2(const Separatrix& d, double t, double t_minus) const {
    const double o = frame_.outward, i = frame_.inward, across = 2.0 * d.reach * t;
    // o/t_d - i t, which vanishes for the ray of the same q that is traced outward; next to the dividing ray without a difference.
    const double other = std::fabs(t_minus) < 0.5 * d.t ? -2.0 * d.reach * d.c - i * t_minus : o / d.t - i * t;
    return t_minus * other * ((across + o + i * t * t) / square(across));
}

// V(zeta0) - V(zeta_d) by the barrier's own polynomial: c^2 as a product.
void RayFamily::separate_at_barrier() {
    const Barrier& barrier = *barrier_;
    const double x = zeta0_ - barrier.zeta;
    separate_at(barrier.v, x * (barrier.c[0] + x * (barrier.c[1] + x * (barrier.c[2] + x * barrier.c[3]))), x < 0.0);
}

void RayFamily::separate_at_ridge() {
    const Ridge& ridge = potential_->potential.ridge();
    const double off = r_ - potential_->potential.end() - ridge.x;
    separate_at(ridge.v, -potential_->potential.below(off), off > 0.0);
}

// over: V(zeta0) - top.
void RayFamily::separate_at(double top, double over, bool outside) {
    top_ = top, over_top_ = over;
    q_crit_ = std::sqrt(top);
    if (outside)
        separatrix_ = separatrix(q_crit_, std::sqrt(std::max(-over, 0.0) / top), square(lapse_ * zeta0_) / top);
    else
        separatrix_ = {q_crit_ * radius_, 0.0, INFINITY};
    chi0_ = 2.0 * std::atan(1.0 / separatrix_.t);
}

double RayFamily::delta_limit(Segment segment) const {
    return from_inward_ == (segment == Segment::kSky) ? M_PI - theta_c_ : theta_c_;
}

double RayFamily::mirrored(Segment segment, double delta) const {
    const double limit = delta_limit(segment);
    return delta <= limit ? delta : std::max(2.0 * limit - delta, 1e-3 * w0());
}

// theta, the angle from the radial direction that the critical angle is measured from, and what follows from it.
struct RayFamily::Place {
    double theta, t, t_minus;
};

RayFamily::Place RayFamily::place_at(Segment segment, double delta) const {
    double by = from_inward_ == (segment == Segment::kSky) ? delta : -delta;
    const double floor = kRadialFloor * std::clamp(theta_c_, kLeastCritical, 1.0);
    const double theta = std::clamp(theta_c_ + by, floor, M_PI - floor);
    if (theta != theta_c_ + by) by = theta - theta_c_;
    const double half = 0.5 * theta, half_c = 0.5 * theta_c_;
    if (!from_inward_) return {theta, std::tan(half), std::sin(0.5 * by) / (std::cos(half) * std::cos(half_c))};
    return {theta, 1.0 / std::tan(half), -std::sin(0.5 * by) / (std::sin(half) * std::sin(half_c))};
}

FanRay RayFamily::tube_ray(Segment segment, double delta) const {
    const Place place = place_at(segment, delta);
    FanRay ray{};
    ray.sin_beta = std::sin(place.theta);
    const double d2 = -one_minus_k2(separatrix_, place.t, place.t_minus);
    if (d2 > 0.0)
        ray.in_tube = std::min((segment == Segment::kSky ? tube_out_ : tube_in_) / std::sqrt(d2), kMostInTube);
    return ray;
}

double RayFamily::delta_slope(double u) const {
    const double half_w = 0.5 * w0() * (u - 1.0);
    return w0() / (1.0 + half_w * half_w);
}

int RayFamily::octaves(Segment segment) const {
    double limit = delta_limit(segment);
    // What comes back from a barrier is told by its angle from the centre, too, in as many octaves.
    if (zoom_ && spacetime_->inner_end() != InnerEnd::kSameSky) limit = std::min(limit, *zoom_);
    return static_cast<int>(std::floor(std::log2(1.0 + 2.0 * std::tan(0.5 * limit) / w0()))) + 1 + spare_octaves_;
}

bool RayFamily::same_cells(const RayFamily& other) const {
    return w0_ == other.w0_ && orbit_rows() == other.orbit_rows() &&
           octaves(Segment::kSky) == other.octaves(Segment::kSky) &&
           octaves(Segment::kCaptured) == other.octaves(Segment::kCaptured);
}

FanRay RayFamily::ray(Segment segment, double delta) const {
    const bool sky = segment == Segment::kSky;
    const auto [theta, t, t_minus] = place_at(segment, delta);
    const double o = frame_.outward, i = frame_.inward, across = 2.0 * radius_ * t;
    FanRay ray{};
    ray.beta = from_inward_ ? theta : M_PI - theta;
    ray.sin_beta = std::sin(theta);
    ray.q = (o + i * t * t) / across;
    ray.slope = -(o - i * t * t) / across;
    const double one_minus_kd2 = one_minus_k2(separatrix_, t, t_minus);
    if (top_ > 0.0) {
        // q^2 - V(zeta_d): a product next to the critical direction; slope^2 + V(zeta0) - V(zeta_d) where there is none.
        const double d = theta_c_ > 0.0 ? -top_ * one_minus_kd2 : square(ray.slope) + over_top_;
        ray.phi_end = swept(segment, ray, d == 0.0 ? kNoAngle : d);
        return ray;
    }
    const double whole = grazes_ ? one_minus_k2(photon_, t, t - photon_.t) : one_minus_kd2;
    const double omk2 = whole * of_range_, k = v_sky_ < 0.0 ? std::sqrt(1.0 - omk2) : ray.q / q_crit_;
    const double d2 = std::max(-omk2, kNoAngle);
    if (inside_) {
        ray.phi_end = swept_inside(std::fabs(ray.q));
        if (sky)
            ray.phi_end += table_->through_from_infinity(k, d2, M_PI);
        else if (k > 0.0 && omk2 > 0.0 && ray.slope < 0.0)
            ray.phi_end += table_->turning_to_horizon(k, omk2, M_PI);  // out, and back
        return ray;
    }
    // The angle that a camera at rest here sees: from the outward and from the inward radial.
    double alpha = 2.0 * std::atan(lapse_ * t / o), beta = 2.0 * std::atan(o / (lapse_ * t));
    if (v_sky_ < 0.0) {  // sin(chi0) = k sin(alpha) of the table's k
        const double root = std::sin(chi0_) * q_crit_ / std::sqrt(of_range_);
        alpha = std::atan2(root, -ray.slope), beta = std::atan2(root, ray.slope);
    }
    if (!sky && chi_end_ < M_PI) {
        ray.phi_end = to_surface(k, omk2, one_minus_kd2, alpha, beta);
    } else if (omk2 > 0.0) {
        ray.phi_end = sky ? table_->turning_to_sky(k, omk2, alpha) : table_->turning_to_horizon(k, omk2, beta);
    } else {
        ray.tube_slope = std::sqrt(d2);
        const double from_infinity = table_->through_from_infinity(k, d2, chi0_);
        ray.phi_end = (sky ? from_infinity : table_->through_from_infinity(k, d2, M_PI) - from_infinity) +
                      (ray.in_tube = std::min((sky ? tube_out_ : tube_in_) / std::sqrt(d2), kMostInTube));
    }
    return ray;
}

double RayFamily::swept(Segment segment, const FanRay& ray, double d) const {
    if (barrier_) return bounce_to_sky(*barrier_, zeta0_, ray.q, d, ray.slope);
    const SweptRay one{r_, ray.q, d, ray.slope};
    const bool back = segment == Segment::kSky || potential_->comes_back;
    return back ? swept_to_sky(*potential_, one) : swept_to_end(*potential_, one);
}

// At the surface sin(beta) = sin(chi_end)/k. Where rays graze it that is 1/k_d, and the cosine a product.
double RayFamily::to_surface(double k, double one_minus_k2, double one_minus_kd2, double alpha, double beta) const {
    if (one_minus_k2 <= 0.0) {
        const double d2 = std::max(-one_minus_k2, kNoAngle);
        return table_->through_from_infinity(k, d2, chi_end_) - table_->through_from_infinity(k, d2, chi0_);
    }
    const double sine = std::sin(chi_end_) / k;
    if (!grazes_)
        return table_->turning_to_horizon(k, one_minus_k2, beta) -
               table_->turning_to_horizon(k, one_minus_k2,
                                          std::atan2(sine, std::sqrt(std::max((1.0 - sine) * (1.0 + sine), 0.0))));
    const double there = M_PI - std::atan2(1.0, std::sqrt(std::max(-one_minus_kd2, 0.0)));
    return table_->turning_to_sky(k, one_minus_k2, alpha) - table_->turning_to_sky(k, one_minus_k2, there);
}

double RayFamily::half_tangent_inward(double q) const {
    const double reach = q * radius_;
    return (reach + std::sqrt(std::max((reach - lapse_) * (reach + lapse_), 0.0))) / frame_.inward;
}

// dphi = dzeta / sqrt(q^2 - V) = 2 x dx / sqrt(q^2 - V), zeta = zeta_h + x^2 in the outer half and zeta0 - x^2 in the inner one: regular
// where q -> 0 at the horizon, and within an inner horizon where the ray turns at the camera; but bent where x is near the root at that
// end. Panels that double from there on: within 1e-12 (tests/unit/test_ray_family.cpp).
double RayFamily::swept_inside(double q) const {
    if (!inside_) return 0.0;
    const double zeta_h = 1.0 / *spacetime_->horizon_radius(), half = 0.5 * std::max(zeta0_ - zeta_h, 0.0);
    const auto root = [&](double zeta) {
        return std::sqrt(std::max(q * q - spacetime_->lapse_squared(1.0 / zeta) * zeta * zeta, kNoAngle));
    };
    double sum = 0.0;
    for (const double side : {1.0, -1.0}) {
        const double from = side > 0.0 ? zeta_h : zeta0_, end = std::sqrt(half);
        double low = 0.0;
        for (double high = std::clamp(0.125 * root(from), 1e-6, 0.125); low < end; high *= 2.0) {
            sum += gauss(low, std::min(high, end), [&](double x) { return 2.0 * x / root(from + side * x * x); });
            low = high;
        }
    }
    return sum;
}

}  // namespace nullscope
