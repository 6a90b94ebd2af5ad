#include "table/star_lens.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace nullscope {
namespace {

constexpr int kPerOctave = 32;           // samples of the family
constexpr int kPoints = 6;               // of the polynomial through samples
constexpr double kLeastPhi = 1e-3;       // rad; T tan(Phi/2) is even in Phi: 1e-6 of it are left
constexpr double kLeastEinstein = 1e-9;  // of T, where nothing bends: any number serves

struct FanSample {
    double phi, tangent;  // tan(theta/2)
};

// Rays of the family from almost the outward radial to the last winding, phi growing.
std::vector<FanSample> family_samples(const RayFamily& family, double last_phi) {
    const double limit = family.delta_limit(Segment::kSky);
    std::vector<FanSample> samples;
    for (int i = family.octaves(Segment::kSky) * kPerOctave; i >= 1; --i) {
        const double u = std::exp2(i / kPerOctave) * (1.0 + double(i % kPerOctave) / kPerOctave);
        const double delta = family.delta_at(u);
        if (delta >= limit) continue;
        const FanRay ray = family.ray(Segment::kSky, delta);
        samples.push_back({ray.phi_end, std::tan(0.5 * ray.beta)});
        if (ray.phi_end > last_phi + 0.5) break;
    }
    return samples;
}

double x_of(double phi, double einstein) {
    const double b = phi < M_PI ? -1.0 / std::tan(0.5 * phi) : 0.5 * (phi - M_PI);
    return std::asinh(0.5 * b / einstein);
}

// x and y = ln(T/E).
struct Sample {
    double x, y;
};

struct Place {
    double y, slope, bend;  // y, dy/dx, d2y/dx2
};

// The polynomial through six samples about x, and its derivatives (Lagrange's form, each factor by the product rule).
Place at(const std::vector<Sample>& samples, double x) {
    const auto above =
        std::lower_bound(samples.begin(), samples.end(), x, [](const Sample& s, double p) { return s.x < p; });
    const std::ptrdiff_t next = above - samples.begin(), most = std::ssize(samples) - kPoints;
    const Sample* s = samples.data() + std::clamp(next - kPoints / 2, std::ptrdiff_t{0}, most);
    Place place{0.0, 0.0, 0.0};
    for (int i = 0; i < kPoints; ++i) {
        double weight = 1.0, slope = 0.0, bend = 0.0;
        for (int j = 0; j < kPoints; ++j) {
            if (j == i) continue;
            const double by = 1.0 / (s[i].x - s[j].x), factor = (x - s[j].x) * by;
            bend = bend * factor + 2.0 * slope * by;
            slope = slope * factor + weight * by;
            weight *= factor;
        }
        place.y += weight * s[i].y;
        place.slope += slope * s[i].y;
        place.bend += bend * s[i].y;
    }
    return place;
}

}  // namespace

TexelGrid star_lens_row(const RayFamily& family) {
    const std::vector<FanSample> rays = family_samples(family, kStarImages * M_PI);
    // T at Phi = pi, to a few per cent; of the last ray where none is turned that far.
    const auto ring = std::find_if(rays.begin(), rays.end() - 1, [](const FanSample& ray) { return ray.phi >= M_PI; });
    const double einstein = std::max(ring->tangent, kLeastEinstein);
    std::vector<Sample> samples;
    for (const FanSample& ray : rays) {
        const double x = x_of(ray.phi, einstein);
        if (samples.empty() || x > samples.back().x) samples.push_back({x, std::log(ray.tangent / einstein) + x});
    }
    const double first = x_of(kLeastPhi, einstein);
    const double last = x_of(std::min(kStarImages * M_PI, rays.back().phi), einstein);
    const double per_x = kStarLensCells / (last - first);
    TexelGrid row{kStarLensCells + 2, 1, {}};
    const auto put = [&](std::initializer_list<double> texel) {
        for (const double value : texel) row.texels.push_back(static_cast<float>(value));
    };
    for (int i = 0; i <= kStarLensCells; ++i) {
        const Place place = at(samples, first + i / per_x);
        const double ratio = std::exp(place.y);
        put({ratio, ratio * place.slope / per_x, 1.0 - place.slope, -place.bend / per_x});
    }
    put({einstein, first, per_x, 0.0});
    return row;
}

}  // namespace nullscope
