#include "table/star_lens.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nullscope {
namespace {

constexpr int kPerOctave = 32;   // samples of the fan

struct Sample {
    double phi, alpha;
};

// Rays of the fan from the radial direction (phi = 0) to the last winding, phi growing.
std::vector<Sample> samples_of(const RayFan& fan, double last_phi) {
    const int count = fan.octaves(Segment::kSky) * kPerOctave;
    const double limit = fan.delta_limit(Segment::kSky);
    // Beyond the radial ray the fan goes on as its own mirror image, so that slopes there have neighbours on both sides.
    std::vector<Sample> samples;
    for (int i = count; i >= 1; --i) {
        const double u = std::exp2(i / kPerOctave) * (1.0 + double(i % kPerOctave) / kPerOctave), delta = fan.delta_at(u);
        if (delta >= limit) continue;
        const FanRay ray = fan.ray(Segment::kSky, delta);
        samples.push_back({ray.phi_end, M_PI - ray.beta});
        if (ray.phi_end > last_phi + 0.5) break;
    }
    std::vector<Sample> all;
    for (std::size_t i = std::min<std::size_t>(8, samples.size()); i-- > 0;) all.push_back({-samples[i].phi, -samples[i].alpha});
    all.push_back({0.0, 0.0});
    all.insert(all.end(), samples.begin(), samples.end());
    return all;
}

struct Place {
    double alpha, slope;
};

// Beyond the last sample there is nothing to see: no slope. Else the polynomial through six samples about phi, and its derivative (Lagrange's form).
Place at(const std::vector<Sample>& samples, double phi) {
    if (phi > samples.back().phi) return {samples.back().alpha, 0.0};
    const auto above = std::lower_bound(samples.begin(), samples.end(), phi, [](const Sample& s, double p) { return s.phi < p; });
    const long next = above - samples.begin(), most = static_cast<long>(samples.size()) - 6;
    const Sample* s = samples.data() + std::clamp(next - 3, 0L, most);
    Place place{0.0, 0.0};
    for (int i = 0; i < 6; ++i) {
        double weight = 1.0, slope = 0.0;
        for (int j = 0; j < 6; ++j) {
            if (j == i) continue;
            const double by = 1.0 / (s[i].phi - s[j].phi);
            slope = slope * (phi - s[j].phi) * by + weight * by;
            weight *= (phi - s[j].phi) * by;
        }
        place.alpha += weight * s[i].alpha;
        place.slope += slope * s[i].alpha;
    }
    return place;
}

}  // namespace

TexelGrid star_lens_row(const RayFan& fan) {
    const std::vector<Sample> samples = samples_of(fan, kStarImages * M_PI);
    TexelGrid row{kStarLensCells + 1, 1, {}};
    for (int i = 0; i <= kStarLensCells; ++i) {
        const Place place = at(samples, kStarImages * M_PI * i / kStarLensCells);
        for (const double value : {place.alpha, place.slope, 0.0, 0.0}) row.texels.push_back(static_cast<float>(value));
    }
    return row;
}

}  // namespace nullscope
