// When the window's loop waits, what it takes for rest, and what it measures then.
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "studio/pace.h"
#include "viewer/panel_rows.h"
#include "viewer/viewer.h"

namespace nullscope::viewer {

// Screenshots' runs do not depend on time.
bool Viewer::adapting() const { return adaptation_.goes_on() && view_.scene.picture.auto_exposure && !patient(); }

void Viewer::log_rest() {
    if (!logs_.are_kept() || !settled() || pace_.due() || in_motion() || adapting()) return;
    const bool times_due = docked(view_) && view_.show_effects && !effects_.times().complete;
    window_->framebuffer();  // an answer of the display's server: it has shown what it was sent before
    if (const Status written = logs_.layout.rest(logs_.last_key); !written) say(written.error().message());
    const bool loop_due = is_open(view_, kLoopPanel) && panels_.loop.waits();
    logs_.turns.rest(logs_.last_key, cover_.accuracy->at_work() || cover_.orders_at_work() || times_due || loop_due ||
                                         polarisation_.waits() || panels_.changes.at_work());
}

bool Viewer::in_motion() const {
    return controls_.in_motion() || view_.fall.runs() || view_.clock_runs || flight_.timeline.plays();
}

bool Viewer::settled() const {
    return shown_.is_there() && !shown_.painting.coarse() && !due_.picture && !painter_->busy();
}

double Viewer::wait_time() const {
    LoopWork work;
    work.minimised = size_.width == 0 || size_.height == 0;
    work.patient = patient();
    work.painting = painter_->busy();
    work.in_motion = in_motion();
    work.caret = ImGui::GetCurrentContext() != nullptr && ImGui::GetIO().WantTextInput;
    work.in_progress = flight_.timeline.records() || flight_.film.runs() || files_.dialog.runs();
    work.adapting = adapting();
    const double now = seconds(), times = view_.show_effects ? effects_.wait(now) : kIdleWait;
    work.next = std::min({times, cover_.wait(), message_.left(now)});
    return pace_.wait(work, now);
}

// When the picture rests and somebody looks.
void Viewer::measure_effects(bool still) {
    if (auto times = painter_->take_times()) {
        effects_.take(std::move(*times));
        pace_.want(kNewsFrames);
    }
    const bool wanted = docked(view_) && view_.show_effects;
    if (wanted && still && !due_.picture && !painter_->busy() && effects_.asks(seconds()))
        painter_->measure(shown_.scene(), shown_.painting.job.method);
}

void Viewer::measure_polarisation(bool still) {
    if (auto numbers = painter_->take_polarisation()) {
        polarisation_.take(std::move(*numbers));
        pace_.want(kNewsFrames);
    }
    if (!shown_.is_there() || !has_polarisation_numbers(shown_.scene())) return polarisation_.forget();
    if (docked(view_) && view_.show_numbers && still && settled() && polarisation_.asks(shown_.number))
        painter_->measure_polarisation(shown_.scene(), shown_.painting.job.method);
}

void Viewer::follow_watches() {
    if (panels_.changes.take_news()) pace_.want(kNewsFrames);
    if (!is_open(view_, kLoopPanel)) {
        if (std::exchange(traces_loop_, false)) painter_->trace_loop({});
        return;
    }
    if (auto order = panels_.loop.take_order()) {
        painter_->trace_loop(std::move(order));
        traces_loop_ = true;
    }
    if (auto loop = painter_->take_loop()) {
        panels_.loop.take(std::move(*loop));
        pace_.want(kSettlingFrames);
    }
}

void Viewer::present() {
    ImGui::Render();
    logs_.layout.look();
    draw(0, window_->framebuffer());
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    gl::finish();  // the picture's texture may be drawn to again
    window_->swap();
    pace_.drawn(seconds());
}

}  // namespace nullscope::viewer
