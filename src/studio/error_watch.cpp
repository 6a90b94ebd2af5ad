#include "studio/error_watch.h"

#include <algorithm>
#include <array>
#include <utility>

#include "platform/usage.h"
#include "reference/frame_tracer.h"

namespace nullscope::viewer {
namespace {

constexpr double kNewsEvery = 0.25;  // s
constexpr int kMostThreads = 8;

}  // namespace

struct ErrorWatch::Job {
    CameraSpec camera;
    reference::FrameTracer tracer;
    RayFrame tested;
    std::vector<ErrorTask> tasks;
    std::size_t next = 0, done = 0;  // under the mutex; the rest is only read

    std::vector<TileErrors> measure(const ErrorTask& task) const;
};

ErrorWatch::ErrorWatch(std::function<void()> news, std::optional<int> threads) : news_(std::move(news)) {
    const int usual = std::clamp(static_cast<int>(std::thread::hardware_concurrency()) / 2, 1, kMostThreads);
    for (int i = 0; i < threads.value_or(usual); ++i)
        workers_.emplace_back([this](const std::stop_token& stop) { work(stop); });
}

ErrorWatch::~ErrorWatch() {
    for (std::jthread& worker : workers_) worker.request_stop();
}

Status ErrorWatch::start(const Scene& scene, RayFrame tested) {
    if (scene.camera.zoom)  // what is off along the ring is no number of pixels: nothing moves there
        return bad_input("errors of pixels are not measured in a zoom", "camera.fov without [zoom]");
    TRY(tracer, reference::FrameTracer::make(scene));
    const int width = tested.width, height = tested.height;
    auto job =
        std::make_shared<Job>(Job{scene.camera, std::move(*tracer), std::move(tested), error_tasks(width, height)});
    std::shared_ptr<Job> before;  // its frame is given back outside of the lock
    {
        const std::lock_guard lock(mutex_);
        before = std::exchange(job_, std::move(job));
        ++generation_;
        map_ = ErrorMap(width, height);
        heat_changed_ = true;
        summary_ = map_.counts();
        told_ = {};
    }
    wake_.notify_all();
    return Done{};
}

void ErrorWatch::cancel() {
    std::shared_ptr<Job> before;
    const std::lock_guard lock(mutex_);
    before = std::exchange(job_, nullptr);
}

bool ErrorWatch::take_heat(Image<unsigned char>& heat) {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(heat_changed_, false)) return false;
    heat = map_.heat();
    return true;
}

void ErrorWatch::work(const std::stop_token& stop) {
    platform::give_way();  // frames come first
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [this] { return job_ != nullptr && job_->next < job_->tasks.size(); }),
           !stop.stop_requested()) {
        std::shared_ptr<Job> job = job_;
        const ErrorTask task = job->tasks[job->next++];
        lock.unlock();
        const std::vector<TileErrors> found = job->measure(task);
        lock.lock();
        if (job == job_) {  // else it was of another frame
            for (const TileErrors& tile : found) map_.take(tile, task.step);
            heat_changed_ = true;
            const bool first = ++job->done == 1, all = job->done == job->tasks.size();
            if (all || (!telling_ && (first || told_.seconds() > kNewsEvery))) tell(lock, all);
        }
        lock.unlock();
        job.reset();  // perhaps the last to hold that frame
        lock.lock();
    }
}

std::vector<TileErrors> ErrorWatch::Job::measure(const ErrorTask& task) const {
    const ExactTrace exact = [this](const auto& positions) { return tracer.pixels(positions, false); };
    return measure_task(tested, camera, exact, task);
}

// Percentiles of a whole frame take some 10 ms: outside of the lock.
void ErrorWatch::tell(std::unique_lock<std::mutex>& lock, bool last) {
    telling_ = true;
    const int generation = generation_;
    ErrorMap::Found found = map_.found();
    lock.unlock();
    const ErrorSummary summary = std::move(found).summary();
    lock.lock();
    telling_ = false;
    told_ = {};
    if (generation == generation_) {
        if (summary.measured >= summary_.measured) summary_ = summary;
        if (last) job_ = nullptr;
    }
    lock.unlock();
    news_();
    lock.lock();
}

}  // namespace nullscope::viewer
