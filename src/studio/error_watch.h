// The true error of the frame on the screen: every pixel against the reference tracer, on threads of its own, coarse to fine.
//
// Owners: the caller hands over a frame of ray data and never sees it again; workers read it. What they find lies behind one
// mutex and is copied out. No OpenGL and no window in it.
#pragma once
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "base/result.h"
#include "base/stopwatch.h"
#include "compare/error_map.h"
#include "image/image.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::viewer {

class ErrorWatch {
public:
    // news: called from a worker when there is more to show: of the first some sixty pixels, then some times a second, and once when all is
    // measured.
    // threads: half of the processor's where none are given.
    explicit ErrorWatch(std::function<void()> news, std::optional<int> threads = {});
    ~ErrorWatch();  // waits for tiles that are being measured: some ms

    // Forgets what was and measures `tested`, the ray data of the scene's frame. Returns at once.
    // Errors: what the reference tracer refuses.
    Status start(const Scene& scene, RayFrame tested);
    void cancel();  // stops measuring; what was found stays. Returns at once.

    bool measuring() const { return locked(job_) != nullptr; }
    ErrorSummary summary() const { return locked(summary_); }
    std::vector<PixelErrors> pixels() const { return locked(map_).pixels(); }  // top row first
    // Copies the heat map if it changed since the last call.
    bool take_heat(Image<unsigned char>& heat);

private:
    struct Job;
    template <class T>
    T locked(const T& member) const {
        const std::lock_guard lock(mutex_);
        return member;
    }
    void work(const std::stop_token& stop);
    void tell(std::unique_lock<std::mutex>& lock, bool last);  // leaves and takes it

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::shared_ptr<Job> job_;  // nullptr: nothing to do
    ErrorSummary summary_;
    ErrorMap map_;
    int generation_ = 0;  // how many frames were begun
    bool heat_changed_ = false, telling_ = false;
    Stopwatch told_;  // since news
    std::function<void()> news_;
    std::vector<std::jthread> workers_;  // last: end before what they use
};

}  // namespace nullscope::viewer
