// The errors of a frame, pixel by pixel as they are measured: in which order, what they come to, and a heat map for the screen.
#pragma once
#include <vector>

#include "compare/ray_metrics.h"
#include "image/image.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope {

struct ErrorSummary {
    long long pixels = 0, measured = 0;  // of the frame
    long long fate_errors = 0, forgiven = 0;
    Spread sky_px, place_px;  // as RayMeasures has them, over the pixels measured by then
    double percent() const {
        return pixels > 0 ? 100.0 * static_cast<double>(measured) / static_cast<double>(pixels) : 0.0;
    }
    bool complete() const { return pixels > 0 && measured == pixels; }
};

// What is known of a frame's true error: each measured pixel, the sums over them, and a heat map for the screen.
class ErrorMap {
public:
    // What the sums are formed from: cheap to take where others wait, the rest is some 10 ms of a whole frame.
    struct Found {
        ErrorSummary counts;  // without the spreads
        std::vector<float> sky_px, place_px;
        ErrorSummary summary() &&;  // with them
    };
    ErrorMap() = default;
    ErrorMap(int width, int height);  // px

    // Takes the measured pixels of a tile, in any order of tiles; a pixel counts once. step > 1: a pixel of a grid of
    // that spacing in px, which stands in the heat map for the pixels around it until they are measured themselves.
    void take(const TileErrors& tile, int step);

    const ErrorSummary& counts() const { return counts_; }              // without the spreads
    const std::vector<PixelErrors>& pixels() const { return pixels_; }  // top row first; kNotCompared: not measured yet
    // RGBA: the colours of screen_px(), transparent where nothing is known.
    const Image<unsigned char>& heat() const { return heat_; }
    Found found() const;

private:
    PixelErrors& at(int x, int y) { return pixels_[static_cast<std::size_t>(y) * heat_.width + x]; }
    void paint(PixelRect cell, const PixelErrors& errors);

    std::vector<PixelErrors> pixels_;
    Image<unsigned char> heat_;
    ErrorSummary counts_;
};

// Of what is measured at once: every pixel of the rectangle (step 0), or the pixels in the middles of its cells of that size.
struct ErrorTask {
    PixelRect rect;
    int step;
};
// Coarse grids over the whole frame, then every pixel, from the middle outward: there is the hole. A task is some 10 ms of work, the first
// ones less.
std::vector<ErrorTask> error_tasks(int width, int height);
// On the calling thread. The rays of a task are asked for at once, displaced ones apart: the reference traces many in less time each.
std::vector<TileErrors> measure_task(const RayFrame& tested, const CameraSpec& camera, const ExactTrace& exact,
                                     const ErrorTask& task);

}  // namespace nullscope
