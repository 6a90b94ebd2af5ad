#include "compare/rotation_measure.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <optional>

#include "scene/known_object.h"

namespace nullscope {
namespace {

double squared_wavelength_m2(double frequency_ghz) {
    const double wavelength = kLight_m_s / (1e9 * frequency_ghz);
    return wavelength * wavelength;
}

using Linear = std::complex<double>;  // Q + iU

// By how much the angle of `a` is ahead of that of `b`, within a quarter turn.
double angle_ahead(Linear a, Linear b) { return 0.5 * std::arg(a * std::conj(b)); }

// The slope of the angle against lambda^2; of each band by its linear polarisation.
std::optional<double> slope(const std::vector<BandPicture>& bands, const std::vector<Linear>& linear) {
    std::vector<double> angles(bands.size());
    double mean_square = 0, mean_angle = 0;
    for (std::size_t i = bands.size(); i-- > 0;) {  // from the shortest wavelength on
        if (!(std::abs(linear[i]) > 0)) return std::nullopt;
        angles[i] = i + 1 < bands.size() ? angles[i + 1] + angle_ahead(linear[i], linear[i + 1]) : 0.0;
        mean_square += squared_wavelength_m2(bands[i].frequency_GHz) / static_cast<double>(bands.size());
        mean_angle += angles[i] / static_cast<double>(bands.size());
    }
    double top = 0, bottom = 0;
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const double square = squared_wavelength_m2(bands[i].frequency_GHz) - mean_square;
        top += square * (angles[i] - mean_angle), bottom += square * square;
    }
    return top / bottom;
}

bool are_polarised(const std::vector<BandPicture>& bands) {
    for (const BandPicture& band : bands)
        if (band.stokes.empty()) return false;
    return bands.size() > 1;
}

}  // namespace

std::vector<RotationMeasure> rotation_measures(const std::vector<BandPicture>& bands) {
    if (!are_polarised(bands)) return {};
    std::vector<Linear> sums;
    for (const BandPicture& band : bands) {
        Linear sum;
        for (std::size_t i = 0; i + 3 < band.stokes.data.size(); i += 4)
            sum += Linear(band.stokes.data[i + 1], band.stokes.data[i + 2]);
        if (!(std::abs(sum) > 0)) return {};
        sums.push_back(sum);
    }
    std::vector<RotationMeasure> found;
    for (std::size_t i = 0; i + 1 < bands.size(); ++i) {
        const double low = bands[i].frequency_GHz, high = bands[i + 1].frequency_GHz,
                     apart = squared_wavelength_m2(low) - squared_wavelength_m2(high);
        found.push_back({low, high, angle_ahead(sums[i], sums[i + 1]) / apart, M_PI / apart});
    }
    return found;
}

Image<float> rotation_measure_image(const std::vector<BandPicture>& bands) {
    if (!are_polarised(bands)) return {};
    const Image<float>& first = bands.front().stokes;
    Image<float> image(first.width, first.height, 1);
    std::vector<Linear> linear(bands.size());
    for (std::size_t i = 0; i < image.data.size(); ++i) {
        for (std::size_t band = 0; band < bands.size(); ++band)
            linear[band] = {bands[band].stokes.data[4 * i + 1], bands[band].stokes.data[4 * i + 2]};
        image.data[i] = static_cast<float>(slope(bands, linear).value_or(0.0));
    }
    return image;
}

std::string words_of(const RotationMeasure& rm) {
    return fmt::format("RM {}-{} GHz {:.4g} rad/m^2 (+ n {:.4g})", rm.low_GHz, rm.high_GHz, rm.rad_m2, rm.step_rad_m2);
}

}  // namespace nullscope
