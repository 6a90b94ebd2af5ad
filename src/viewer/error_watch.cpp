#include "viewer/error_watch.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <utility>

#include "compare/heat_map.h"
#include "reference/frame_tracer.h"

namespace nullscope::viewer {
namespace {

constexpr int kTile = 64;                   // px: some 10 ms of work
constexpr std::array kCoarse = {16, 8, 4};  // px between the pixels measured first; divide kTile
constexpr double kNewsEvery = 0.25;         // s
constexpr int kMostThreads = 8, kNiceness = 5;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

// step 0: every pixel of the rectangle. Else the pixels in the middles of its cells of that size.
struct ErrorWatch::Task {
    PixelRect rect;
    int step;
};

struct ErrorWatch::Job {
    CameraSpec camera;
    reference::FrameTracer tracer;
    RayFrame tested;
    std::vector<Task> tasks;
    std::size_t next = 0, done = 0;  // under the mutex; the rest is only read
};

int ErrorWatch::usual_threads() {
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()) / 2, 1, kMostThreads);
}

ErrorWatch::ErrorWatch(std::function<void()> news, int threads) : news_(std::move(news)) {
    for (int i = 0; i < threads; ++i) workers_.emplace_back([this](const std::stop_token& stop) { work(stop); });
}

ErrorWatch::~ErrorWatch() {
    for (std::jthread& worker : workers_) worker.request_stop();
}

Status ErrorWatch::start(const Scene& scene, RayFrame tested) {
    auto tracer = reference::FrameTracer::make(scene);
    if (!tracer) return tracer.error();
    const int width = tested.width, height = tested.height;
    auto job = std::make_shared<Job>(Job{scene.camera, std::move(*tracer), std::move(tested), tasks_of(width, height)});
    std::shared_ptr<Job> before;  // its frame is given back outside of the lock
    {
        const std::lock_guard lock(mutex_);
        before = std::exchange(job_, std::move(job));
        width_ = width, height_ = height;
        ++generation_;
        measured_ = fate_errors_ = forgiven_ = 0;
        pixels_.assign(static_cast<std::size_t>(width) * height, {});
        heat_ = Image<unsigned char>(width, height, 4);
        heat_changed_ = true;
        summary_ = {};
        summary_.pixels = static_cast<long long>(width) * height;
        told_at_ = now();
    }
    wake_.notify_all();
    return Done{};
}

void ErrorWatch::cancel() {
    std::shared_ptr<Job> before;
    const std::lock_guard lock(mutex_);
    before = std::exchange(job_, nullptr);
}

bool ErrorWatch::measuring() const {
    const std::lock_guard lock(mutex_);
    return job_ != nullptr;
}

ErrorSummary ErrorWatch::summary() const {
    const std::lock_guard lock(mutex_);
    return summary_;
}

std::vector<PixelErrors> ErrorWatch::pixels() const {
    const std::lock_guard lock(mutex_);
    return pixels_;
}

bool ErrorWatch::take_heat(Image<unsigned char>& heat) {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(heat_changed_, false)) return false;
    heat = heat_;
    return true;
}

// Coarse grids over the whole frame, then every pixel, from the middle outward: there is the hole.
std::vector<ErrorWatch::Task> ErrorWatch::tasks_of(int width, int height) {
    std::vector<Task> tasks;
    const auto add_level = [&](int step, int side) {
        const auto first = static_cast<std::ptrdiff_t>(tasks.size());
        for (int y = 0; y < height; y += side)
            for (int x = 0; x < width; x += side)
                tasks.push_back({{x, y, std::min(x + side, width), std::min(y + side, height)}, step});
        const auto off = [&](const Task& task) {
            const double dx = task.rect.left + task.rect.right - width, dy = task.rect.top + task.rect.bottom - height;
            return dx * dx + dy * dy;
        };
        std::stable_sort(tasks.begin() + first, tasks.end(),
                         [&](const Task& a, const Task& b) { return off(a) < off(b); });
    };
    for (const int step : kCoarse) add_level(step, std::max(kTile, kTile * step / 4));
    add_level(0, kTile);
    return tasks;
}

void ErrorWatch::work(const std::stop_token& stop) {
#ifdef __linux__
    [[maybe_unused]] const int niceness = nice(kNiceness);  // of this thread alone: frames come first
#endif
    std::unique_lock lock(mutex_);
    std::vector<TileErrors> found;
    while (wake_.wait(lock, stop, [this] { return job_ != nullptr && job_->next < job_->tasks.size(); }),
           !stop.stop_requested()) {
        std::shared_ptr<Job> job = job_;
        const Task task = job->tasks[job->next++];
        lock.unlock();
        measure(*job, task, found);
        lock.lock();
        if (job == job_) {  // else it was of another frame
            take(task, found);
            const bool all = ++job->done == job->tasks.size();
            if (all || (!telling_ && now() - told_at_ > kNewsEvery)) tell(lock, all);
        }
        lock.unlock();
        job.reset();  // perhaps the last to hold that frame
        lock.lock();
    }
}

void ErrorWatch::measure(const Job& job, const Task& task, std::vector<TileErrors>& found) const {
    const ExactTrace trace = [&job](const std::vector<std::array<double, 2>>& positions) {
        std::vector<RayPixel> rays;
        rays.reserve(positions.size());
        for (const auto& position : positions) rays.push_back(job.tracer.pixel(position[0], position[1]));
        return rays;
    };
    found.clear();
    if (task.step == 0) {
        found.push_back(measure_tile(job.tested, job.camera, trace, task.rect));
        return;
    }
    for (int y = task.rect.top + task.step / 2; y < task.rect.bottom; y += task.step)
        for (int x = task.rect.left + task.step / 2; x < task.rect.right; x += task.step)
            found.push_back(measure_tile(job.tested, job.camera, trace, {x, y, x + 1, y + 1}));
}

void ErrorWatch::take(const Task& task, const std::vector<TileErrors>& found) {
    for (const TileErrors& tile : found) {
        std::size_t i = 0;
        for (int y = tile.rect.top; y < tile.rect.bottom; ++y)
            for (int x = tile.rect.left; x < tile.rect.right; ++x, ++i) {
                const PixelErrors& errors = tile.pixels[i];
                PixelErrors& pixel = pixels_[static_cast<std::size_t>(y) * width_ + x];
                const int half = task.step / 2;
                paint({x - half, y - half, x + std::max(half, 1), y + std::max(half, 1)}, errors);
                if (pixel.end != RayEnd::kNotCompared) continue;  // counted when the grid was coarse
                pixel = errors;
                ++measured_;
                fate_errors_ += errors.end == RayEnd::kDiffers;
                forgiven_ += errors.end == RayEnd::kForgiven;
            }
    }
    heat_changed_ = true;
}

void ErrorWatch::paint(PixelRect cell, const PixelErrors& errors) {
    const auto colour = heat_colour(errors.screen_px(), kPixelHeat);
    for (int y = cell.top; y < std::min(cell.bottom, height_); ++y)
        for (int x = cell.left; x < std::min(cell.right, width_); ++x) {
            unsigned char* texel = heat_.at(x, y);
            std::copy(colour.begin(), colour.end(), texel);
            texel[3] = 255;
        }
}

// Percentiles of a whole frame take some 10 ms: outside of the lock.
void ErrorWatch::tell(std::unique_lock<std::mutex>& lock, bool last) {
    telling_ = true;
    const int generation = generation_;
    std::vector<float> sky, place;
    sky.reserve(static_cast<std::size_t>(measured_));
    for (const PixelErrors& pixel : pixels_) {
        if (pixel.end != RayEnd::kSame) continue;
        if (pixel.escaped) sky.push_back(pixel.sky_px);
        if (pixel.hit) place.push_back(pixel.place_px);
    }
    ErrorSummary summary{summary_.pixels, measured_, fate_errors_, forgiven_, {}, {}};
    lock.unlock();
    summary.sky_px = spread_of(std::move(sky));
    summary.place_px = spread_of(std::move(place));
    lock.lock();
    telling_ = false;
    told_at_ = now();
    if (generation == generation_) {
        if (summary.measured >= summary_.measured) summary_ = summary;
        if (last) job_ = nullptr;
    }
    lock.unlock();
    news_();
    lock.lock();
}

}  // namespace nullscope::viewer
