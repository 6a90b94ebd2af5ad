#include "telescope/visibility.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace nullscope {
namespace {

constexpr std::size_t kLanes = 8;  // sums side by side, which compilers vectorise

// e^(2 pi i frequency (middle - k) pixel) for k = 0, 1, ...: cosines, then sines. Whole turns are left out before they are angles: what is lost
// is the rounding of the product alone.
struct Fringe {
    std::vector<double> cosine, sine;
    Fringe(double frequency, double pixel, int count, std::size_t padded) : cosine(padded), sine(padded) {
        for (int k = 0; k < count; ++k) {
            const double turns = frequency * ((0.5 * (count - 1) - k) * pixel);
            const double angle = 2.0 * M_PI * (turns - std::round(turns));
            const auto i = static_cast<std::size_t>(k);
            cosine[i] = std::cos(angle), sine[i] = std::sin(angle);
        }
    }
};

double sinc(double x) { return x == 0.0 ? 1.0 : std::sin(M_PI * x) / (M_PI * x); }

// What the shape multiplies the sum over points by.
double shape_factor(PixelShape shape, double pixel, Baseline baseline) {
    if (shape == PixelShape::kPoint) return 1.0;
    const double square = sinc(pixel * baseline.u) * sinc(pixel * baseline.v);
    return shape == PixelShape::kSquare ? square : square * square;
}

// Of all columns, and of the even less the odd ones.
struct RowSum {
    std::complex<double> all, change;
};

RowSum row_sum(const double* light, const Fringe& columns) {
    std::array<double, kLanes> real{}, imaginary{};
    for (std::size_t x = 0; x < columns.cosine.size(); x += kLanes)
        for (std::size_t k = 0; k < kLanes; ++k) {
            real[k] += light[x + k] * columns.cosine[x + k];
            imaginary[k] += light[x + k] * columns.sine[x + k];
        }
    RowSum sum;
    for (std::size_t k = 0; k < kLanes; ++k) {
        const std::complex<double> lane(real[k], imaginary[k]);
        sum.all += lane, sum.change += k % 2 == 0 ? lane : -lane;
    }
    return sum;
}

// Written out: operator* looks for infinities.
std::complex<double> product(std::complex<double> a, std::complex<double> b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace

double total_flux(const SkyPicture& picture) {
    double sum = 0;
    for (int y = 0; y < picture.flux.height; ++y)
        for (int x = 0; x < picture.flux.width; ++x) sum += picture.flux.at(x, y)[0];
    return sum;
}

PictureVisibility::PictureVisibility(const SkyPicture& picture, PixelShape shape)
    : width_(picture.flux.width),
      height_(picture.flux.height),
      planes_(picture.flux.channels),
      padded_((static_cast<std::size_t>(width_) + kLanes - 1) / kLanes * kLanes),
      pixel_(picture.pixel),
      shape_(shape),
      light_(padded_ * static_cast<std::size_t>(height_) * static_cast<std::size_t>(planes_)) {
    double* row = light_.data();
    for (int plane = 0; plane < planes_; ++plane)
        for (int y = 0; y < height_; ++y, row += padded_)
            for (int x = 0; x < width_; ++x) row[x] = picture.flux.at(x, y)[plane];
}

VisibilitySum PictureVisibility::with_change(Baseline baseline) const {
    const auto rows = static_cast<std::size_t>(height_);
    const Fringe columns(baseline.u, pixel_, width_, padded_), up(baseline.v, pixel_, height_, rows);
    const double factor = shape_factor(shape_, pixel_, baseline);
    VisibilitySum found;
    const double* light = light_.data();
    for (std::size_t plane = 0; plane < static_cast<std::size_t>(planes_); ++plane) {
        RowSum sum;
        for (std::size_t y = 0; y < rows; ++y, light += padded_) {
            const RowSum row = row_sum(light, columns);
            const std::complex<double> turn(up.cosine[y], up.sine[y]);
            sum.all += product(row.all, turn), sum.change += product(row.change, y % 2 == 0 ? turn : -turn);
        }
        found.all[plane] = factor * sum.all, found.change[plane] = factor * sum.change;
    }
    return found;
}

Visibility PictureVisibility::at(Baseline baseline) const { return with_change(baseline).all; }

std::vector<Visibility> PictureVisibility::at(std::span<const Baseline> baselines) const {
    std::vector<Visibility> found(baselines.size());
    tbb::parallel_for(std::size_t{0}, baselines.size(), [&](std::size_t i) { found[i] = at(baselines[i]); });
    return found;
}

}  // namespace nullscope
