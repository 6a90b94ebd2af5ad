#include "compare/ray_errors.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace nullscope {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

// Of an error's length: less out of the plane of the motions is rounding of that plane.
constexpr double kOffPlane = 1e-9;

struct Plane2 {
    double x = 0, y = 0;
};

// error over the motion per pixel, part by part along the principal directions of the motion; each motion at least `least`.
float in_pixels(Plane2 error, Plane2 by_x, Plane2 by_y, double least) {
    const double xx = by_x.x * by_x.x + by_y.x * by_y.x, yy = by_x.y * by_x.y + by_y.y * by_y.y;
    const double xy = by_x.x * by_x.y + by_y.x * by_y.y;
    const double turn = 0.5 * std::atan2(2 * xy, xx - yy), c = std::cos(turn), s = std::sin(turn);
    const double major = std::sqrt(std::max(0.0, c * c * xx + 2 * c * s * xy + s * s * yy));
    const double minor = std::sqrt(std::max(0.0, s * s * xx - 2 * c * s * xy + c * c * yy));
    const auto part = [&](double value, double motion) {
        return value == 0 ? 0.0 : std::abs(value) / std::max(motion, least);
    };
    const double px = std::hypot(part(c * error.x + s * error.y, major), part(c * error.y - s * error.x, minor));
    return std::isfinite(px) ? static_cast<float>(px) : kInfinite;
}

float in_pixels(double error, double by_x, double by_y, double least) {
    if (error == 0) return 0;
    const double px = std::abs(error) / std::max(std::sqrt(by_x * by_x + by_y * by_y), least);
    return std::isfinite(px) ? static_cast<float>(px) : kInfinite;
}

double plain_length(Vec3 v) { return std::sqrt(dot(v, v)); }

// The plane that touches the sphere of directions at `middle`; directions become (angle, bearing).
class Chart {
public:
    explicit Chart(Vec3 middle) : middle_(middle) {
        const double x = std::abs(middle.x), y = std::abs(middle.y), z = std::abs(middle.z);
        const Vec3 axis = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
        const Vec3 across = cross(middle, axis);
        a_ = across / plain_length(across);
        b_ = cross(middle, a_);
    }
    Plane2 place(Vec3 direction) const {
        const double x = dot(direction, a_), y = dot(direction, b_), off = std::sqrt(x * x + y * y);
        if (off == 0) return dot(direction, middle_) < 0 ? Plane2{M_PI, 0} : Plane2{};
        const double scale = std::atan2(off, dot(direction, middle_)) / off;
        return {x * scale, y * scale};
    }

private:
    Vec3 middle_, a_, b_;
};

Plane2 per_pixel(Plane2 moved, double px) { return px == 0 ? Plane2{} : Plane2{moved.x / px, moved.y / px}; }
double per_pixel(double moved, double px) { return px == 0 ? 0.0 : moved / px; }

void sky_errors(const RayPixel& tested, const ExactPixel& exact, PixelErrors& errors) {
    const Chart chart(exact.here.sky);
    const Plane2 error = chart.place(tested.sky);
    const double angle = std::sqrt(error.x * error.x + error.y * error.y);
    errors.forward_rad = std::isfinite(angle) ? static_cast<float>(angle) : kInfinite;
    const Plane2 by_x = per_pixel(chart.place(exact.right.sky), exact.right_px);
    const Plane2 by_y = per_pixel(chart.place(exact.down.sky), exact.down_px);
    errors.sky_px = in_pixels(error, by_x, by_y, exact.pixel_angle);
    const auto moved = [&](const RayPixel& beside) { return std::log(beside.g / exact.here.g); };
    const double log_g = std::log(tested.g / exact.here.g);
    errors.g_px = std::isfinite(log_g) ? in_pixels(log_g, per_pixel(moved(exact.right), exact.right_px),
                                                   per_pixel(moved(exact.down), exact.down_px), exact.pixel_angle)
                                       : kInfinite;
}

// Of a star: the angle between the places as seen from its centre, against how far they move per pixel.
float star_error(const RayPixel& tested, const ExactPixel& exact) {
    const auto place = [](const RayPixel& p) {
        return Vec3{std::cos(p.v) * std::cos(p.u), std::cos(p.v) * std::sin(p.u), std::sin(p.v)};
    };
    const Chart chart(place(exact.here));
    return in_pixels(chart.place(place(tested)), per_pixel(chart.place(place(exact.right)), exact.right_px),
                     per_pixel(chart.place(place(exact.down)), exact.down_px), exact.pixel_angle);
}

Vec3 hit_place(const RayPixel& p) { return {p.u, p.v, p.w}; }
Vec3 unit_or(Vec3 v, Vec3 fallback) {
    const double size = plain_length(v);
    return size > 0 ? v / size : fallback;
}

// In the plane of the two motions, and across it (where nothing moves, one pixel without lensing is the measure).
float place_error(const RayPixel& tested, const ExactPixel& exact) {
    if (exact.here.hit == kStarHit) return star_error(tested, exact);
    const Vec3 here = hit_place(exact.here);
    const auto motion = [&](const RayPixel& beside, double px) {
        return px == 0 ? Vec3{} : (hit_place(beside) - here) / px;
    };
    const Vec3 by_x = motion(exact.right, exact.right_px), by_y = motion(exact.down, exact.down_px);
    const bool x_longer = plain_length(by_x) >= plain_length(by_y);
    const Vec3 longer = x_longer ? by_x : by_y, other = x_longer ? by_y : by_x;
    const Vec3 a = unit_or(longer, {1, 0, 0}), any = std::abs(a.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 b = unit_or(other - dot(other, a) * a, unit_or(any - dot(any, a) * a, {0, 1, 0})), n = cross(a, b);
    const auto flat = [&](Vec3 v) { return Plane2{dot(v, a), dot(v, b)}; };
    const Vec3 error = hit_place(tested) - here;
    const double least = exact.pixel_angle * length(exact.camera - here);
    const float within = in_pixels(flat(error), flat(by_x), flat(by_y), least);
    const float off =
        in_pixels(std::abs(dot(error, n)) < kOffPlane * plain_length(error) ? 0.0 : dot(error, n), 0, 0, least);
    return std::hypot(within, off);
}

}  // namespace

float PixelErrors::worst_px() const {
    if (end == RayEnd::kDiffers) return kInfinite;
    if (end != RayEnd::kSame) return 0;
    return std::max({sky_px, place_px, angle_px, g_px});
}

float PixelErrors::screen_px() const {
    if (end == RayEnd::kDiffers) return kInfinite;
    return end == RayEnd::kSame ? std::max(sky_px, place_px) : 0;
}

bool same_end(const RayPixel& a, const RayPixel& b) { return a.fate == b.fate && a.hit == b.hit; }

bool all_finite(const RayPixel& p) {
    for (const double value : {p.sky.x, p.sky.y, p.sky.z, p.g, p.delay, p.angle, p.u, p.v, p.w})
        if (!std::isfinite(value)) return false;
    return true;
}

PixelErrors pixel_errors(const RayPixel& tested, const ExactPixel& exact) {
    PixelErrors errors;
    if (!same_end(tested, exact.here)) {
        errors.end = RayEnd::kDiffers;
        return errors;
    }
    errors.end = RayEnd::kSame;
    errors.escaped = exact.here.fate == Fate::kEscaped || exact.here.fate == Fate::kOtherSide;
    errors.hit = exact.here.hit != 0;
    if (errors.escaped) sky_errors(tested, exact, errors);
    if (errors.hit) errors.place_px = place_error(tested, exact);
    const double angle = exact.here.angle;
    errors.angle_px = in_pixels(tested.angle - angle, per_pixel(exact.right.angle - angle, exact.right_px),
                                per_pixel(exact.down.angle - angle, exact.down_px), exact.pixel_angle);
    return errors;
}

Spread spread_of(std::vector<float> values) {
    Spread spread;
    spread.count = values.size();
    if (values.empty()) return spread;
    for (float& value : values)
        if (std::isnan(value)) value = kInfinite;
    auto end = values.end();
    const auto rank =
        [&](double fraction) {  // fractions in falling order: each search is among the smaller values only
            const auto n = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(values.size())));
            const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(n, 1) - 1);
            if (nth != end) std::nth_element(values.begin(), nth, end);
            end = nth;
            return static_cast<double>(*nth);
        };
    spread.max = *std::max_element(values.begin(), values.end());
    spread.p999 = rank(0.999);
    spread.median = rank(0.5);
    return spread;
}

}  // namespace nullscope
