// The true error of the frame on the screen: every pixel against the reference tracer, on threads of its own, coarse to fine.
//
// Owners: the caller hands over a frame of ray data and never sees it again; workers read it. What they find lies behind one
// mutex and is copied out. No OpenGL and no window in it.
#pragma once
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "base/image.h"
#include "base/result.h"
#include "compare/ray_metrics.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::viewer {

struct ErrorSummary {
    long long pixels = 0, measured = 0;  // of the frame
    long long fate_errors = 0, forgiven = 0;
    Spread sky_px, place_px;  // as RayMeasures has them, over the pixels measured by then
    double percent() const {
        return pixels > 0 ? 100.0 * static_cast<double>(measured) / static_cast<double>(pixels) : 0.0;
    }
    bool complete() const { return pixels > 0 && measured == pixels; }
};

class ErrorWatch {
public:
    // news: called from a worker when there is more to show, some times a second, and once when all is measured.
    explicit ErrorWatch(std::function<void()> news, int threads = usual_threads());
    ~ErrorWatch();  // waits for tiles that are being measured: some ms
    ErrorWatch(const ErrorWatch&) = delete;
    ErrorWatch& operator=(const ErrorWatch&) = delete;

    // Forgets what was and measures `tested`, the ray data of the scene's frame. Returns at once.
    // Errors: what the reference tracer refuses.
    Status start(const Scene& scene, RayFrame tested);
    void cancel();  // stops measuring; what was found stays. Returns at once.

    bool measuring() const;
    ErrorSummary summary() const;
    std::vector<PixelErrors> pixels() const;  // top row first; kNotCompared: not measured yet
    // Copies the heat map of screen_px() (RGBA, transparent where nothing is known yet) if it changed since the last call. A pixel that was
    // measured for a coarse grid stands for its cell until the cell is measured.
    bool take_heat(Image<unsigned char>& heat);

    static int usual_threads();

private:
    struct Job;
    struct Task;
    static std::vector<Task> tasks_of(int width, int height);
    void work(const std::stop_token& stop);
    void measure(const Job& job, const Task& task, std::vector<TileErrors>& found) const;
    void take(const Task& task, const std::vector<TileErrors>& found);  // under the mutex
    void paint(PixelRect cell, const PixelErrors& errors);              // under the mutex
    void tell(std::unique_lock<std::mutex>& lock, bool last);           // leaves and takes it

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::shared_ptr<Job> job_;  // nullptr: nothing to do
    ErrorSummary summary_;
    long long measured_ = 0, fate_errors_ = 0, forgiven_ = 0;
    int width_ = 0, height_ = 0, generation_ = 0;  // generation: how many frames were begun
    std::vector<PixelErrors> pixels_;
    Image<unsigned char> heat_;
    bool heat_changed_ = false, telling_ = false;
    double told_at_ = 0.0;
    std::function<void()> news_;
    std::vector<std::jthread> workers_;  // last: end before what they use
};

}  // namespace nullscope::viewer
