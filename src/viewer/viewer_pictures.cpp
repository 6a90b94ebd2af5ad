// What the viewer asks of its painter, and what becomes of what it gets.
#include <backends/imgui_impl_opengl3.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

#include "image/image_file.h"
#include "scenefile/picture_scene.h"
#include "version/version.h"
#include "viewer/overlay.h"
#include "viewer/ring_zoom.h"
#include "viewer/viewer.h"

namespace nullscope::viewer {
namespace {

// What `draw` draws to the framebuffer it is given. A window's own framebuffer has no sure content where the window is
// hidden or covered, so it is drawn once more.
Image<unsigned char> drawn_apart(PixelSize size, const std::function<void(unsigned framebuffer)>& draw) {
    const gl::Target target = gl::make_target(size.width, size.height, gl::Format::kRgba8);
    draw(target.framebuffer.id());
    std::vector<unsigned char> rgba(static_cast<std::size_t>(size.width) * size.height * 4);
    gl::read_rgba8(target, rgba.data());
    Image<unsigned char> image(size.width, size.height, 3);
    for (int y = 0; y < size.height; ++y) {
        const unsigned char* from = rgba.data() + static_cast<std::size_t>(size.height - 1 - y) * size.width * 4;
        for (int x = 0; x < size.width; ++x) std::copy_n(from + 4 * x, 3, image.at(x, y));
    }
    return image;
}

// nullscope-YYYYMMDD-HHMMSS.png in the current folder, absolute; -2, -3 ... before the dot where that exists.
std::filesystem::path fresh_screenshot_path() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    const std::string stem = fmt::format("nullscope-{:%Y%m%d-%H%M%S}", local);
    std::filesystem::path path = std::filesystem::absolute(stem + ".png");
    for (int n = 2; std::filesystem::exists(path); ++n) path.replace_filename(fmt::format("{}-{}.png", stem, n));
    return path;
}

}  // namespace

void Viewer::ask() {
    const bool busy = painter_->busy();
    if (!picture_due_) {
        const bool of_b = orders_[1].asks_for_rays();
        if (!busy && (accuracy_->asks_for_rays() || orders_[0].asks_for_rays() || of_b))
            painter_->ask(
                {picture_.job.scene, picture_.job.method, true, 1.0, false, of_b ? picture_.job.side_b : nullptr});
        return;
    }
    const Scene scene = drawn_scene(view_);
    const bool coarse = coarse_wanted_ && !patient() && !save_due_;
    if (busy && !(coarse && painter_->gives_up())) return;
    picture_due_ = coarse_wanted_ = false;
    if (view_.scene.split) view_.side_b.reset();
    asked_ = view_;
    asked_at_ = seconds();
    asked_due_at_ = due_at_;
    asked_choice_ = method_choice(measured_, view_.method, scene);
    PaintJob job{scene, asked_choice_.method, false, adaptation(scene), coarse};
    if (view_.side_b != nullptr) {
        const Scene b = drawn_side_b(view_);
        const Method method = method_choice(measured_, view_.side_b->method, b).method;
        job.side_b = std::make_shared<PaintJob>(PaintJob{b, method, false, job.adaptation, coarse});
    }
    painter_->ask(std::move(job));
}

bool Viewer::take() {
    auto painting = painter_->take();
    if (!painting) return false;
    if (painting->rays) {
        orders_[0].take_rays(painting->job.scene, *painting->rays);
        if (painting->rays_b) orders_[1].take_rays(painting->job.side_b->scene, *painting->rays_b);
        accuracy_->take_rays(painting->job.scene, std::move(*painting->rays));
    } else if (painting->ready)
        show_frame(std::move(*painting));
    else if (picture_.texture == 0 && !picture_due_)
        refusal_ = painting->ready.error();
    else
        refuse(*painting);
    return true;
}

void Viewer::show_frame(Painting painting) {
    if (asked_.scene.name != shown_.scene.name) window_->set_title(asked_.scene.name + kTitle);
    if (painting.job.method != picture_.job.method ||
        effect_set(required_effects(painting.job.scene)) != effect_set(required_effects(picture_.job.scene)) ||
        painting.job.scene.camera.width != picture_.job.scene.camera.width) {
        effect_times_ = {};
        times_asked_ = false;
        changed_at_ = seconds();
    }
    const auto has_eyes = [](const Painting& one) { return one.job.scene.camera.stereo != Stereo::kOff; };
    const bool of_two_eyes = has_eyes(painting) && !has_eyes(picture_);
    picture_ = std::move(painting);
    if (const PaintJob* b = shown_side_b()) side_words_ = side_words(picture_.job, *b);
    zoom_words_ = zoom_words(picture_.job.scene);
    ++pictures_;
    news_due_at_ = asked_due_at_;
    measure_rate();
    if (!picture_.notes.empty()) say(picture_.notes.back());
    if (of_two_eyes) say("The window shows what is seen from between the eyes; nullscope capture draws both");
    choice_ = asked_choice_;
    accuracy_->frame_is(picture_.job.scene, picture_.job.method);
    for (std::size_t side = 0; side < orders_.size(); ++side)
        if (const PaintJob* job = shown_side(side)) orders_[side].frame_is(job->scene, job->method);
    if (!error_stays_) view_.error.clear();
    shown_ = asked_;
    if (save_due_ && !picture_.coarse()) save_picture();
}

// Those of the picture on the screen: the scene that is asked for may be another already.
void Viewer::draw_marks() {
    if (picture_.texture == 0) return;
    const ImGuiIO& io = ImGui::GetIO();
    const PixelSize size = window_->framebuffer();  // sharp where pictures are coarse, too
    const float pixels = view_.show_panels ? static_cast<float>(size.width) / io.DisplaySize.x : 0.0f;
    const PaintJob* b = shown_side_b();  // it has the lower right corner, where the scale bar is
    marks_.show(b != nullptr ? b->scene : picture_.job.scene, size, static_cast<int>(pixels * menu_height()),
                static_cast<int>(pixels * 2.0f * ImGui::GetFontSize()));
    marks_.draw();
}

void Viewer::draw(unsigned framebuffer, PixelSize to) {
    if (picture_.texture != 0)
        gl::blit(picture_.texture, picture_.width, picture_.height, framebuffer, to.width, to.height);
    if (picture_.texture_b != 0)
        gl::blit(picture_.texture_b, picture_.width, picture_.height, framebuffer, to.width, to.height, 0,
                 divider_.x() * to.width / size_.width);
}

bool Viewer::shows_orders(std::size_t side) const {
    const PaintJob* job = shown_side(side);
    return view_.show_orders && picture_.texture != 0 && job != nullptr && no_orders(job->scene).empty();
}

void Viewer::drag_divider(const Input& input) {
    if (shown_side_b() == nullptr) return divider_.let_go();
    const ImGuiIO& io = ImGui::GetIO();
    const bool panels = view_.show_panels && !gallery_.is_open();
    const double pixels = size_.width / static_cast<double>(io.DisplaySize.x);
    const int before = divider_.x();
    const bool was_under = divider_.under_pointer();
    divider_.follow(input, size_.width, panels ? pixels * side_panel_right() : 0.0,
                    io.WantCaptureMouse || controls_.dragging());
    if (divider_.under_pointer()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (divider_.x() != before || divider_.under_pointer() != was_under) frames_due_ = kSettlingFrames;
}

void Viewer::draw_over_sides(float top, float bottom) {
    if (picture_.texture == 0) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float unit = screen.x / static_cast<float>(size_.width);
    const PaintJob* b = shown_side_b();
    const float parted = b != nullptr ? unit * static_cast<float>(divider_.x()) : screen.x;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.PushClipRect({0.0f, 0.0f}, {parted, screen.y});
    if (shows_orders(0)) orders_[0].draw();
    if (view_.show_errors && !picture_.job.scene.split) accuracy_->draw_overlay();
    OverlayPlace place{view_, picture_.job.scene, probe_, 0.0f, parted, top, bottom};
    draw_overlays(Overlay::Where::kPicture, place);
    draw.PopClipRect();
    if (b == nullptr) return;
    draw.PushClipRect({parted, 0.0f}, screen);
    if (shows_orders(1)) orders_[1].draw();
    OverlayPlace beside{view_, b->scene, probe_, parted, screen.x, top, bottom};
    draw_overlays(Overlay::Where::kPicture, beside);
    draw.PopClipRect();
    divider_.draw(side_words_, view_.show_panels ? side_panel_right() : 0.0f, top, bottom, unit);
}

Status Viewer::save_screenshot() {
    const PixelSize size = window_->framebuffer();
    return save_png(options_.screenshot, drawn_apart(size, [this, size](unsigned framebuffer) {
                        draw(framebuffer, size);
                        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
                    }));
}

void Viewer::save_picture() {
    save_due_ = picture_.texture == 0 || picture_.coarse();
    if (save_due_) return;
    const auto path = fresh_screenshot_path();
    Image<unsigned char> picture = drawn_apart(size_, [this](unsigned framebuffer) { draw(framebuffer, size_); });
    mark_saved_picture(picture_.job.scene, picture);
    PictureOrigin origin{picture_.job.scene, scene_folders(shown_.source)};
    origin.renderer = info_.renderer, origin.version = kVersionText;
    auto words = picture_words(origin);
    if (!words) return say(words.error().message());
    words->insert({{"Title", origin.scene.name}, {"Software", fmt::format("nullscope {}", kVersion)}});
    const Status saved = save_png(path, picture, *words);
    say(saved ? fmt::format("Saved {}", path.string()) : saved.error().message());
}

}  // namespace nullscope::viewer
