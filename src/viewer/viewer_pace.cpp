// When the window's loop waits, what it takes for rest, and what it measures then.
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "viewer/pace.h"
#include "viewer/viewer.h"

namespace nullscope::viewer {

// Screenshots' runs do not depend on time.
double Viewer::adaptation(const Scene& scene) {
    const double now = seconds(), since = std::min(now - adapted_at_, kLongestFrameStep);
    adapted_at_ = now;
    const double share = patient() || !scene.picture.auto_exposure ? 1.0 : 1.0 - std::exp(-since / kAdaptation);
    exposure_left_ *= 1.0 - share;
    return share;
}

bool Viewer::adapting() const { return exposure_left_ > kAdapted && view_.scene.picture.auto_exposure && !patient(); }

void Viewer::log_rest() {
    if (!(log_.is_open() || layout_log_.is_open()) || !settled() || frames_due_ > 0 || in_motion() || adapting())
        return;
    const bool times_due = view_.show_panels && view_.show_effects && !effect_times_.complete;
    window_->framebuffer();  // an answer of the display's server: it has shown what it was sent before
    if (const Status written = layout_log_.rest(last_key_); !written) say(written.error().message());
    log_.rest(last_key_, accuracy_->at_work() || orders_at_work() || times_due);
}

bool Viewer::in_motion() const {
    return controls_.in_motion() || view_.fall.runs() || view_.clock_runs || timeline_.plays();
}

bool Viewer::settled() const {
    return picture_.texture != 0 && !picture_.coarse() && !picture_due_ && !painter_->busy();
}

double Viewer::wait_time() const {
    const bool busy = painter_->busy();
    if (size_.width == 0 || size_.height == 0) return kIdleWait;
    if (patient()) return busy ? kIdleWait : 0.0;
    if (in_motion()) return busy ? kBusyWait : 0.0;
    if (frames_due_ > 0) return busy ? std::clamp(drawn_at_ + kBusyWait - seconds(), 0.0, kBusyWait) : 0.0;
    if (ImGui::GetCurrentContext() != nullptr && ImGui::GetIO().WantTextInput) return kCaretWait;
    if (busy) return kProgressWait;
    if (timeline_.records() || film_.runs() || file_dialog_.runs()) return kProgressWait;
    if (adapting()) return kAdaptingWait;
    double idle = std::min({kIdleWait, accuracy_->wait(), orders_[0].wait(), orders_[1].wait()});
    if (view_.show_effects && !times_asked_)
        idle = std::min(idle, std::max(changed_at_ + kRestBeforeTimes - seconds(), 0.01));
    return message_.empty() ? idle : std::min(std::max(message_until_ - seconds(), 0.01), idle);
}

double Viewer::elapsed() {
    const double now = seconds(), since = now - stepped_at_;
    stepped_at_ = now;
    return waited_ ? kFirstStep : std::min(since, kLongestFrameStep);
}

// Once for every set of effects, when the picture rests and somebody looks.
void Viewer::measure_effects(bool still) {
    if (auto times = painter_->take_times()) {
        effect_times_ = std::move(*times);
        frames_due_ = std::max(frames_due_, kNewsFrames);
    }
    const bool wanted = view_.show_panels && view_.show_effects;
    if (!wanted || times_asked_ || !still || picture_due_ || painter_->busy() ||
        seconds() - changed_at_ < kRestBeforeTimes)
        return;
    times_asked_ = true;
    painter_->measure(picture_.job.scene, picture_.job.method);
}

void Viewer::present() {
    ImGui::Render();
    layout_log_.look();
    draw(0, window_->framebuffer());
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    gl::finish();  // the picture's texture may be drawn to again
    window_->swap();
    drawn_at_ = seconds();
}

// Pictures that follow each other without a wait tell a rate.
void Viewer::measure_rate() {
    constexpr double kMemory = 0.9;
    const double now = seconds(), between = now - shown_at_;
    shown_at_ = now;
    frame_s_ = !moving_ ? 0.0 : frame_s_ > 0.0 ? kMemory * frame_s_ + (1.0 - kMemory) * between : between;
    if (now - rate_shown_at_ < kRateTime && moving_) return;
    rate_shown_at_ = now;
    if (!picture_.coarse()) picture_ms_shown_ = picture_.draw_ms;
    fps_shown_ = frame_s_ > 0.0 ? 1.0 / frame_s_ : 0.0;
}

}  // namespace nullscope::viewer
