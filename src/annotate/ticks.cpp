#include "annotate/ticks.h"

#include <algorithm>
#include <cmath>

#include "annotate/ink.h"

namespace nullscope {
namespace {

constexpr double kTicksAside = 22, kLeastApart_px = 12;
constexpr double kLongest = 0.86;     // of what they are apart
constexpr double kThick = 0.09;       // likewise
constexpr double kLeastLight = 0.02;  // of the brightest
constexpr double kTickInk = 0.96;

double apart(int width, int height) { return std::max(std::min(width, height) / kTicksAside, kLeastApart_px); }

// A line with round ends.
Mark tick_mark(const Tick& tick, double thick) {
    const double reach_x = std::abs(tick.right) + thick, reach_y = std::abs(tick.up) + thick;
    const int left = static_cast<int>(std::floor(tick.x - reach_x)),
              top = static_cast<int>(std::floor(tick.y - reach_y));
    Sheet ink(static_cast<int>(std::ceil(2 * reach_x)) + 2, static_cast<int>(std::ceil(2 * reach_y)) + 2);
    const double length2 = tick.right * tick.right + tick.up * tick.up;
    for (int row = 0; row < ink.height; ++row)
        for (int column = 0; column < ink.width; ++column) {
            const double x = left + column + 0.5 - tick.x, y = tick.y - (top + row + 0.5);
            const double along = std::clamp((x * tick.right + y * tick.up) / length2, -1.0, 1.0);
            const double off = std::hypot(x - along * tick.right, y - along * tick.up);
            ink.at(column, row) = static_cast<float>(std::clamp(0.5 * thick - off + 0.5, 0.0, 1.0));
        }
    return outlined(ink, left, top, 4 * thick, kTickInk);
}

}  // namespace

TickGrid tick_grid(int width, int height) {
    const double step = apart(width, height);
    return {std::max(1, static_cast<int>(width / step)), std::max(1, static_cast<int>(height / step))};
}

Scene tick_scene(Scene scene, int width, int height) {
    const TickGrid grid = tick_grid(width, height);
    scene.camera.pixel_aspect *= static_cast<double>(width) * grid.rows / (static_cast<double>(height) * grid.columns);
    scene.camera.width = grid.columns, scene.camera.height = grid.rows;
    return scene;
}

double tick_thickness(int width, int height) { return std::max(kThick * apart(width, height), 1.2); }

std::vector<Tick> ticks_of(const Image<float>& stokes, int width, int height) {
    const double step = apart(width, height);
    double brightest = 0, most = 0;
    for (int y = 0; y < stokes.height; ++y)
        for (int x = 0; x < stokes.width; ++x) brightest = std::max<double>(brightest, stokes.at(x, y)[0]);
    const auto fraction = [&](const float* light) {
        return light[0] > kLeastLight * brightest ? std::hypot(light[1], light[2]) / light[0] : 0.0;
    };
    for (int y = 0; y < stokes.height; ++y)
        for (int x = 0; x < stokes.width; ++x) most = std::max<double>(most, fraction(stokes.at(x, y)));
    std::vector<Tick> ticks;
    if (!(most > 0)) return ticks;
    for (int y = 0; y < stokes.height; ++y)
        for (int x = 0; x < stokes.width; ++x) {
            const float* light = stokes.at(x, y);
            const double half = 0.5 * kLongest * step * fraction(light) / most,
                         angle = 0.5 * std::atan2(light[2], light[1]);
            if (2 * half < kThick * step) continue;
            ticks.push_back({(x + 0.5) * width / stokes.width, (y + 0.5) * height / stokes.height,
                             half * std::cos(angle), half * std::sin(angle)});
        }
    return ticks;
}

std::vector<Mark> tick_marks(const Image<float>& stokes, int width, int height) {
    std::vector<Mark> marks;
    const double thick = tick_thickness(width, height);
    for (const Tick& tick : ticks_of(stokes, width, height)) marks.push_back(tick_mark(tick, thick));
    return marks;
}

}  // namespace nullscope
