#include "compare/stokes_loop.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "scene/projection.h"

namespace nullscope {
namespace {

std::complex<double> linear_of(const StokesPoint& point) { return {point.q, point.u}; }

constexpr std::size_t kFewest = 4;  // points of a loop

}  // namespace

StokesPoint stokes_sum(const Image<float>& stokes, const CameraSpec& camera, const std::array<int, 4>& region,
                       double time) {
    StokesPoint sum{time};
    for (int y = region[1]; y < region[3]; ++y)
        for (int x = region[0]; x < region[2]; ++x) {
            const double angle = pixel_solid_angle(camera, x + 0.5, y + 0.5);
            const float* of = stokes.at(x, y);
            sum.i += angle * of[0], sum.q += angle * of[1], sum.u += angle * of[2];
        }
    return sum;
}

std::vector<std::array<double, 2>> loop_shape(const StokesLoop& loop) {
    double light = 0.0;
    for (const StokesPoint& point : loop) light += point.i / static_cast<double>(loop.size());
    std::vector<std::array<double, 2>> shape;
    shape.reserve(loop.size());
    for (const StokesPoint& point : loop)
        shape.push_back(light > 0.0 ? std::array{point.q / light, point.u / light} : std::array{0.0, 0.0});
    return shape;
}

bool is_closed(const StokesLoop& loop) {
    if (loop.size() < kFewest) return false;
    const std::complex<double> first = linear_of(loop.front()), last = linear_of(loop.back());
    const double step =
        std::max(std::abs(linear_of(loop[1]) - first), std::abs(last - linear_of(loop[loop.size() - 2])));
    return std::abs(last - first) < step;
}

int loop_turns(const StokesLoop& loop) {
    if (!is_closed(loop)) return 0;
    std::vector<std::complex<double>> ways;  // the last point is the first again
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) ways.push_back(linear_of(loop[i]) - linear_of(loop[i - 1]));
    ways.push_back(linear_of(loop.front()) - linear_of(loop[loop.size() - 2]));
    std::erase(ways, std::complex<double>());
    double turned = 0.0;
    for (std::size_t i = 0; i < ways.size(); ++i) turned += std::arg(ways[(i + 1) % ways.size()] * std::conj(ways[i]));
    return static_cast<int>(std::lround(turned / (2.0 * M_PI)));
}

}  // namespace nullscope
