#include "viewer/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scene/split.h"

namespace nullscope::viewer {
namespace {

constexpr int kTimedFrames = 9, kLeastTimed = 3;   // of each scene, in turn; their median counts
constexpr double kLongestTiming = 4.0;             // s for an effect, unless its least frames take more
constexpr double kBand_ms = 20.0;                  // what the window may have to wait for: a driver draws one thing at a time
constexpr int kFirstRows = 8;

// How long the dearest row of the last picture took, by which the next is cut.
struct Pace {
    double row_ms = 0.0;   // 0: not known
};

// In bands of rows that take some kBand_ms each, so that the window gets its turn between them.
double timed(Renderer& renderer, const gl::Target& target, Pace& pace) {
    const double start = seconds();
    double dearest = 0.0;
    const auto affordable = [&](double row_ms) { return std::max(1, static_cast<int>(kBand_ms / std::max(row_ms, 1e-6))); };
    int rows = pace.row_ms > 0.0 ? std::min(affordable(pace.row_ms), target.height) : kFirstRows;
    for (int row = 0; row < target.height;) {
        const int last = std::min(row + rows, target.height);
        const double begun = seconds();
        renderer.draw_rows(target.framebuffer.id(), target.width, target.height, Output::kDisplay, row, last);
        gl::finish();
        dearest = std::max(dearest, 1e3 * (seconds() - begun) / (last - row));
        if (pace.row_ms == 0.0 && row == 0) dearest = 0.0;   // perhaps it compiled
        rows = std::min(affordable(dearest), 2 * rows);
        row = last;
    }
    pace.row_ms = dearest;
    return 1e3 * (seconds() - start);
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

}  // namespace

struct Painter::Workshop {
    Renderer renderer;
    std::unique_ptr<Renderer> right;   // of a split screen
    std::array<gl::Target, 2> halves;
    std::array<Pace, 2> half_paces;
    std::unique_ptr<Renderer> other;   // without an effect, while measuring
    std::array<gl::Target, 2> targets;
    Pace pace;           // of scenes with these effects
    EffectSet effects;
    double compile_ms = 0.0;
    std::size_t next = 0;

    Workshop() { renderer.keep_finer_sky(); }
    // The right half's spacetime may not have the left one's method.
    Status prepare_right(const Scene& scene, const Method& method) {
        if (right == nullptr) right = std::make_unique<Renderer>(), right->keep_finer_sky();
        const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
        right->set_method(spacetime && has_method(**spacetime, method) ? method : Method{});
        return right->prepare(scene);
    }
    double timed_halves(const Halves& split, const gl::Target& target) {
        double ms = 0.0;
        int x = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            const CameraSpec& camera = (i == 0 ? split.left : split.right).camera;
            if (halves[i].width != camera.width || halves[i].height != camera.height)
                halves[i] = gl::make_target(camera.width, camera.height, gl::Format::kRgba8);
            ms += timed(i == 0 ? renderer : *right, halves[i], half_paces[i]);
            gl::blit(halves[i].colours.front().id(), camera.width, camera.height, target.framebuffer.id(), camera.width, camera.height, x);
            x += camera.width;
        }
        gl::finish();
        return ms;
    }
    const gl::Target& target(int width, int height) {
        gl::Target& chosen = targets[next];
        next = 1 - next;
        if (chosen.width != width || chosen.height != height)
            chosen = gl::make_target(width, height, gl::Format::kRgba8);
        return chosen;
    }
};

Painter::Painter(Window& window, bool threads, std::function<void()> news) : news_(std::move(news)) {
    if (threads) context_ = window.share();
    if (context_ != nullptr)
        thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
    else
        own_ = std::make_unique<Workshop>();
}

Painter::~Painter() { thread_.request_stop(); }

void Painter::ask(PaintJob job) {
    if (own_ != nullptr) {
        busy_ = true;
        do_job(*own_, std::move(job));
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        job_ = std::move(job);
        order_.reset();
        busy_ = true;
    }
    wake_.notify_all();
}

bool Painter::busy() const {
    const std::lock_guard lock(mutex_);
    return busy_;
}

bool Painter::wait(double seconds) {
    std::unique_lock lock(mutex_);
    const auto ready = [this] { return painting_.has_value() || failure_ != nullptr; };
    if (std::isinf(seconds))
        done_.wait(lock, ready);
    else
        done_.wait_for(lock, std::chrono::duration<double>(seconds), ready);
    return ready();
}

std::optional<Painting> Painter::take() {
    const std::lock_guard lock(mutex_);
    if (failure_ != nullptr) std::rethrow_exception(std::exchange(failure_, nullptr));
    if (!painting_) return std::nullopt;
    busy_ = false;
    return std::exchange(painting_, std::nullopt);
}

void Painter::measure(const Scene& scene, const Method& method) {
    if (own_ != nullptr) {   // there is no time to do it in without a hitch
        times_.complete = times_new_ = true;
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        order_ = Order{scene, method};
    }
    wake_.notify_all();
}

std::optional<EffectTimes> Painter::take_times() {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(times_new_, false)) return std::nullopt;
    return times_;
}

bool Painter::interrupted() const {
    const std::lock_guard lock(mutex_);
    return job_.has_value() || thread_.get_stop_token().stop_requested();
}

void Painter::work(const std::stop_token& stop) {
    try {
        context_->make_current();
        Workshop workshop;
        std::unique_lock lock(mutex_);
        while (wake_.wait(lock, stop, [this] { return job_ || order_; }), !stop.stop_requested()) {
            auto job = std::exchange(job_, std::nullopt);
            auto order = job ? std::nullopt : std::exchange(order_, std::nullopt);
            lock.unlock();
            if (job)
                do_job(workshop, std::move(*job));
            else
                do_measure(workshop, *order);
            news_();
            lock.lock();
        }
    } catch (...) {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
    }
    context_->leave();
    done_.notify_all();
    news_();
}

void Painter::do_job(Workshop& workshop, PaintJob job) {
    Renderer& renderer = workshop.renderer;
    renderer.set_method(job.method);
    renderer.set_adaptation(job.adaptation);
    Painting painting;
    const auto split = job.rays ? std::nullopt : halves(job.scene);
    painting.ready = renderer.prepare(split ? split->left : job.scene);
    if (painting.ready && split) painting.ready = workshop.prepare_right(split->right, job.method);
    if (!split) workshop.right.reset();
    if (painting.ready && job.rays) {
        painting.rays = renderer.ray_data();
    } else if (painting.ready) {
        const gl::Target& target = workshop.target(job.scene.camera.width, job.scene.camera.height);
        const int programs = renderer.picture_programs();
        if (effect_set(required_effects(job.scene)) != workshop.effects) workshop.pace = {};
        workshop.effects = effect_set(required_effects(job.scene));
        const auto drawn = [&] { return split ? workshop.timed_halves(*split, target) : timed(renderer, target, workshop.pace); };
        painting.draw_ms = drawn();
        if (renderer.picture_programs() > programs) {   // drivers compile until the first picture is there
            const double first_ms = std::exchange(painting.draw_ms, drawn());
            workshop.compile_ms += std::max(first_ms - painting.draw_ms, 0.0);
        }
        painting.texture = target.colours.front().id();
    }
    painting.notes = renderer.take_notes();
    painting.programs = renderer.picture_programs();
    painting.compile_ms = workshop.compile_ms;
    painting.table_ms = renderer.tables().table_ms();
    painting.rows_ms = renderer.tables().rows_ms();
    painting.job = std::move(job);
    {
        const std::lock_guard lock(mutex_);
        painting_ = std::move(painting);
    }
    done_.notify_all();
}

// With and without in turn, so that what else the machine does falls on both.
void Painter::do_measure(Workshop& workshop, const Order& order) {
    EffectTimes times;
    const auto publish = [&] {
        const std::lock_guard lock(mutex_);
        times_ = times;
        times_new_ = true;
    };
    workshop.renderer.set_method(order.method);
    if (!workshop.renderer.prepare(order.scene)) return;
    if (workshop.other == nullptr) workshop.other = std::make_unique<Renderer>();
    Renderer& other = *workshop.other;
    const gl::Target target = gl::make_target(order.scene.camera.width, order.scene.camera.height, gl::Format::kRgba8);
    for (const Effect effect : effect_set(required_effects(order.scene)).list()) {
        const auto without = without_effect(order.scene, effect);
        if (!without) continue;
        other.set_method(Method{});   // what remains may not know the scene's
        if (has_method(workshop.renderer.tables().spacetime(), order.method) && without->spacetime == order.scene.spacetime)
            other.set_method(order.method);
        if (interrupted()) return;
        if (!other.prepare(*without)) continue;   // the scene cannot be without it: a thermal disc in flat space
        Pace other_pace;
        timed(other, target, other_pace);   // compiles
        timed(workshop.renderer, target, workshop.pace);
        std::vector<double> whole, rest;
        const double begun = seconds();
        for (int i = 0; i < kTimedFrames && (i < kLeastTimed || seconds() - begun < kLongestTiming); ++i) {
            if (interrupted()) return;
            whole.push_back(timed(workshop.renderer, target, workshop.pace));
            rest.push_back(timed(other, target, other_pace));
        }
        times.picture_ms = median(whole);
        times.effects.push_back({effect, times.picture_ms - median(rest)});
        publish();
        news_();
    }
    times.complete = true;
    workshop.other.reset();   // its textures with it
    publish();
}

}  // namespace nullscope::viewer
