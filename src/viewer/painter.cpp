#include "viewer/painter.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace nullscope::viewer {
namespace {

constexpr int kTimedFrames = 9, kLeastTimed = 3;  // of each scene, in turn; their median counts
constexpr std::chrono::milliseconds kRestBeforeWhole{100};
constexpr std::chrono::milliseconds kRestBeforeTrial{1500};  // of shaders, whose compiling keeps a job waiting
constexpr double kLongestTiming = 4.0;                       // s for an effect, unless its least frames take more

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

// Both pictures of a pair by programs of the same kind: those of the one without the effect are not built for tiles.
class AlikeTiles {
public:
    explicit AlikeTiles(Renderer& renderer) : renderer_(renderer) { renderer_.limit_tiles_once_built(Tiles::kBodies); }
    ~AlikeTiles() { renderer_.limit_tiles_once_built(Tiles::kInterpolated); }
    AlikeTiles(const AlikeTiles&) = delete;
    AlikeTiles& operator=(const AlikeTiles&) = delete;

private:
    Renderer& renderer_;
};

}  // namespace

Painter::Painter(Window& window, bool threads, std::function<void()> news) : news_(std::move(news)) {
    if (threads) context_ = window.share();
    if (context_ != nullptr)
        thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
    else
        own_ = std::make_unique<FrameRenderer>();
}

void Painter::ask(PaintJob job) {
    if (own_ != nullptr) {
        busy_ = true;
        ++drawn_by_caller_;
        do_job(*own_, job);
        stage_words_ = own_->stage_words();
        news_();  // the caller's loop is about to wait for events
        return;
    }
    const std::lock_guard lock(mutex_);
    if (!job.rays) polarisation_.reset();  // of the picture before
    job_ = std::move(job);
    painting_.reset();
    order_.reset();
    busy_ = true;
    gives_up_ = false;
    wake_.notify_all();
}

bool Painter::at_work() const {
    const std::lock_guard lock(mutex_);
    return at_work_ || job_ || order_ || polarisation_;
}

std::optional<Painting> Painter::take() {
    const std::lock_guard lock(mutex_);
    if (failure_ != nullptr) std::rethrow_exception(std::exchange(failure_, nullptr));
    if (!painting_) return std::nullopt;
    if (painting_->texture != 0) shown_ = {painting_->texture, painting_->texture_b};
    if (last_) busy_ = false;
    return std::exchange(painting_, std::nullopt);
}

void Painter::publish(Painting painting, bool last) {
    const std::lock_guard lock(mutex_);
    gives_up_ = !last;
    if (job_) return;  // nobody waits for this one any more
    painting_ = std::move(painting);
    last_ = last;
    if (last) progress_ = {};
}

void Painter::measure(const Scene& scene, const Method& method) {
    if (own_ != nullptr) {  // there is no time to do it in without a hitch
        times_.emplace().complete = true;
        return;
    }
    const std::lock_guard lock(mutex_);
    order_ = PaintJob{scene, method};
    wake_.notify_all();
}

std::optional<EffectTimes> Painter::take_times() {
    const std::lock_guard lock(mutex_);
    return std::exchange(times_, std::nullopt);
}

void Painter::measure_polarisation(const Scene& scene, const Method& method) {
    if (own_ != nullptr) return do_polarisation(*own_, {scene, method});
    const std::lock_guard lock(mutex_);
    polarisation_ = PaintJob{scene, method};
    wake_.notify_all();
}

std::optional<std::optional<PolarisationNumbers>> Painter::take_polarisation() {
    const std::lock_guard lock(mutex_);
    return std::exchange(numbers_, std::nullopt);
}

void Painter::do_polarisation(FrameRenderer& frame_renderer, const PaintJob& order) {
    frame_renderer.renderer().set_method(order.method);
    auto found = polarisation_numbers(frame_renderer.renderer(), order.scene);
    const std::lock_guard lock(mutex_);
    numbers_ = std::move(found);
}

void Painter::trace_loop(std::optional<LoopOrder> order) {
    const std::lock_guard lock(mutex_);
    loop_order_ = std::move(order);
    loop_asked_ = loop_due_ = true;
    loop_.reset();
    wake_.notify_all();
}

std::optional<StokesLoop> Painter::take_loop() {
    std::unique_lock lock(mutex_);
    if (own_ != nullptr && loop_due_) do_loop(own_trace_, lock);
    return std::exchange(loop_, std::nullopt);
}

// One point: a job that comes meanwhile waits for no more. lock: is free while it draws.
void Painter::do_loop(LoopTrace& trace, std::unique_lock<std::mutex>& lock) {
    if (std::exchange(loop_asked_, false)) trace.begin(std::exchange(loop_order_, std::nullopt));
    if (trace.runs()) {
        lock.unlock();
        StokesLoop found = trace.step();
        lock.lock();
        if (!loop_asked_) loop_ = std::move(found);
    }
    loop_due_ = loop_asked_ || trace.runs();
}

bool Painter::interrupted() const {
    const std::lock_guard lock(mutex_);
    return job_.has_value() || thread_.get_stop_token().stop_requested();
}

TexturesInUse Painter::textures_in_use() const {
    const std::lock_guard lock(mutex_);
    return {shown_[0], shown_[1], painting_ ? painting_->texture : 0, painting_ ? painting_->texture_b : 0};
}

void Painter::work(const std::stop_token& stop) {
    try {
        make_current(context_);
        FrameRenderer frame_renderer;
        LoopTrace trace;
        std::unique_lock lock(mutex_);
        while (wake_.wait(lock, stop, [this] { return job_ || order_ || polarisation_ || loop_due_; }),
               !stop.stop_requested()) {
            if (!job_ && loop_due_) {
                do_loop(trace, lock);
                lock.unlock();
                news_();
                lock.lock();
                continue;
            }
            const auto job = std::exchange(job_, std::nullopt);
            const auto numbers = job ? std::nullopt : std::exchange(polarisation_, std::nullopt);
            const auto order = job || numbers ? std::nullopt : std::exchange(order_, std::nullopt);
            at_work_ = true;
            lock.unlock();
            if (job)
                do_job(frame_renderer, *job);
            else if (numbers)
                do_polarisation(frame_renderer, *numbers);
            else
                do_measure(frame_renderer, *order);
            lock.lock();
            at_work_ = false;
            stage_words_ = frame_renderer.stage_words();
            lock.unlock();
            news_();
            // At rest, what makes the next pictures cheaper; a job waits for one program at most.
            while (job && !interrupted() && frame_renderer.build_next()) {
            }
            if (job && !interrupted()) frame_renderer.warm_up(*job, textures_in_use(), quiet_watch());
            if (job && !interrupted()) try_stages(frame_renderer, *job);
            lock.lock();
        }
    } catch (...) {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
        at_work_ = false;
    }
    leave_context();
    news_();
}

// whole_job: a newer job does not end it.
DrawWatch Painter::watch(bool whole_job) {
    return {[this, whole_job] { return whole_job ? thread_.get_stop_token().stop_requested() : interrupted(); },
            [this](const PaintProgress& progress) {
                const std::lock_guard lock(mutex_);
                progress_ = progress;
            }};
}

DrawWatch Painter::quiet_watch() const {
    return {[this] { return interrupted(); }, [](const PaintProgress&) {}};
}

void Painter::do_job(FrameRenderer& frame_renderer, const PaintJob& job) {
    if (job.rays) return publish(frame_renderer.rays(job), true);
    const double coarseness = own_ != nullptr ? 1.0 : frame_renderer.coarseness(job);
    const bool first = coarseness > 1.0 || (own_ == nullptr && job.coarse_first && frame_renderer.drafts(job));
    if (first) {
        auto coarse = frame_renderer.picture(job, coarseness, true, textures_in_use(), watch(true));
        if (!coarse) return;
        const bool good = static_cast<bool>(coarse->ready);
        publish(std::move(*coarse), !good);
        news_();
        if (!good || goes_on()) return;
    }
    const bool may_be_left = first || !job.coarse_first;
    if (may_be_left) {
        const std::lock_guard lock(mutex_);
        gives_up_ = !job_;
    }
    if (auto whole = frame_renderer.picture(job, 1, false, textures_in_use(), watch(!may_be_left)))
        publish(std::move(*whole), true);
}

// At work meanwhile, for a program may take seconds to compile.
void Painter::try_stages(FrameRenderer& frame_renderer, const PaintJob& job) {
    if (!frame_renderer.asks_to_try_stages(job)) return;
    {
        std::unique_lock lock(mutex_);
        wake_.wait_for(lock, thread_.get_stop_token(), kRestBeforeTrial,
                       [this] { return job_ || order_ || polarisation_ || loop_due_; });
        if (job_ || order_ || polarisation_ || loop_due_) return;
        at_work_ = true;
    }
    const bool tried = frame_renderer.try_stages(job, quiet_watch());
    {
        const std::lock_guard lock(mutex_);
        at_work_ = false;
        stage_words_ = frame_renderer.stage_words();
    }
    if (tried) news_();
}

// In motion: a newer job comes soon after the picture was shown.
bool Painter::goes_on() {
    std::unique_lock lock(mutex_);
    const std::stop_token stop = thread_.get_stop_token();
    wake_.wait_for(lock, stop, kRestBeforeWhole, [this] { return job_.has_value(); });
    return job_.has_value() || stop.stop_requested();
}

// With and without in turn, so that what else the machine does falls on both.
void Painter::do_measure(FrameRenderer& frame_renderer, const PaintJob& order) {
    const AlikeTiles alike(frame_renderer.renderer());
    EffectTimes times;
    const auto publish_times = [&] {
        const std::lock_guard lock(mutex_);
        times_ = times;
    };
    const DrawWatch watch = quiet_watch();
    Renderer& renderer = frame_renderer.renderer();
    renderer.set_method(order.method);
    if (!renderer.prepare(order.scene)) return;
    Renderer& other = frame_renderer.other();
    const gl::Target target = gl::make_target(order.scene.camera.width, order.scene.camera.height, gl::Format::kRgba8);
    for (const Effect effect : renderer.tables().effects().list()) {
        const auto without = without_effect(order.scene, effect);
        if (!without) continue;
        other.set_method(Method{});  // what remains may not know the scene's
        if (has_method(renderer.tables().spacetime(), order.method) && without->spacetime == order.scene.spacetime)
            other.set_method(order.method);
        if (interrupted()) return;
        if (!other.prepare(*without)) continue;  // the scene cannot be without it: a thermal disc in flat space
        double other_ray_ms = 0.0;
        std::vector<double> whole, rest;
        const auto time_both = [&] {
            const auto with = draw_in_bands(renderer, target, frame_renderer.ray_ms(), watch);
            const auto less = with ? draw_in_bands(other, target, other_ray_ms, watch) : std::nullopt;
            if (less) whole.push_back(with->draw_ms), rest.push_back(less->draw_ms);
            return less.has_value();
        };
        if (!time_both()) return;  // compiles: does not count
        whole.clear(), rest.clear();
        const double begun = seconds();
        for (int i = 0; i < kTimedFrames && (i < kLeastTimed || seconds() - begun < kLongestTiming); ++i)
            if (!time_both()) return;
        times.picture_ms = median(whole);
        times.effects[effect] = times.picture_ms - median(rest);
        publish_times();
        news_();
    }
    times.complete = true;
    frame_renderer.drop_other();  // its textures with it
    publish_times();
}

}  // namespace nullscope::viewer
