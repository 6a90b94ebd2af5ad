#include "viewer/error_watch.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "compare/heat_map.h"
#include "reference/frame_tracer.h"

namespace nullscope::viewer {
namespace {

constexpr int kTile = 64;                   // px: some 10 ms of work
constexpr std::array kCoarse = {16, 8, 4};  // px between the pixels measured first; divide kTile
constexpr double kNewsEvery = 0.25;         // s
constexpr int kMostThreads = 8, kNiceness = 5;

// step 0: every pixel of the rectangle. Else the pixels in the middles of its cells of that size.
struct Task {
    PixelRect rect;
    int step;
};

// Coarse grids over the whole frame, then every pixel, from the middle outward: there is the hole.
std::vector<Task> tasks_of(int width, int height) {
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
        std::ranges::stable_sort(tasks.begin() + first, tasks.end(), {}, off);
    };
    for (const int step : kCoarse) add_level(step, std::max(kTile, kTile * step / 4));
    add_level(0, kTile);
    return tasks;
}

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

struct ErrorWatch::Job {
    CameraSpec camera;
    reference::FrameTracer tracer;
    RayFrame tested;
    std::vector<Task> tasks;
    std::size_t next = 0, done = 0;  // under the mutex; the rest is only read

    std::vector<TileErrors> measure(const Task& task) const;
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
    auto job = std::make_shared<Job>(Job{scene.camera, std::move(*tracer), std::move(tested), tasks_of(width, height)});
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
#ifdef __linux__
    [[maybe_unused]] const int niceness = nice(kNiceness);  // of this thread alone: frames come first
#endif
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [this] { return job_ != nullptr && job_->next < job_->tasks.size(); }),
           !stop.stop_requested()) {
        std::shared_ptr<Job> job = job_;
        const Task task = job->tasks[job->next++];
        lock.unlock();
        const std::vector<TileErrors> found = job->measure(task);
        lock.lock();
        if (job == job_) {  // else it was of another frame
            for (const TileErrors& tile : found) map_.take(tile, task.step);
            heat_changed_ = true;
            const bool all = ++job->done == job->tasks.size();
            if (all || (!telling_ && told_.seconds() > kNewsEvery)) tell(lock, all);
        }
        lock.unlock();
        job.reset();  // perhaps the last to hold that frame
        lock.lock();
    }
}

std::vector<TileErrors> ErrorWatch::Job::measure(const Task& task) const {
    const ExactTrace trace = [this](const std::vector<std::array<double, 2>>& positions) {
        std::vector<RayPixel> rays;
        rays.reserve(positions.size());
        for (const auto& position : positions) rays.push_back(tracer.pixel(position[0], position[1]));
        return rays;
    };
    if (task.step == 0) return {measure_tile(tested, camera, trace, task.rect)};
    std::vector<TileErrors> found;
    for (int y = task.rect.top + task.step / 2; y < task.rect.bottom; y += task.step)
        for (int x = task.rect.left + task.step / 2; x < task.rect.right; x += task.step)
            found.push_back(measure_tile(tested, camera, trace, {x, y, x + 1, y + 1}));
    return found;
}

// Percentiles of a whole frame take some 10 ms: outside of the lock.
void ErrorWatch::tell(std::unique_lock<std::mutex>& lock, bool last) {
    telling_ = true;
    const int generation = generation_;
    std::vector<float> sky, place;
    sky.reserve(static_cast<std::size_t>(map_.counts().measured));
    for (const PixelErrors& pixel : map_.pixels()) {
        if (pixel.end != RayEnd::kSame) continue;
        if (pixel.escaped) sky.push_back(pixel.sky_px);
        if (pixel.hit) place.push_back(pixel.place_px);
    }
    ErrorSummary summary = map_.counts();
    lock.unlock();
    summary.sky_px = spread_of(std::move(sky));
    summary.place_px = spread_of(std::move(place));
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
