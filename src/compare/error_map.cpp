#include "compare/error_map.h"

#include <algorithm>
#include <array>
#include <utility>

#include "compare/heat_map.h"

namespace nullscope {
namespace {

constexpr int kTile = 64;                          // px
constexpr std::array kCoarse = {64, 16, 8, 4};     // px between the pixels measured first; divide kTile
constexpr int kCoarseCells = 16, kFirstCells = 8;  // in a row of a task; those measured first come to numbers soon

}  // namespace

ErrorMap::ErrorMap(int width, int height) : pixels_(static_cast<std::size_t>(width) * height), heat_(width, height, 4) {
    counts_.pixels = static_cast<long long>(width) * height;
}

void ErrorMap::take(const TileErrors& tile, int step) {
    const int half = step / 2;
    std::size_t i = 0;
    for (int y = tile.rect.top; y < tile.rect.bottom; ++y)
        for (int x = tile.rect.left; x < tile.rect.right; ++x, ++i) {
            PixelErrors& pixel = at(x, y);
            if (pixel.end != RayEnd::kNotCompared) continue;
            const PixelErrors& errors = tile.pixels[i];
            paint({x - half, y - half, x + std::max(half, 1), y + std::max(half, 1)}, errors);
            pixel = errors;
            ++counts_.measured;
            counts_.fate_errors += errors.end == RayEnd::kDiffers;
            counts_.forgiven += errors.end == RayEnd::kForgiven;
        }
}

// A measured pixel keeps its colour: with several threads a coarse task can end after a fine one.
void ErrorMap::paint(PixelRect cell, const PixelErrors& errors) {
    const auto colour = heat_colour(errors.screen_px(), kPixelHeat);
    for (int y = std::max(cell.top, 0); y < std::min(cell.bottom, heat_.height); ++y)
        for (int x = std::max(cell.left, 0); x < std::min(cell.right, heat_.width); ++x) {
            if (at(x, y).end != RayEnd::kNotCompared) continue;
            unsigned char* texel = heat_.at(x, y);
            std::copy(colour.begin(), colour.end(), texel);
            texel[3] = 255;
        }
}

ErrorMap::Found ErrorMap::found() const {
    Found found{counts_, {}, {}};
    found.sky_px.reserve(static_cast<std::size_t>(counts_.measured));
    for (const PixelErrors& pixel : pixels_) {
        if (pixel.end != RayEnd::kSame) continue;
        if (pixel.escaped) found.sky_px.push_back(pixel.sky_px);
        if (pixel.hit) found.place_px.push_back(pixel.place_px);
    }
    return found;
}

ErrorSummary ErrorMap::Found::summary() && {
    counts.sky_px = spread_of(std::move(sky_px));
    counts.place_px = spread_of(std::move(place_px));
    return counts;
}

std::vector<ErrorTask> error_tasks(int width, int height) {
    std::vector<ErrorTask> tasks;
    const auto add_level = [&](int step, int side) {
        const auto first = static_cast<std::ptrdiff_t>(tasks.size());
        for (int y = 0; y < height; y += side)
            for (int x = 0; x < width; x += side)
                tasks.push_back({{x, y, std::min(x + side, width), std::min(y + side, height)}, step});
        const auto off = [&](const ErrorTask& task) {
            const double dx = task.rect.left + task.rect.right - width, dy = task.rect.top + task.rect.bottom - height;
            return dx * dx + dy * dy;
        };
        std::ranges::stable_sort(tasks.begin() + first, tasks.end(), {}, off);
    };
    for (const int step : kCoarse) add_level(step, step * (step == kCoarse.front() ? kFirstCells : kCoarseCells));
    add_level(0, kTile);
    return tasks;
}

std::vector<TileErrors> measure_task(const RayFrame& tested, const CameraSpec& camera, const ExactTrace& exact,
                                     const ErrorTask& task) {
    if (task.step == 0) return measure_tiles(tested, camera, exact, {task.rect});
    std::vector<PixelRect> middles;
    for (int y = task.rect.top + task.step / 2; y < task.rect.bottom; y += task.step)
        for (int x = task.rect.left + task.step / 2; x < task.rect.right; x += task.step)
            middles.push_back({x, y, x + 1, y + 1});
    return measure_tiles(tested, camera, exact, middles);
}

}  // namespace nullscope
