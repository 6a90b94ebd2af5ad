#include "table/ray_fan.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nullscope {

namespace {
constexpr double kMostInTube = 1e6;    // rad; more windings than a float tells apart
constexpr double kRadialFloor = 1e-9;  // rad; ratios such as phi/sin(beta) have reached their limit to 1e-17 there
}

RayFan::RayFan(std::shared_ptr<const Spacetime> spacetime, std::shared_ptr<const DeflectionTable> table, double r, double pixel)
    : spacetime_(std::move(spacetime)), table_(std::move(table)), zeta0_(1.0 / spacetime_->areal_radius(r)) {
    sqrt_v0_ = spacetime_->root_v(r);
    if (const auto wall = spacetime_->wall()) {
        start_at_wall(*wall);
    } else {
        chi0_ = spacetime_->chi_from_radius(r);
        q_crit_ = spacetime_->photon_sphere()->q_crit;
        outside_ = chi0_ <= M_PI / 2;
        theta_c_ = outside_ ? std::min(chi0_, M_PI / 2) : std::asin(std::min(1.0, sqrt_v0_ / q_crit_));
    }
    tube_out_ = spacetime_->tube_beyond(r);
    tube_in_ = spacetime_->tube_beyond(-kAnyRadius) - tube_out_;
    if (const auto surface = spacetime_->surface_radius()) {
        chi_end_ = spacetime_->chi_from_radius(*surface);
        grazes_ = chi_end_ < M_PI / 2;   // the surface hides the photon sphere: V(surface) is what divides
        if (grazes_)
            theta_c_ = std::atan2(std::sin(chi0_), std::sqrt(std::sin(chi_end_ - chi0_) * std::sin(chi_end_ + chi0_)));
    }
    const double scale = theta_c_ > 0.0 ? theta_c_ : 1.0;
    const double wanted = std::clamp(kPixelPart * pixel / scale, kFinest, kResolution);
    w0_ = kResolution * std::exp2(4.0 * std::floor(0.25 * std::log2(wanted / kResolution))) * scale;
}

// V(zeta0) - V(zeta_d) by the wall's own polynomial: sin^2(theta_c) = V(zeta0)/V(zeta_d), cosine as a product.
void RayFan::start_at_wall(const Wall& wall) {
    const double x = zeta0_ - wall.zeta;
    bounce_.emplace(wall, zeta0_);
    wall_v_ = wall.v;
    over_wall_ = x * (wall.c[0] + x * (wall.c[1] + x * (wall.c[2] + x * wall.c[3])));
    q_crit_ = std::sqrt(wall.v);
    outside_ = true;
    theta_c_ = x < 0.0 ? std::atan2(sqrt_v0_, std::sqrt(std::max(-over_wall_, 0.0))) : 0.0;
    chi0_ = theta_c_;
}

double RayFan::delta_limit(Segment segment) const {
    return outside_ == (segment == Segment::kSky) ? M_PI - theta_c_ : theta_c_;
}

double RayFan::mirrored(Segment segment, double delta) const {
    const double limit = delta_limit(segment);
    return delta <= limit ? delta : std::max(2.0 * limit - delta, 1e-3 * w0());
}

FanRay RayFan::tube_ray(Segment segment, double delta) const {
    const bool sky = segment == Segment::kSky;
    const double theta = std::clamp(outside_ == sky ? theta_c_ + delta : theta_c_ - delta, kRadialFloor, M_PI - kRadialFloor);
    FanRay ray{};
    ray.sin_beta = std::sin(theta);
    const double d2 = (outside_ == sky ? -1.0 : 1.0) * std::sin(delta) * std::sin(theta + theta_c_) / (ray.sin_beta * ray.sin_beta);
    if (d2 > 0.0) ray.in_tube = std::min((sky ? tube_out_ : tube_in_) / std::sqrt(d2), kMostInTube);
    return ray;
}

double RayFan::delta_slope(double u) const {
    const double half_w = 0.5 * w0() * (u - 1.0);
    return w0() / (1.0 + half_w * half_w);
}

int RayFan::octaves(Segment segment) const {
    return static_cast<int>(std::floor(std::log2(1.0 + 2.0 * std::tan(0.5 * delta_limit(segment)) / w0()))) + 1;
}

FanRay RayFan::ray(Segment segment, double delta) const {
    const bool sky = segment == Segment::kSky;
    // Angle from the radial direction that the critical angle is measured from, then from the inward radial.
    const double theta = std::clamp(outside_ == sky ? theta_c_ + delta : theta_c_ - delta, kRadialFloor, M_PI - kRadialFloor);
    FanRay ray{};
    ray.beta = outside_ ? theta : M_PI - theta;
    ray.sin_beta = std::sin(theta);
    ray.cos_beta = outside_ ? std::cos(theta) : -std::cos(theta);
    const double sin_c = std::sin(theta_c_);
    const double k = (grazes_ ? std::sin(chi0_) : sin_c) / ray.sin_beta;
    const double signed_delta = grazes_ ? theta - chi0_ : outside_ == sky ? delta : -delta;                   // theta - theta_c
    const double one_minus_k2 = std::sin(signed_delta) * std::sin(theta + (grazes_ ? chi0_ : theta_c_)) / (ray.sin_beta * ray.sin_beta);
    if (bounce_) {
        const double q = sqrt_v0_ / ray.sin_beta;
        // q^2 - V(zeta_d): a product next to the critical direction; q^2 cos^2 + V(zeta0) - V(zeta_d) where there is none.
        const double d = theta_c_ > 0.0 ? -wall_v_ * one_minus_k2 : q * ray.cos_beta * q * ray.cos_beta + over_wall_;
        ray.phi_end = bounce_->to_sky(d == 0.0 ? 1e-300 : d, q * ray.cos_beta);
        return ray;
    }
    const double alpha = M_PI - ray.beta;
    if (!sky && chi_end_ < M_PI) {
        ray.phi_end = to_surface(ray, k, one_minus_k2, delta);
    } else if (one_minus_k2 > 0.0) {
        ray.phi_end = sky ? table_->turning_to_sky(k, one_minus_k2, alpha) : table_->turning_to_horizon(k, one_minus_k2, ray.beta);
    } else {
        const double d2 = std::max(-one_minus_k2, 1e-300);
        const double from_infinity = table_->through_from_infinity(k, d2, chi0_);
        ray.phi_end = (sky ? from_infinity : table_->through_from_infinity(k, d2, M_PI) - from_infinity) +
                      (ray.in_tube = std::min((sky ? tube_out_ : tube_in_) / std::sqrt(d2), kMostInTube));
    }
    return ray;
}

// At the surface sin(beta) = sin(chi_end)/k. Where rays graze it that is sin(beta)/sin(theta_c), and the cosine a product.
double RayFan::to_surface(const FanRay& ray, double k, double one_minus_k2, double delta) const {
    if (one_minus_k2 <= 0.0) {
        const double d2 = std::max(-one_minus_k2, 1e-300);
        return table_->through_from_infinity(k, d2, chi_end_) - table_->through_from_infinity(k, d2, chi0_);
    }
    const double sine = std::sin(chi_end_) / k;
    if (!grazes_) return table_->turning_to_horizon(k, one_minus_k2, ray.beta) -
                         table_->turning_to_horizon(k, one_minus_k2, std::atan2(sine, std::sqrt(std::max((1.0 - sine) * (1.0 + sine), 0.0))));
    const double cosine = std::sqrt(std::sin(delta) * std::sin(theta_c_ + ray.beta)) / std::sin(theta_c_);
    const double there = M_PI - std::atan2(sine, cosine);
    return table_->turning_to_sky(k, one_minus_k2, M_PI - ray.beta) - table_->turning_to_sky(k, one_minus_k2, there);
}

}  // namespace nullscope
