#include "telescope/live_view.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>

namespace nullscope {
namespace {

constexpr double kOneDegree = M_PI / 180;
constexpr int kSections = 24;  // of two steps of the curve: 1e-5 of them

std::optional<Triangle> places_in(const Scan& scan, const Triangle& triangle) {
    Triangle places{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto found = std::ranges::find(scan.up, triangle[i]);
        if (found == scan.up.end()) return std::nullopt;
        places[i] = static_cast<std::size_t>(found - scan.up.begin());
    }
    return places;
}

void add_phases(const PictureVisibility& picture, const Observation& day, const LiveWish& wish, LiveView& view) {
    std::vector<Baseline> sides;
    const auto add = [&](const Scan& scan) {
        const auto places = places_in(scan, wish.triangle);
        if (!places) return;
        const auto [a, b, c] = *places;
        view.phases.push_back({scan.hour, 0});
        for (const std::size_t side : {scan.at(a, b), scan.at(b, c), scan.at(a, c)})
            sides.push_back(day.baselines[side]);
    };
    if (wish.whole_day)
        for (const Scan& scan : day.scans) add(scan);
    else if (const Scan* middle = middle_scan(day, wish.triangle))
        add(*middle);
    const std::vector<Visibility> seen = picture.at(sides);
    for (std::size_t i = 0; i < view.phases.size(); ++i)
        view.phases[i].phase = std::arg(seen[3 * i][0] * seen[3 * i + 1][0] * std::conj(seen[3 * i + 2][0]));
}

using Waves = std::vector<std::complex<double>>;
// e^(2 pi i frequency (middle - k) pixel) of each frequency, one after the other.
Waves waves_of(std::span<const double> frequencies, double pixel, int count) {
    Waves waves;
    for (const double frequency : frequencies)
        for (int k = 0; k < count; ++k)
            waves.push_back(std::polar(1.0, 2 * M_PI * frequency * (0.5 * (count - 1) - k) * pixel));
    return waves;
}

}  // namespace

Observation live_day(const std::vector<Station>& stations, const LiveSource& source) {
    constexpr int kScans = 144;
    std::vector<double> hours(kScans + 1);
    for (int i = 0; i <= kScans; ++i) hours[static_cast<std::size_t>(i)] = 24.0 * i / kScans;
    const ObservationPlan plan{kOneDegree * source.place.right_ascension_deg,
                               kOneDegree * source.place.declination_deg,
                               1e9 * source.frequency_GHz,
                               std::move(hours),
                               {},
                               10 * kOneDegree};
    auto day = observe(stations, plan);
    return day ? std::move(*day) : Observation{};  // 145 scans of kMostStations are not too many
}

std::vector<Triangle> triangles_of(const Observation& day) {
    std::vector<Triangle> found;
    for (const Scan& scan : day.scans)
        for (std::size_t a = 0; a < scan.up.size(); ++a)
            for (std::size_t b = a + 1; b < scan.up.size(); ++b)
                for (std::size_t c = b + 1; c < scan.up.size(); ++c)
                    found.push_back({scan.up[a], scan.up[b], scan.up[c]});
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

const Scan* middle_scan(const Observation& day, const Triangle& triangle) {
    std::vector<const Scan*> together;
    for (const Scan& scan : day.scans)
        if (places_in(scan, triangle)) together.push_back(&scan);
    return together.empty() ? nullptr : together[together.size() / 2];
}

Image<float> visibility_plane(const SkyPicture& picture, double longest, int side) {
    const int width = picture.flux.width, height = picture.flux.height;
    const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    std::vector<double> steps;
    steps.reserve(static_cast<std::size_t>(side));
    for (int i = 0; i < side; ++i) steps.push_back(longest * (1 - 2.0 * i / (side - 1)));
    const Waves east = waves_of(steps, picture.pixel, width), north = waves_of(steps, picture.pixel, height);
    Image<float> plane(side, side, 1);
    Waves sums(rows);  // of each row of the picture
    for (int x = 0; x < side; ++x) {
        const std::complex<double>* wave = &east[static_cast<std::size_t>(x) * columns];
        for (std::size_t y = 0; y < rows; ++y) {
            const double* light = &picture.flux.data[y * columns];
            double real = 0, imaginary = 0;
            for (std::size_t k = 0; k < columns; ++k)
                real += light[k] * wave[k].real(), imaginary += light[k] * wave[k].imag();
            sums[y] = {real, imaginary};
        }
        for (int y = 0; y < (side + 1) / 2; ++y) {  // of real light V(-u, -v) is the conjugate of V(u, v)
            const std::complex<double>* up = &north[static_cast<std::size_t>(y) * rows];
            double real = 0, imaginary = 0;
            for (std::size_t k = 0; k < rows; ++k) {
                real += sums[k].real() * up[k].real() - sums[k].imag() * up[k].imag();
                imaginary += sums[k].real() * up[k].imag() + sums[k].imag() * up[k].real();
            }
            *plane.at(x, y) = *plane.at(side - 1 - x, side - 1 - y) = static_cast<float>(std::hypot(real, imaginary));
        }
    }
    return plane;
}

LiveView live_view(const SkyPicture& picture, const Observation& day, const LiveWish& wish) {
    const PictureVisibility visibility(picture, PixelShape::kPoint);
    LiveView view;
    std::vector<Baseline> line;
    for (int i = 0; i < wish.points; ++i) {
        const double length = wish.longest * i / (wish.points - 1);
        line.push_back({length * std::sin(wish.angle), length * std::cos(wish.angle)});
    }
    for (const Visibility& seen : visibility.at(line)) view.amplitudes.push_back(std::abs(seen[0]));
    view.minimum =
        first_minimum([&](Baseline b) { return std::abs(visibility.at(b)[0]); }, line, view.amplitudes, kSections);
    view.plane = visibility_plane(picture, wish.longest, wish.plane);
    add_phases(visibility, day, wish, view);
    return view;
}

}  // namespace nullscope
