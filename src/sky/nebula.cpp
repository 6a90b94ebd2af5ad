#include "sky/nebula.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

constexpr int kMostCells = 512;  // a side of a face: 0.1 to 0.2 degrees, the finest octave's size
constexpr int kHotStars = 9;
constexpr int kStars = 26000;
constexpr double kBrightest = 2.2, kFaintest = 9.6;  // V of the field's stars
constexpr double kCountSlope = 0.44;                 // of log10 N(V), as in our sky's disc

double smooth_step(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

unsigned colour_code(double b_minus_v) {
    return static_cast<unsigned>(
        std::clamp(std::lround((b_minus_v + 0.5) * 100.0), 0L, static_cast<long>(kColourCodes - 2)));
}

constexpr Vec3 kShift1{3.1, 7.7, 1.9}, kShift2{13.4, 2.6, 9.2},
    kShift3{5.8, 19.3, 23.1};  // into other parts of the noise

}  // namespace

Nebula::Nebula(const NebulaSpec& spec, const Mat3& world_from_sky, double brightness, int size, int border)
    : spec_(spec), grid_(world_from_sky, size, border, kMostCells), brightness_(brightness), noise_([&] {
          SeededRandom random(static_cast<std::uint64_t>(spec.seed));
          return LatticeNoise(random);
      }()) {
    SeededRandom random(static_cast<std::uint64_t>(spec.seed) + 1000003u);
    // Hot stars are born where gas is dense: of many places about the heart the densest, apart from each other.
    for (int i = 0; i < kHotStars; ++i) {
        Vec3 best = heart_;
        double most = -1.0;
        for (int k = 0; k < 60; ++k) {
            const Vec3 place = normalized(heart_ + (0.15 + 0.12 * i) * random.direction());
            double near = 0.0;
            for (const HotStar& other : hot_) near = std::max(near, 1.0 - angle_between(other.direction, place) / 0.35);
            const Matter there = matter(place);
            const double worth = there.gas * std::exp(-0.5 * there.dust) - near;
            if (worth > most) most = worth, best = place;
        }
        const double strength = i == 0 ? 1.0 : 0.25 + 0.6 * random.next();
        hot_.push_back({best, strength, 0.10 + 0.16 * strength, 4.0 - 2.2 * strength});
    }
}

Nebula::Matter Nebula::matter(Vec3 d) const {
    const double off = std::max(2.0 - 2.0 * dot(d, heart_), 0.0);  // 0 at the heart, 4 opposite
    const double wide =
        smooth_step(0.30, 0.80, 0.62 * noise_.fractal(1.3 * d + kShift1, 3) + 0.52 * std::exp(-1.1 * off));
    if (wide == 0.0) return {0.0, 0.0, 0.0, 0.0};
    const Vec3 warp{noise_.fractal(1.7 * d + kShift2, 3) - 0.5, noise_.fractal(1.7 * d + kShift3, 3) - 0.5,
                    noise_.fractal(1.7 * d + kShift1 + kShift3, 3) - 0.5};
    const Vec3 q = 2.3 * d + 2.1 * warp;
    const double gas = wide * smooth_step(0.30, 0.72, noise_.fractal(q, 6));
    const double ridges = noise_.ridged(2.2 * q + kShift2, 6);
    const double lanes = noise_.fractal(1.9 * q + kShift3, 6), fine = noise_.ridged(1.5 * q + kShift1, 4);
    const double dust = wide * (3.4 * smooth_step(0.50, 0.72, lanes) + 1.6 * smooth_step(0.45, 0.85, fine));
    return {gas, ridges, dust, wide};
}

Vec3 Nebula::light(Vec3 d) const {
    const Matter there = matter(d);
    double lit = 0.0, near = 0.0;
    for (const HotStar& star : hot_) {
        const double off = std::max(2.0 - 2.0 * dot(d, star.direction), 0.0) / (star.reach * star.reach);
        lit += star.light / (1.0 + off);
        near += star.light * std::exp(-0.6 * off);
    }
    const double filaments = std::pow(there.ridges, 1.5);
    const double emission = there.gas * (0.15 + 2.6 * filaments) * (0.14 + 1.5 * lit);
    const double oxygen = there.gas * (0.45 + 1.6 * filaments) * near;
    const double hydrogen = emission * (1.0 - 0.75 * std::min(near, 1.0)) + 0.010 * there.wide;
    const double scattered = 0.10 * there.gas * lit * (0.2 + filaments) * (1.0 - std::exp(-there.dust));
    const Vec3 bright = 0.42 * hydrogen * spec_.hydrogen + 0.55 * oxygen * spec_.oxygen;
    const auto through = [&](double share) { return std::exp(-share * there.dust); };
    const Vec3 seen{bright.x * through(0.72), bright.y * through(1.0), bright.z * through(1.25)};
    constexpr Vec3 kScattered{0.45, 0.62, 1.0},
        kDark{0.0012, 0.0015, 0.0024};  // light of hot stars on dust; of what is far behind
    return seen + scattered * kScattered + kDark;
}

void Nebula::paint(SkyRows& rows) const {
    grid_.paint(rows, [&](Vec3 first, Vec3 step, std::size_t count, float* out) {
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3 c = brightness_ * light(normalized(first + static_cast<double>(i) * step));
            out[i] = static_cast<float>(c.x), out[count + i] = static_cast<float>(c.y),
            out[2 * count + i] = static_cast<float>(c.z);
        }
    });
}

std::vector<Star> Nebula::stars() const {
    SeededRandom random(static_cast<std::uint64_t>(spec_.seed) + 2000003u);
    std::vector<Star> stars;
    for (const HotStar& hot : hot_) stars.push_back({hot.direction, hot.magnitude, colour_code(-0.28)});
    const double range = std::pow(10.0, kCountSlope * (kBrightest - kFaintest));
    for (int i = 0; i < kStars; ++i) {
        const Vec3 place = random.direction();
        const double magnitude = kFaintest + std::log10(range + (1.0 - range) * random.next()) / kCountSlope;
        const double kind = random.next(), spread = random.next();
        const double colour = kind < 0.25   ? -0.25 + 0.3 * spread
                              : kind < 0.65 ? 0.1 + 0.6 * spread
                                            : 0.8 + 0.9 * spread * spread;
        const double dust = matter(place).dust * random.next();  // some lie before it
        stars.push_back({place, magnitude + 1.086 * dust, colour_code(colour + 0.3 * dust)});
    }
    std::stable_sort(stars.begin(), stars.end(),
                     [](const Star& a, const Star& b) { return a.magnitude < b.magnitude; });
    return stars;
}

}  // namespace nullscope
