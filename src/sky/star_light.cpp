// Its loops are to be vectorised: see its compiler options in src/CMakeLists.txt.
#include "sky/star_light.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "sky/cube.h"

namespace nullscope {
namespace {

using Light = StarPainter::Light;
using Splat = StarPainter::Splat;

constexpr double kTexelsPerSigma = 0.6;
constexpr double kCoreReach = 4.0;      // sigmas; exp(-8) = 0.03 % of the flux would lie outside
constexpr int kBandRows = 32;           // rows of a list of splats
constexpr std::size_t kBlock = 2048;    // stars a task
constexpr std::size_t kMostKept = 512;  // texels of a splat whose profile is kept from its sum to its drawing
constexpr double kCornerAngle = 0.9553166181245093;  // of a face, from its centre: atan(sqrt 2)
// Of a face with a border of 1/kBorderOf of it on each side: atan(17/16 sqrt 2).
constexpr double kWideCornerAngle = 0.984;
// rad; the farthest a light reaches. kCornerAngle + 2 kMaxReach stays below pi/2, where the gnomonic image ends.
constexpr double kMaxReach = 0.3;

// The halo of scattered light that makes bright stars look large: Moffat's profile (1 + (a / s)^2)^-2, s in angle.
constexpr double kHaloNone = 5.5, kHaloFull = 3.5;  // magnitudes between which it sets in
constexpr double kHaloFraction = 0.25;              // of the star's flux: about what an eye scatters near the source
constexpr double kHaloSigmas = 5.12;                // s in sigmas of the core: 10 arc minutes at kReferenceFace
constexpr double kHaloFloor =
    3e-4;  // radiance at which it is cut, smoothly: a step of an 8-bit display over the darkest sky

constexpr std::size_t kRun = 64;  // texels of a row that are worked out together
using Run = std::array<double, kRun>;

// exp of x in [-8, 0] to 1e-8, without a branch: 64 times the series of x/64.
inline double exp_of(double x) {
    const double y = x * (1.0 / 64.0);
    double e =
        1.0 + y * (1.0 + y * (1.0 / 2.0) *
                             (1.0 + y * (1.0 / 3.0) *
                                        (1.0 + y * (1.0 / 4.0) * (1.0 + y * (1.0 / 5.0) * (1.0 + y * (1.0 / 6.0))))));
    for (int i = 0; i < 6; ++i) e *= e;
    return e;
}

// Of the texels of one row: the cosine of each one's angle to a light, and what its solid angle is.
class TexelRow {
public:
    TexelRow(const FaceAxes& axes, int size, Vec3 light, int y)
        : step_(2.0 / size),
          t_((y + 0.5) * step_ - 1.0),
          at_middle_(dot(light, axes.middle) + t_ * dot(light, axes.down)),
          along_(dot(light, axes.right)) {}

    // From x on: squares of the chords to the light (those of the angles to 0.8 % at kMaxReach), and the cubes of one over the
    // distances to the face's plane.
    void fill(int x, std::size_t count, Run& squares, Run& cubes) const {
        for (std::size_t i = 0; i < count; ++i) {
            const double s = (x + static_cast<int>(i) + 0.5) * step_ - 1.0;
            const double inverse = 1.0 / std::sqrt(1.0 + t_ * t_ + s * s);
            squares[i] = 2.0 - 2.0 * (at_middle_ + s * along_) * inverse;
            cubes[i] = inverse * inverse * inverse;
        }
    }
    double solid_angle() const { return step_ * step_; }  // where the cube is 1

private:
    double step_, t_, at_middle_, along_;
};

// Whether the core reaches any of them: not most of a halo's texels.
bool core_reaches(double sigma, const Run& squares, std::size_t count) {
    double least = squares[0];
    for (std::size_t i = 1; i < count; ++i) least = std::min(least, squares[i]);
    return least < kCoreReach * kCoreReach * sigma * sigma;
}

void core_profile(double sigma, const Run& squares, std::size_t count, double* out) {
    const double scale = 1.0 / (sigma * sigma);
    for (std::size_t i = 0; i < count; ++i) {
        const double q = squares[i] * scale, within = std::min(q, kCoreReach * kCoreReach);
        out[i] = q < kCoreReach * kCoreReach ? exp_of(-0.5 * within) : 0.0;
    }
}

void halo_profile(double sigma, double reach, const Run& squares, std::size_t count, Run& out) {
    const double by_scale = 1.0 / (kHaloSigmas * sigma * kHaloSigmas * sigma), by_reach = 1.0 / (reach * reach);
    for (std::size_t i = 0; i < count; ++i) {
        const double window = std::max(1.0 - squares[i] * by_reach, 0.0), moffat = 1.0 + squares[i] * by_scale;
        out[i] = window * window / (moffat * moffat);
    }
}

// How far a light reaches, as splat_on needs it.
struct Reach {
    double tangent,
        least_depth;  // least_depth: cosine of the angle to a face's middle from which on it reaches nothing of the face
    Reach(double angle, int border)
        : tangent(std::tan(angle)), least_depth(std::cos((border > 0 ? kWideCornerAngle : kCornerAngle) + angle)) {}
};

// The texels of a face and its border that a light can reach, from the gnomonic image of its cap: the cap's farthest point from the
// face's middle bounds the stretch.
std::optional<Splat> splat_on(Vec3 direction, const Reach& reach, const FaceAxes& axes, int size, int border) {
    const double depth = dot(direction, axes.middle);
    if (depth <= reach.least_depth) return std::nullopt;
    const double s = dot(direction, axes.right) / depth, t = dot(direction, axes.down) / depth;
    const double far = std::hypot(s, t),
                 flat = 1.0 - far * reach.tangent;    // 0 where the cap meets the plane's infinity
    constexpr double kFlattest = 0.01, kWhole = 4.0;  // a half that covers the face from everywhere
    const double half = flat > kFlattest ? (far + reach.tangent) / flat - far : kWhole;
    const auto texel = [&](double plane) {
        return std::clamp(static_cast<int>(std::floor(0.5 * (plane + 1.0) * size)), -border - 1, size + border);
    };
    const int x0 = std::max(texel(s - half), -border), x1 = std::min(texel(s + half), size + border - 1);
    const int y0 = std::max(texel(t - half), -border), y1 = std::min(texel(t + half), size + border - 1);
    if (x0 > x1 || y0 > y1) return std::nullopt;
    return Splat{0, static_cast<std::int16_t>(x0), static_cast<std::int16_t>(x1), static_cast<std::int16_t>(y0),
                 static_cast<std::int16_t>(y1)};
}

bool can_be_kept(const Splat& splat) {
    const int columns = splat.x1 - splat.x0 + 1, rows = splat.y1 - splat.y0 + 1;
    return columns <= static_cast<int>(kRun) && columns * rows <= static_cast<int>(kMostKept);
}

double halo_reach(double flux, double scale) {
    const double centre = flux / (std::numbers::pi * scale * scale);  // of the profile without a cut
    const double ratio = std::sqrt(std::max(centre / kHaloFloor, 1.0)) - 1.0;
    return std::clamp(scale * std::sqrt(ratio), 2.0 * scale, std::max(2.0 * scale, kMaxReach));
}

const std::array<FaceAxes, 6>& all_axes() {
    static const std::array<FaceAxes, 6> axes{face_axes(0), face_axes(1), face_axes(2),
                                              face_axes(3), face_axes(4), face_axes(5)};
    return axes;
}

// The halo's profile over the sphere, in closed form: with q the square of the chord an area is pi dq. Texels of one face, a third of its
// scale apart, add up to that within 1e-5; those about an edge of the cube within 5e-4.
double halo_integral(double scale, double reach) {
    const double a = 1.0 / (scale * scale), far = a * reach * reach, u = 1.0 + far;
    return std::numbers::pi * (far * (u + 1.0) - 2.0 * u * std::log(u)) / (a * far * far);
}

// Of a profile about a direction over all faces, texels weighted by their solid angles.
template <class Profile>
double sum_over_texels(Vec3 direction, double reach, int size, const Profile& profile) {
    Run squares, cubes, values;
    double sum = 0.0;
    for (const FaceAxes& axes : all_axes()) {
        const auto splat = splat_on(direction, Reach(reach, 0), axes, size, 0);
        if (!splat) continue;
        for (int y = splat->y0; y <= splat->y1; ++y) {
            const TexelRow row(axes, size, direction, y);
            for (int x = splat->x0; x <= splat->x1; x += static_cast<int>(kRun)) {
                const auto count = std::min(kRun, static_cast<std::size_t>(splat->x1 - x + 1));
                row.fill(x, count, squares, cubes);
                profile(squares, count, values);
                for (std::size_t i = 0; i < count; ++i) sum += row.solid_angle() * cubes[i] * values[i];
            }
        }
    }
    return sum;
}

std::vector<std::array<float, 3>> colour_table() {
    std::vector<std::array<float, 3>> table(kColourCodes);
    tbb::parallel_for(0, kColourCodes, [&](int i) {
        const Vec3 c = star_colour(b_minus_v(i));
        table[static_cast<std::size_t>(i)] = {static_cast<float>(c.x), static_cast<float>(c.y),
                                              static_cast<float>(c.z)};
    });
    return table;
}

// Adds amount times a profile of a row.
void add_row(SkyRows& rows, int y, int x, const double* profile, std::size_t count, double amount,
             const std::array<float, 3>& colour) {
    for (std::size_t plane = 0; plane < 3; ++plane) {
        float* out = rows.row(plane, y) + x + rows.border;
        const double light = amount * colour[plane];
        for (std::size_t i = 0; i < count; ++i) out[i] += static_cast<float>(light * profile[i]);
    }
}

}  // namespace

double core_sigma(int face_size) { return kTexelsPerSigma * 2.0 / std::min(face_size, kReferenceFace); }

double star_flux(double magnitude) {
    const double reference = core_sigma(kReferenceFace);
    return kPeakOfMagnitude5 * 2.0 * std::numbers::pi * reference * reference *
           std::pow(10.0, -0.4 * (magnitude - 5.0));
}

StarPainter::StarPainter(const std::vector<Star>& stars, const Mat3& world_from_sky, double brightness, int size,
                         int border)
    : size_(size),
      border_(border),
      bands_((size + 2 * border + kBandRows - 1) / kBandRows),
      sigma_(core_sigma(size)),
      colours_(colour_table()),
      lights_(stars.size()),
      splats_(static_cast<std::size_t>(6 * bands_)) {
    const std::size_t blocks = (stars.size() + kBlock - 1) / kBlock;
    std::vector<std::vector<Placed>> placed(blocks);
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
        for (std::size_t i = block * kBlock; i < std::min((block + 1) * kBlock, stars.size()); ++i) {
            Light& light =
                lights_[i] = {.direction = world_from_sky * stars[i].direction, .colour = stars[i].colour_code};
            place(light, static_cast<std::uint32_t>(i), stars[i].magnitude, brightness, placed[block]);
        }
    });
    for (const auto& block : placed)  // in the catalogue's order
        for (const Placed& p : block) splats_[p.band].push_back(p.splat);
}

void StarPainter::place(Light& light, std::uint32_t number, double magnitude, double brightness,
                        std::vector<Placed>& out) const {
    const double flux = brightness * star_flux(magnitude), scale = kHaloSigmas * sigma_;
    double fraction = kHaloFraction * std::clamp((kHaloNone - magnitude) / (kHaloNone - kHaloFull), 0.0, 1.0);
    if (2.0 * scale > kMaxReach) fraction = 0.0;  // a face so coarse (below 64 texels) shows no halo
    if (fraction > 0.0) light.halo_reach = halo_reach(fraction * flux, scale);
    const double angle = std::max(kCoreReach * sigma_, light.halo_reach);
    const Reach reach(angle, border_);
    const std::size_t before = out.size();
    for (int face = 0; face < 6; ++face) {
        auto splat = splat_on(light.direction, reach, all_axes()[static_cast<std::size_t>(face)], size_, border_);
        if (!splat) continue;
        splat->light = number;
        for (int row = splat->y0 + border_; row / kBandRows <= (splat->y1 + border_) / kBandRows; row += kBandRows)
            out.push_back({static_cast<std::size_t>(face * bands_ + row / kBandRows), *splat});
    }
    if (out.size() == before + 1 && fraction == 0.0 &&
        can_be_kept(out.back().splat)) {  // no other face has any of it: most are so
        light.core = flux;
        light.normalised = false;
        return;
    }
    const double sigma = sigma_, halo = light.halo_reach;
    light.core =
        (1.0 - fraction) * flux /
        sum_over_texels(light.direction, kCoreReach * sigma_, size_, [sigma](auto& squares, auto count, auto& values) {
            core_profile(sigma, squares, count, values.data());
        });
    if (fraction == 0.0) return;
    const auto faces = std::count_if(all_axes().begin(), all_axes().end(), [&](const FaceAxes& axes) {
        return splat_on(light.direction, Reach(halo, 0), axes, size_, 0).has_value();
    });
    light.halo =
        fraction * flux /
        (faces == 1 ? halo_integral(scale, halo)
                    : sum_over_texels(light.direction, halo, size_, [=](auto& squares, auto count, auto& values) {
                          halo_profile(sigma, halo, squares, count, values);
                      }));
}

void StarPainter::add(SkyRows& rows) const {
    const int last = rows.first + rows.count - 1;
    for (int band = (rows.first + border_) / kBandRows; band <= (last + border_) / kBandRows; ++band)
        for (const Splat& splat : splats_[static_cast<std::size_t>(rows.face) * static_cast<std::size_t>(bands_) +
                                          static_cast<std::size_t>(band)]) {
            const int band_first = band * kBandRows - border_;
            const int first = std::max({static_cast<int>(splat.y0), rows.first, band_first});
            const int end = std::min({static_cast<int>(splat.y1), last, band_first + kBandRows - 1}) + 1;
            const Light& light = lights_[splat.light];
            if (light.normalised)
                add_light(rows, light, splat, first, end);
            else
                add_whole(rows, light, splat, first, end);
        }
}

void StarPainter::add_light(SkyRows& rows, const Light& light, const Splat& splat, int first, int end) const {
    Run squares, cubes, profile;
    for (int y = first; y < end; ++y) {
        const TexelRow row(all_axes()[static_cast<std::size_t>(rows.face)], size_, light.direction, y);
        for (int x = splat.x0; x <= splat.x1; x += static_cast<int>(kRun)) {
            const auto count = std::min(kRun, static_cast<std::size_t>(splat.x1 - x + 1));
            row.fill(x, count, squares, cubes);
            if (core_reaches(sigma_, squares, count)) {
                core_profile(sigma_, squares, count, profile.data());
                add_row(rows, y, x, profile.data(), count, light.core, colours_[light.colour]);
            }
            if (!(light.halo_reach > 0.0)) continue;
            halo_profile(sigma_, light.halo_reach, squares, count, profile);
            add_row(rows, y, x, profile.data(), count, light.halo, colours_[light.colour]);
        }
    }
}

// The profile is worked out once for its sum and its drawing.
void StarPainter::add_whole(SkyRows& rows, const Light& light, const Splat& splat, int first, int end) const {
    Run squares, cubes;
    std::array<double, kMostKept> profile;
    double sum = 0.0, solid_angle = 0.0;
    const auto width = static_cast<std::size_t>(splat.x1 - splat.x0) + 1;
    double* out = profile.data();
    for (int y = splat.y0; y <= splat.y1; ++y, out += width) {
        const TexelRow row(all_axes()[static_cast<std::size_t>(rows.face)], size_, light.direction, y);
        row.fill(splat.x0, width, squares, cubes);
        core_profile(sigma_, squares, width, out);
        for (std::size_t i = 0; i < width; ++i) sum += cubes[i] * out[i];
        solid_angle = row.solid_angle();
    }
    for (int y = first; y < end; ++y)
        add_row(rows, y, splat.x0, profile.data() + static_cast<std::size_t>(y - splat.y0) * width, width,
                light.core / (solid_angle * sum), colours_[light.colour]);
}

}  // namespace nullscope
