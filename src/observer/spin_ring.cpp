#include "observer/spin_ring.h"

#include <cmath>

#include "observer/lorentz.h"
#include "observer/pose.h"
#include "observer/spin_forms.h"
#include "scene/projection.h"

namespace nullscope {
namespace {

constexpr int kNodes = 6;                 // Chebyshev's, each way
constexpr double kSmallestFitted = 1e-4;  // e: of smaller views as much is fitted, far above rounding

class Peaks {
public:
    Peaks(const Spacetime& spacetime, const CameraSpec& camera, const Observer& observer, const LightSpec& light)
        : rays_(spacetime, camera, observer),
          pixel_(camera.pixel()),
          axes_(observer.turn * static_from_camera(camera)),
          seen_from_(boost(light.aberration ? observer.velocity : Vec3{})) {}

    double at(double x, double y) const { return barrier(x, y).peak; }

    // e
    double distance(double x, double y) const { return barrier(x, y).distance(); }
    double pixel() const { return pixel_; }

private:
    RingOfRays::Barrier barrier(double x, double y) const {
        const Vec3 seen = normalized(axes_ * Vec3{x * pixel_, y * pixel_, -1.0});
        const std::array<double, 4> photon{1.0, -seen.x, -seen.y, -seen.z};
        double k[4]{};
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) k[i] += seen_from_[i][j] * photon[j];
        return rays_.of(Vec3{-k[1], -k[2], -k[3]} / k[0]);
    }

    RingOfRays rays_;
    double pixel_;
    Mat3 axes_;
    Lorentz seen_from_;
};

// By Chebyshev's polynomials in x and in y up to the third degree together, then by powers. reach: px.
std::array<double, 10> fitted(const Peaks& peaks, double reach) {
    double sums[4][4]{};
    for (int i = 0; i < kNodes; ++i)
        for (int j = 0; j < kNodes; ++j) {
            const double s = M_PI * (i + 0.5) / kNodes, t = M_PI * (j + 0.5) / kNodes,
                         value = peaks.at(reach * std::cos(s), reach * std::cos(t));
            for (int m = 0; m < 4; ++m)
                for (int n = 0; m + n < 4; ++n)
                    sums[m][n] += value * std::cos(m * s) * std::cos(n * t) * (m == 0 ? 1 : 2) * (n == 0 ? 1 : 2) /
                                  (kNodes * kNodes);
        }
    const auto& c = sums;
    const double one = 1.0 / reach, two = one * one, three = two * one;
    return {c[0][0] - c[2][0] - c[0][2],
            one * (c[1][0] - 3.0 * c[3][0] - c[1][2]),
            one * (c[0][1] - 3.0 * c[0][3] - c[2][1]),
            two * 2.0 * c[2][0],
            two * c[1][1],
            two * 2.0 * c[0][2],
            three * 4.0 * c[3][0],
            three * 2.0 * c[2][1],
            three * 2.0 * c[1][2],
            three * 4.0 * c[0][3]};
}

double value_of(const std::array<double, 10>& c, double x, double y) {
    return c[0] + x * (c[1] + x * (c[3] + x * c[6] + y * c[7]) + y * (c[4] + y * c[8])) +
           y * (c[2] + y * (c[5] + y * c[9]));
}

// Of e a pixel, at most; by differences that are small beside the hole and far above rounding.
double ring_slope(const Peaks& peaks) {
    constexpr double kFirst = 1e-6, kMostChange = 1e-3;  // rad, e
    for (double step = kFirst / peaks.pixel();; step *= 0.1) {
        const double change = std::hypot(peaks.distance(step, 0) - peaks.distance(-step, 0),
                                         peaks.distance(0, step) - peaks.distance(0, -step));
        if (change < kMostChange || step < 1e-3) return change / (2.0 * step);
    }
}

}  // namespace

RingOfRays::RingOfRays(const Spacetime& spacetime, const CameraSpec& camera, const Observer& observer) {
    const AxialMetric& metric = *spacetime.axial();
    place_ = spin_place(metric, camera.r, camera.theta);
    forms_ = spin_forms(place_, {observer.frame, observer.azimuthal_velocity});
    charge2_ = metric.charge2();
}

// As shaders/mino/ring.glsl has it in float.
RingOfRays::Barrier RingOfRays::of(Vec3 n) const {
    const double a = place_.a, energy = forms_.energy.of(n.x, n.z), across = forms_.across.of(n.x, n.z),
                 w = forms_.carter + forms_.carter_slope * n.z, p_theta = forms_.p_theta * n.y, ae = a * energy,
                 k = p_theta * p_theta + w * w, cosine2 = place_.cosine * place_.cosine,
                 pull = p_theta * p_theta + across * across - ae * ae * (1.0 + cosine2),
                 quartic = a * a * (p_theta * p_theta + cosine2 * (across * across - ae * ae)) + charge2_ * k,
                 root = std::sqrt(std::fmax(2.25 * k * k - 8.0 * quartic * pull, 0.0)),
                 zeta = 2.0 * pull / (1.5 * k + root);
    return {energy * energy - zeta * zeta * zeta * (0.5 * k - quartic * zeta), zeta * zeta * zeta * root};
}

double ring_distance_per_pixel(const Spacetime& spacetime, const CameraSpec& camera, const Observer& observer,
                               const LightSpec& light) {
    return ring_slope(Peaks(spacetime, camera, observer, light));
}

bool is_next_to_ring(const Spacetime& spacetime, const CameraSpec& camera, const Observer& observer,
                     const LightSpec& light) {
    const Peaks peaks(spacetime, camera, observer, light);
    const double slope = ring_slope(peaks), corner = 2.0 * reach_px(camera);
    return slope < kNarrow && std::fabs(peaks.distance(0, 0)) < slope * corner;
}

bool is_hard_ring(const Spacetime& spacetime, double camera_r) {
    return 2.0 * std::fabs(spacetime.a()) > kRingFastest || camera_r < *spacetime.horizon_radius() + kRingNearest;
}

std::optional<PeakForm> peak_form(const AxialMetric& metric, const CameraSpec& camera, const Observer& observer,
                                  const LightSpec& light) {
    const Peaks peaks(metric, camera, observer, light);
    const auto [half_width, half_height] = reach(camera);
    const double diagonal = reach_px(camera);
    if (!(diagonal * camera.pixel() < 0.5)) return std::nullopt;
    const double fitted_px = kSmallestFitted / ring_slope(peaks);
    PeakForm form{fitted(peaks, std::fmax(diagonal, fitted_px))};
    form.c[0] = peaks.at(0, 0);
    if (fitted_px > diagonal) return form;
    double off_px = 0;
    const double slope = std::hypot(form.c[1], form.c[2]);
    for (const double x : {-1.0, -0.6, 0.0, 0.6, 1.0})
        for (const double y : {-1.0, -0.6, 0.0, 0.6, 1.0}) {
            const double right = x * half_width, up = y * half_height;
            off_px = std::fmax(off_px, std::fabs(value_of(form.c, right, up) - peaks.at(right, up)) / slope);
        }
    return off_px <= kPeakOff_px ? std::optional(form) : std::nullopt;
}

}  // namespace nullscope
