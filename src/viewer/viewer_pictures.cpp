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
#include "viewer/panel_rows.h"
#include "viewer/ring_zoom.h"
#include "viewer/tick_lines.h"
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
    const std::string stem = fmt::format("nullscope-{:%Y%m%d-%H%M%S}", fmt::localtime(now));
    std::filesystem::path path = std::filesystem::absolute(stem + ".png");
    for (int n = 2; std::filesystem::exists(path); ++n) path.replace_filename(fmt::format("{}-{}.png", stem, n));
    return path;
}

}  // namespace

void Viewer::ask() {
    const bool busy = painter_->busy();
    if (is_open(view_, kTelescopePanel) && shown_.is_there() && !shown_.painting.job.light && !busy)
        due_.picture = true;  // the panel was just opened
    if (!due_.picture) {
        const bool of_b = cover_.orders[1].asks_for_rays();
        if (!busy && (cover_.accuracy->asks_for_rays() || cover_.orders[0].asks_for_rays() || of_b))
            painter_->ask({shown_.scene(), shown_.painting.job.method, true, 1.0, false,
                           of_b ? shown_.painting.job.side_b : nullptr, false, shown_.painting.job.stage});
        return;
    }
    const Scene scene = drawn_scene(view_);
    const bool coarse = due_.coarse && !patient() && !due_.save;
    if (busy && !(coarse && painter_->gives_up())) return;
    due_.picture = due_.coarse = false;
    if (view_.scene.split) view_.side_b.reset();
    asked_.view = view_;
    asked_.at = seconds();
    asked_.due_at = due_.since;
    asked_.choice = method_choice(methods_.measured, view_.method, scene);
    PaintJob job{scene, asked_.choice.method, false,
                 adaptation_.step(seconds(), patient() || !scene.picture.auto_exposure), coarse};
    job.light = is_open(view_, kTelescopePanel);
    job.stage = view_.stage;
    if (view_.side_b != nullptr) {
        const Scene b = drawn_side_b(view_);
        const Method method = method_choice(methods_.measured, view_.side_b->method, b).method;
        job.side_b =
            std::make_shared<PaintJob>(PaintJob{b, method, false, job.adaptation, coarse, nullptr, false, view_.stage});
    }
    painter_->ask(std::move(job));
}

bool Viewer::take() {
    auto painting = painter_->take();
    if (!painting) return false;
    if (painting->rays) {
        cover_.orders[0].take_rays(painting->job.scene, *painting->rays);
        if (painting->rays_b) cover_.orders[1].take_rays(painting->job.side_b->scene, *painting->rays_b);
        cover_.accuracy->take_rays(painting->job.scene, std::move(*painting->rays));
    } else if (painting->ready)
        show_frame(std::move(*painting));
    else if (!shown_.is_there() && !due_.picture)
        refusal_ = painting->ready.error();
    else
        refuse(*painting);
    return true;
}

void Viewer::show_frame(Painting painting) {
    if (asked_.view.scene.name != shown_.view.scene.name) window_->set_title(asked_.view.scene.name + kTitle);
    if (painting.job.method != shown_.painting.job.method ||
        effect_set(required_effects(painting.job.scene)) != effect_set(required_effects(shown_.scene())) ||
        painting.job.scene.camera.width != shown_.scene().camera.width) {
        effects_.begin(seconds());
    }
    const auto has_eyes = [](const Painting& one) { return one.job.scene.camera.stereo != Stereo::kOff; };
    const bool of_two_eyes = has_eyes(painting) && !has_eyes(shown_.painting);
    shown_.painting = std::move(painting);
    if (const PaintJob* b = shown_.side_b()) shown_.side_words = side_words(shown_.painting.job, *b);
    shown_.zoom_words = zoom_words(shown_.scene());
    ++shown_.number;
    shown_.news_due_at = asked_.due_at;
    rate_.shown(seconds(), moving_, shown_.painting.coarse() ? std::nullopt : std::optional(shown_.painting.draw_ms));
    if (!shown_.painting.notes.empty()) say(shown_.painting.notes.back());
    if (of_two_eyes) say("The window shows what is seen from between the eyes; nullscope capture draws both");
    shown_.choice = asked_.choice;
    cover_.accuracy->frame_is(shown_.scene(), shown_.painting.job.method);
    for (std::size_t side = 0; side < cover_.orders.size(); ++side)
        if (const PaintJob* job = shown_.side(side)) cover_.orders[side].frame_is(job->scene, job->method);
    if (!due_.error_stays) view_.error.clear();
    shown_.view = asked_.view;
    if (due_.save && !shown_.painting.coarse()) save_picture();
}

// Those of the picture on the screen: the scene that is asked for may be another already.
void Viewer::draw_marks() {
    if (!shown_.is_there()) return;
    const ImGuiIO& io = ImGui::GetIO();
    const PixelSize size = window_->framebuffer();  // sharp where pictures are coarse, too
    const float pixels = docked(view_) ? static_cast<float>(size.width) / io.DisplaySize.x : 0.0f;
    const PaintJob* b = shown_.side_b();  // it has the lower right corner, where the scale bar is
    cover_.marks.show(b != nullptr ? b->scene : shown_.scene(), size, static_cast<int>(pixels * menu_height()),
                      static_cast<int>(pixels * 2.0f * ImGui::GetFontSize()));
    cover_.marks.draw();
}

void Viewer::draw(unsigned framebuffer, PixelSize to) {
    if (const SeenPicture seen = panels_.telescope.seen(); shown_.is_there() && seen.texture != 0)
        gl::blit(seen.texture, seen.width, seen.height, framebuffer, to.width, to.height);
    else if (shown_.is_there())
        gl::blit(shown_.painting.texture, shown_.painting.width, shown_.painting.height, framebuffer, to.width,
                 to.height);
    if (shown_.painting.texture_b != 0)
        gl::blit(shown_.painting.texture_b, shown_.painting.width, shown_.painting.height, framebuffer, to.width,
                 to.height, 0, cover_.divider.x() * to.width / size_.width);
}

bool Viewer::shows_orders(std::size_t side) const {
    const PaintJob* job = shown_.side(side);
    return view_.show_orders && shown_.is_there() && job != nullptr && no_orders(job->scene).empty();
}

void Viewer::drag_divider(const Input& input) {
    if (shown_.side_b() == nullptr) return cover_.divider.let_go();
    const ImGuiIO& io = ImGui::GetIO();
    const bool panels = docked(view_) && !gallery_.is_open();
    const double pixels = size_.width / static_cast<double>(io.DisplaySize.x);
    const int before = cover_.divider.x();
    const bool was_under = cover_.divider.under_pointer();
    cover_.divider.follow(input, size_.width, panels ? pixels * side_panel_right() : 0.0,
                          io.WantCaptureMouse || controls_.dragging());
    if (cover_.divider.under_pointer()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (cover_.divider.x() != before || cover_.divider.under_pointer() != was_under) pace_.want(kSettlingFrames);
}

void Viewer::draw_over_sides(float top, float bottom) {
    if (!shown_.is_there()) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float unit = screen.x / static_cast<float>(size_.width);
    const PaintJob* b = shown_.side_b();
    const float parted = b != nullptr ? unit * static_cast<float>(cover_.divider.x()) : screen.x;
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.PushClipRect({0.0f, 0.0f}, {parted, screen.y});
    if (shows_orders(0)) cover_.orders[0].draw();
    if (view_.show_errors && !shown_.scene().split) cover_.accuracy->draw_overlay();
    draw_tick_lines(shown_.painting.stokes);
    OverlayPlace place{view_, shown_.scene(), panels_.probe, 0.0f, parted, top, bottom};
    draw_overlays(Overlay::Where::kPicture, place);
    draw.PopClipRect();
    if (b == nullptr) return;
    draw.PushClipRect({parted, 0.0f}, screen);
    if (shows_orders(1)) cover_.orders[1].draw();
    draw_tick_lines(shown_.painting.stokes_b);
    OverlayPlace beside{view_, b->scene, panels_.probe, parted, screen.x, top, bottom};
    draw_overlays(Overlay::Where::kPicture, beside);
    draw.PopClipRect();
    cover_.divider.draw(shown_.side_words, docked(view_) ? side_panel_right() : 0.0f, top, bottom, unit);
}

Status Viewer::save_screenshot() {
    const PixelSize size = window_->framebuffer();
    return save_png(options_.screenshot, drawn_apart(size, [this, size](unsigned framebuffer) {
                        draw(framebuffer, size);
                        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
                    }));
}

void Viewer::save_picture() {
    due_.save = !shown_.is_there() || shown_.painting.coarse();
    if (due_.save) return;
    const auto path = fresh_screenshot_path();
    Image<unsigned char> picture = drawn_apart(size_, [this](unsigned framebuffer) { draw(framebuffer, size_); });
    mark_saved_picture(shown_.scene(), shown_.painting.stokes, picture);
    PictureOrigin origin{shown_.scene(), scene_folders(shown_.view.source)};
    origin.renderer = info_.renderer, origin.version = kVersionText;
    auto words = displayed_picture_words(origin);
    if (!words) return say(words.error().message());
    words->insert({{"Title", origin.scene.name}, {"Software", fmt::format("nullscope {}", kVersion)}});
    const Status saved = save_png(path, picture, *words);
    say(saved ? fmt::format("Saved {}", path.string()) : saved.error().message());
}

}  // namespace nullscope::viewer
