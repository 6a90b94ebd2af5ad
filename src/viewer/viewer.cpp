#include "viewer/viewer.h"
#include "viewer/overlay.h"
#include "viewer/panel_rows.h"
#include "viewer/recording_sign.h"
#include "viewer/ring_zoom.h"
#include "viewer/sections.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assets.h"
#include "image/image_file.h"
#include "platform/endings.h"
#include "platform/usage.h"
#include "studio/pace.h"

namespace nullscope::viewer {
namespace {

constexpr const char* kFirstScene = "first-light";

// The last session and the last recording, then files of one's own: those that are there.
std::vector<std::string> recent_files(const ViewState& view) {
    std::vector<std::string> files(view.own.begin(), view.own.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                            view.own.size(), Settings::kMostRecent)));
    for (const auto& kept : {last_recording(), last_session()}) files.insert(files.begin(), kept.string());
    std::erase_if(files, [](const std::string& file) {
        std::error_code error;
        return !std::filesystem::is_regular_file(file, error);
    });
    return files;
}

}  // namespace

Result<std::unique_ptr<Viewer>> Viewer::open(const ViewerOptions& options) {
    std::unique_ptr<Viewer> viewer(new Viewer(options));
    const Settings& settings = viewer->settings_.now;
    if (!viewer->patient()) viewer->settings_.load();
    viewer->view_.own = settings.recent;
    viewer->view_.light_theme = settings.light_theme;
    viewer->view_.numbers = settings.numbers;
    viewer->view_.shipped = shipped_scenes();
    for (const Panel* panel : viewer::panels()) set_open(viewer->view_, *panel, panel->at_first);
    viewer->view_.stage = options.stage;
    if (Status opened = viewer->open_first(); !opened) return opened.error();
    const CameraSpec& camera = viewer->view_.scene.camera;
    const PixelSize usual =
        settings.width > 0 ? PixelSize{settings.width, settings.height} : PixelSize{camera.width, camera.height};
    const PixelSize size = options.size.value_or(usual);
    TRY(window, Window::open(size, !options.size, options.hidden, viewer->view_.scene.name + kTitle, settings.place,
                             options.coarse));
    viewer->window_ = std::move(*window);
    constexpr long long kMostIcon = 1 << 20;
    if (const auto icon = load_image(assets_directory() / "icon.png", kMostIcon))
        viewer->window_->set_icon(icon->width, icon->height, rgba8_of(*icon).data());
    viewer->info_ = gl::info();
    viewer->painter_ = std::make_unique<Painter>(*viewer->window_, !options.one_context, [] { glfwPostEmptyEvent(); });
    viewer->cover_.accuracy = std::make_unique<FrameAccuracy>();
    viewer->methods_ = shipped_methods();
    if (!options.turns.empty()) {
        TRY(opened, viewer->logs_.turns.open(options.turns));
    }
    viewer->logs_.layout.open(options.layout);
    viewer->fit_to_window();
    viewer->shown_.view = viewer->view_;
    if (viewer->painter_->in_background()) viewer->ask();  // it begins before the panels are there
    viewer->panel_system_ = std::make_unique<PanelSystem>(*viewer->window_);
    if (!viewer->patient()) viewer->files_.left = left_scene();
    if (options.gallery || (options.scene.empty() && !viewer->patient()))
        viewer->gallery_.open(viewer->view_.shipped, viewer->panels_.all_tours());
    return viewer;
}

Status Viewer::open_first() {
    if (is_tour_file(options_.scene)) return start_tour(options_.scene);
    return load_into(view_, options_.scene.empty() ? kFirstScene : options_.scene);
}

Status Viewer::run() {
    while (!window_->closing() && !refusal_) {
        if (!step() || !patient() || pace_.frames() < options_.after_frames) continue;
        return options_.screenshot.empty() ? Done{} : save_screenshot();
    }
    if (refusal_) return *refusal_;
    if (size_.width > 0 && !window_->is_full_screen()) {
        const PixelSize size = window_->framebuffer();
        settings_.now.width = size.width, settings_.now.height = size.height;
        settings_.now.place = window_->place();
    }
    keep_settings();
    if (!patient()) files_.autosave.end(view_.scene, view_.loaded);
    flight_.film.cancel();
    // Without the painter's thread: a driver that compiles, a sky that is built and an image that is read cannot be
    // interrupted. Files are written by this thread, so that none is left half done.
    if (painter_->at_work()) platform::end_at_once(0);
    return Done{};
}

bool Viewer::step() {
    const double wait = window_->has_gamepad() ? std::min(wait_time(), kGamepadWait) : wait_time();
    const bool waited = wait > 0.0 && !in_motion();
    const Input& input = window_->poll(wait);
    if (window_->closing()) return false;
    const double cpu = platform::thread_cpu_seconds(), dt = pace_.begin_turn(seconds(), waited);
    if (input.happened) pace_.want(kSettlingFrames);
    if (!input.pressed.empty()) logs_.last_key = input.pressed.back().key;
    follow_times();
    bool changed = fit_to_window();
    due_.coarse |= changed;
    if (size_.width == 0 || size_.height == 0) return false;  // minimised
    const bool news = take();
    if (news) pace_.want(kNewsFrames);

    // In the frame before: a tooltip goes when the pointer leaves.
    const bool panels_had_pointer = ImGui::GetIO().WantCaptureMouse;
    panel_system_->begin_frame(settings_.now.text_scale, view_.light_theme, input.pressed);
    changed |= open_dropped(input) || open_chosen();
    changed |= handle_keys(input);
    drag_divider(input);
    changed |= panels(input);
    follow_path();
    sample_flight();
    moving_ = move(input, dt);
    follow_film();
    keep_bookmark();
    const ImGuiIO& io = ImGui::GetIO();
    if (input.moved || input.happened || changed || moving_ || news) probe(input);
    follow_changes(changed);
    measure_effects(!moving_ && !changed);
    measure_polarisation(!moving_ && !changed);
    follow_watches();
    // In one context the window's first frame would wait for the first picture.
    if (painter_->in_background() || patient() || pace_.drawn_at() > 0.0) ask();
    if (input.moved && (panels_had_pointer || io.WantCaptureMouse))  // tooltips
        pace_.want(kSettlingFrames);
    const bool reading = gallery_.is_open() ? gallery_.loading() : panels_.bookmark_strip.loading();
    if (io.WantTextInput || patient() || reading) pace_.want(1);
    const bool drawn =
        patient() ? settled() : pace_.due() && (news || !painter_->busy() || seconds() - pace_.drawn_at() >= kBusyWait);
    if (drawn) {
        present();
        logs_.turns.turn({1e3 * (platform::thread_cpu_seconds() - cpu), painter_->drawn_by_caller(),
                          shown_.painting.programs, shown_.number, shown_.is_there(), shown_.painting.coarse(),
                          painter_->busy(), shown_.painting.width, shown_.painting.height,
                          shown_.news_due_at ? 1e3 * (seconds() - *shown_.news_due_at) : 0.0});
        shown_.news_due_at.reset();
    } else {
        ImGui::EndFrame();
    }
    log_rest();
    keep_settings();
    if (!patient())
        if (Status kept = files_.autosave.keep(view_.scene, view_.loaded, seconds()); !kept)
            say(kept.error().message());
    return drawn;
}

void Viewer::follow_times() {
    if (message_.ends(seconds())) pace_.want(kSettlingFrames);
    const bool slow = painter_->busy() && (!shown_.is_there() || seconds() - asked_.at > kProgressAfter);
    const PaintProgress progress = slow ? painter_->progress() : PaintProgress{};
    if (progress != progress_) pace_.want(1);
    progress_ = progress;
}

bool Viewer::panels(const Input& input) {
    const bool escape = std::ranges::count(input.pressed, GLFW_KEY_ESCAPE, &KeyPress::key) > 0;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float below_menu = docked(view_) ? menu_height() : 0.0f;
    const auto command = docked(view_) ? draw_menu(view_, escape) : std::nullopt;
    bool changed = command && perform(*command);
    if (gallery_.is_open()) {
        const std::string chosen = gallery_.draw(below_menu, screen.y, recent_files(view_), patient(), escape);
        if (!message_.text().empty()) draw_message(message_.text(), 0.0f, screen.x, screen.y);
        return chosen.empty() ? changed : open_file(chosen) || changed;
    }
    follow_path();  // keys and the menu may have taken it away
    draw_marks();
    const bool of_another = shown_.is_there() && shown_.view.source != view_.source;
    if (!shown_.is_there() || (of_another && progress_ != PaintProgress()))
        draw_wait(view_.scene.name, progress_, of_another);
    if (!settings_.now.hints_seen && !patient() && shown_.is_there() && !panels_.tour.is_open()) draw_hints();
    const FrameFacts facts = frame_facts();
    PanelPlace place{view_, flight_, panels_, facts, 0.0f, screen.x, below_menu, screen.y};
    if (docked(view_)) place.left = side_panel_right(), place.bottom -= status_height();
    place.escape = escape, place.all = patient();
    draw_panels(place, false);
    panels_.strips_top = place.bottom;
    draw_over_sides(below_menu, place.bottom);
    place.top = overlays(below_menu, place.bottom - panels_.tour.height());
    if (shown_.is_there()) left_corner(place.bottom - panels_.tour.height());
    draw_frame_facts(view_, facts, place.bottom);
    draw_panels(place, true);
    changed |= follow_panels() || place.changed;
    changed |= tour_panels(place.left, place.bottom - place.gap);
    if (const std::string path = files_.save_as.draw(escape); !path.empty()) save_scene_as(path);
    return (files_.left && offer_left_scene()) || changed;
}

FrameFacts Viewer::frame_facts() const {
    return {shown_.painting,
            shown_.number,
            rate_.picture_ms(),
            moving_ ? rate_.fps() : 0.0,
            size_,
            info_,
            progress_,
            painter_->in_background(),
            methods_.measured,
            methods_.not_measured,
            shown_.choice,
            painter_->stage_words(),
            cover_.accuracy->facts(),
            effects_.times(),
            polarisation_.numbers()};
}

// What they ask for.
bool Viewer::follow_panels() {
    bool changed = follow_bookmarks();
    if (std::exchange(panels_.timeline.record_pressed, false)) record(), changed = true;
    if (const auto tour = std::exchange(panels_.tour_chosen, std::nullopt)) changed |= open_tour(*tour);
    if (const std::string wanted = std::exchange(view_.wanted, {}); !wanted.empty()) {
        leave_scene();
        changed |= static_cast<bool>(load_into(view_, wanted));  // an error is in the panel
    }
    return changed;
}

// In the part of the picture that side panel and editor leave free.
float Viewer::overlays(float top, float bottom) {
    const float gap = kStripGap * ImGui::GetFontSize(), edge = docked(view_) ? side_panel_right() : 0.0f,
                right = ImGui::GetIO().DisplaySize.x - (docked(view_) ? panels_.editor.width() : 0.0f);
    const std::string& said = message_.text();
    if (!said.empty() || view_.fall.ended())
        draw_message(said.empty() ? end_of_fall(view_) : said, edge, right, bottom);
    if (shown_.is_there()) top = std::max(top, cover_.marks.labels_bottom());
    OverlayPlace place{view_, shown_.scene(), panels_.probe, edge + gap, right - gap, top + gap, bottom};
    draw_overlays(Overlay::Where::kTopLeft, place);
    const float left = place.left;
    draw_zoom_overlay(shown_.zoom_words, left, right - gap, top + gap);
    if (!flight_.timeline.records()) return top;
    return top + gap + draw_recording_sign(flight_.timeline.recorded_s(), left + gap, right - gap, top + gap);
}

// What explains the picture there, one above the other.
void Viewer::left_corner(float bottom) {
    const float left = docked(view_) ? side_panel_right() : 0.0f,
                right =
                    ImGui::GetIO().DisplaySize.x - std::max(docked(view_) ? panels_.editor.width() : 0.0f,
                                                            is_open(view_, kProbePanel) ? panels_.probe.width() : 0.0f);
    OverlayPlace place{view_, shown_.scene(), panels_.probe, left, right, 0.0f, bottom};
    draw_overlays(Overlay::Where::kBottomLeft, place);
    if (shows_orders(0) || shows_orders(1)) draw_order_legend(left, right, place.bottom);
}

bool Viewer::move(const Input& input, double dt) {
    const ImGuiIO& io = ImGui::GetIO();
    bool moved = controls_.apply(input, view_, dt, io.WantCaptureMouse || cover_.divider.has_mouse(),
                                 io.WantCaptureKeyboard || gallery_.is_open());
    if (const auto place = controls_.click(); place && docked(view_)) pick((*place)[0], (*place)[1]);
    moved |= view_.fall.step(view_.scene, dt);
    moved |= step_clock(view_, dt);
    moved |= flight_.timeline.step(view_.scene, dt);
    if (controls_.dragging()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return moved;
}

void Viewer::follow_changes(bool changed) {
    if (changed || moving_) {
        adaptation_.begin();
        due_.coarse |= moving_ || ImGui::IsAnyItemActive() || view_.source != asked_.view.source;
        fit_to_window();  // a scene that was just loaded has a size of its own
        if (!due_.picture) due_.since = pace_.turn_began_at();
        due_.picture = true;
        due_.error_stays = false;
        pace_.want(kSettlingFrames);
    } else {
        if (!ImGui::IsAnyItemActive() && !controls_.dragging() && !in_motion()) history_.rest(view_);
        due_.picture = due_.picture || adapting();
    }
    const bool whole = !shown_.scene().split;  // errors are a single spacetime's
    const bool watched = whole && (view_.show_errors || (docked(view_) && view_.show_accuracy));
    if (cover_.accuracy->update(watched, moving_ || changed || due_.picture)) pace_.want(kNewsFrames);
    for (std::size_t side = 0; side < cover_.orders.size(); ++side)
        cover_.orders[side].update(shows_orders(side), moving_ || changed || due_.picture);
}

// Under the panels' pointer it stays what it was.
void Viewer::probe(const Input& input) {
    if (!is_open(view_, kProbePanel)) return panels_.probe.forget();
    if (ImGui::GetIO().WantCaptureMouse) return;
    const bool on_b = shown_.side_b() != nullptr && input.x >= cover_.divider.x();
    panels_.probe.look(on_b ? shown_.side_b()->scene : shown_.scene(), input.x, input.y);
    pace_.want(kSettlingFrames + 1);  // then what stands beside its window finds its own size
}

bool Viewer::fit_to_window() {
    const PixelSize size = window_->picture();
    const bool changed = size != size_;
    size_ = size;
    set_size(view_.scene, std::max(size.width, 1), std::max(size.height, 1));
    return changed;
}

// What was shown is shown on, unless there was further input meanwhile.
void Viewer::refuse(const Painting& painting) {
    if (painting.job.rays || due_.picture) return;
    const CameraSpec now = std::exchange(view_.scene, shown_.view.scene).camera;
    view_.scene.camera.width = now.width, view_.scene.camera.height = now.height;
    view_.loaded = shown_.view.loaded;
    view_.method = shown_.view.method;
    view_.off = shown_.view.off;
    view_.hidden = shown_.view.hidden;
    view_.side_b = shown_.view.side_b, view_.sides = shown_.view.sides;
    polarisation_.forget();  // the picture stays, but what was asked of it may be dropped
    view_.error = painting.ready.error().message();
    due_.error_stays = true;
    pace_.want(kSettlingFrames);
    if (!docked(view_)) say(view_.error);
    due_.picture = shown_.painting.coarse();
}

void Viewer::say(const std::string& message) {
    message_.say(message, seconds());
    pace_.want(kSettlingFrames);  // a window that appears is drawn a frame later
}

}  // namespace nullscope::viewer
