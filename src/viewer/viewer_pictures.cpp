// What the viewer asks of its painter, and what becomes of what it gets.
#include <fmt/format.h>

#include <utility>

#include "base/image_file.h"
#include "gl/gl.h"
#include "viewer/screenshot.h"
#include "viewer/viewer.h"

namespace nullscope::viewer {

void Viewer::ask() {
    const bool busy = painter_->busy();
    if (!picture_due_) {
        if (!busy && accuracy_->asks_for_rays()) painter_->ask({picture_.job.scene, picture_.job.method, true});
        return;
    }
    const Scene scene = drawn_scene(view_);
    // Exposure that follows is metered from picture to picture: all but the first are whole.
    const bool metered = scene.picture.auto_exposure && picture_.texture != 0;
    const bool coarse = coarse_wanted_ && !patient() && !save_due_ && !metered;
    if (busy && !(coarse && painter_->gives_up())) return;
    picture_due_ = coarse_wanted_ = false;
    asked_ = view_;
    asked_at_ = seconds();
    asked_choice_ = method_choice(measured_, view_.method, scene);
    painter_->ask({scene, asked_choice_.method, false, adaptation(scene), coarse});
}

bool Viewer::take() {
    auto painting = painter_->take();
    if (!painting) return false;
    if (painting->rays)
        accuracy_->take_rays(painting->job.scene, std::move(*painting->rays));
    else if (painting->ready)
        adopt(std::move(*painting));
    else if (picture_.texture == 0 && !picture_due_)
        refusal_ = painting->ready.error();
    else
        refuse(*painting);
    return true;
}

void Viewer::adopt(Painting painting) {
    if (asked_.scene.name != shown_.name) window_->set_title(title_of(asked_.scene));
    if (painting.job.method != picture_.job.method ||
        effects_of(painting.job.scene) != effects_of(picture_.job.scene) ||
        painting.job.scene.camera.width != picture_.job.scene.camera.width) {
        effect_times_ = {};
        times_asked_ = false;
        changed_at_ = seconds();
    }
    picture_ = std::move(painting);
    measure_rate();
    if (!picture_.notes.empty()) say(picture_.notes.back());
    choice_ = asked_choice_;
    accuracy_->frame_is(picture_.job.scene, picture_.job.method);
    view_.error.clear();
    shown_ = asked_.scene;
    shown_loaded_ = asked_.loaded;
    shown_method_ = asked_.method;
    shown_off_ = asked_.off;
    if (save_due_ && !picture_.coarse()) save_picture();
}

void Viewer::draw(unsigned framebuffer) {
    if (picture_.texture != 0)
        gl::blit(picture_.texture, picture_.width, picture_.height, framebuffer, size_.width, size_.height);
}

void Viewer::save_picture() {
    save_due_ = picture_.texture == 0 || picture_.coarse();
    if (save_due_) return;
    const auto path = fresh_screenshot_path();
    const Status saved = save_png(path, drawn_apart(size_, [this](unsigned framebuffer) { draw(framebuffer); }));
    say(saved ? fmt::format("Saved {}", path.string()) : saved.error().message);
}

}  // namespace nullscope::viewer
