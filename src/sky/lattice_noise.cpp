#include "sky/lattice_noise.h"

#include <algorithm>

namespace nullscope {
namespace {

// To the next octave: turned so that the lattices' axes differ, twice as fine, and shifted.
Vec3 next_octave(Vec3 p) {
    return {2.03 * (0.36 * p.x + 0.48 * p.y - 0.80 * p.z) + 5.3, 2.03 * (-0.80 * p.x + 0.60 * p.y) + 11.7,
            2.03 * (0.48 * p.x + 0.64 * p.y + 0.60 * p.z) + 17.1};
}

// Of |x| < 2^20: std::floor is a call where processors of 2003 are to run it.
int floor_of(double x) {
    constexpr int kShift = 1 << 20;
    return static_cast<int>(x + kShift) - kShift;
}

double faded(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

}  // namespace

LatticeNoise::LatticeNoise(SeededRandom& random) : table_(kSide * kSide * kSide) {
    for (float& value : table_) value = static_cast<float>(random.next());
}

double LatticeNoise::value(Vec3 p) const {
    const int ix = floor_of(p.x), iy = floor_of(p.y), iz = floor_of(p.z);
    const double tx = faded(p.x - ix), ty = faded(p.y - iy), tz = faded(p.z - iz);
    constexpr int kMask = kSide - 1;
    const int x0 = ix & kMask, y0 = iy & kMask, z0 = iz & kMask;
    const int x1 = (x0 + 1) & kMask, y1 = ((y0 + 1) & kMask) * kSide, z1 = ((z0 + 1) & kMask) * kSide * kSide;
    const float *near = table_.data() + z0 * kSide * kSide, *far = table_.data() + z1;
    const auto plane = [&](const float* from) {
        const float *a = from + y0 * kSide, *b = from + y1;
        const double upper = a[x0] + tx * (a[x1] - a[x0]), lower = b[x0] + tx * (b[x1] - b[x0]);
        return upper + ty * (lower - upper);
    };
    const double first = plane(near), second = plane(far);
    return first + tz * (second - first);
}

double LatticeNoise::fractal(Vec3 p, int octaves) const {
    double sum = 0.0, weight = 0.5, all = 0.0;
    for (int i = 0; i < octaves; ++i, weight *= 0.5, p = next_octave(p)) sum += weight * value(p), all += weight;
    return sum / all;
}

double LatticeNoise::ridged(Vec3 p, int octaves) const {
    double sum = 0.0, weight = 0.5, all = 0.0, on = 1.0;
    for (int i = 0; i < octaves; ++i, weight *= 0.55, p = next_octave(p)) {
        const double ridge = 1.0 - std::fabs(2.0 * value(p) - 1.0);
        const double sharp = ridge * ridge * on;
        sum += weight * sharp, all += weight;
        on = std::clamp(1.6 * sharp, 0.0, 1.0);
    }
    return sum / all;
}

}  // namespace nullscope
