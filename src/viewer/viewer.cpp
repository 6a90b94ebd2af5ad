#include "viewer/viewer.h"
#include "viewer/overlay.h"
#include "viewer/recording_sign.h"
#include "viewer/ring_zoom.h"
#include "viewer/sections.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "base/assets.h"
#include "image/image_file.h"
#include "viewer/pace.h"

namespace nullscope::viewer {
namespace {

constexpr const char* kFirstScene = "first-light";
constexpr float kStripGap = 0.6f;  // of the font's size, between strips of panels

// Without the painter's thread: a driver that compiles, a sky that is built and an image that is read cannot be
// interrupted. Files are written by this thread, so that none is left half done.
[[noreturn]] void end_process() {
    std::fflush(nullptr);
    std::_Exit(0);
}

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
    Settings& settings = viewer->settings_;
    if (!viewer->patient()) settings = load_settings();
    viewer->kept_settings_ = settings;
    viewer->view_.own = settings.recent;
    viewer->view_.light_theme = settings.light_theme;
    viewer->view_.numbers = settings.numbers;
    viewer->view_.shipped = shipped_scenes();
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
    viewer->accuracy_ = std::make_unique<FrameAccuracy>();
    auto measured = load_frontier(assets_directory() / "frontier.csv");
    if (measured)
        viewer->measured_ = std::move(*measured);
    else
        viewer->not_measured_ = measured.error().message();
    if (!options.turns.empty()) {
        TRY(opened, viewer->log_.open(options.turns));
    }
    viewer->layout_log_.open(options.layout);
    viewer->fit_to_window();
    viewer->shown_ = viewer->view_;
    if (viewer->painter_->in_background()) viewer->ask();  // it begins before the panels are there
    viewer->panel_system_ = std::make_unique<PanelSystem>(*viewer->window_);
    if (!viewer->patient()) viewer->left_ = left_scene();
    if (options.gallery || (options.scene.empty() && !viewer->patient()))
        viewer->gallery_.open(viewer->view_.shipped, viewer->tours());
    return viewer;
}

Status Viewer::open_first() {
    if (is_tour_file(options_.scene)) return start_tour(options_.scene);
    return load_into(view_, options_.scene.empty() ? kFirstScene : options_.scene);
}

Status Viewer::run() {
    while (!window_->closing() && !refusal_) {
        if (!step() || !patient() || ++frames_ < options_.after_frames) continue;
        return options_.screenshot.empty() ? Done{} : save_screenshot();
    }
    if (refusal_) return *refusal_;
    if (size_.width > 0 && !window_->is_full_screen()) {
        const PixelSize size = window_->framebuffer();
        settings_.width = size.width, settings_.height = size.height;
        settings_.place = window_->place();
    }
    keep_settings();
    if (!patient()) autosave_.end(view_.scene, view_.loaded);
    film_.cancel();
    if (painter_->at_work()) end_process();
    return Done{};
}

bool Viewer::step() {
    const double wait = window_->has_gamepad() ? std::min(wait_time(), kGamepadWait) : wait_time();
    waited_ = wait > 0.0 && !in_motion();
    const Input& input = window_->poll(wait);
    if (window_->closing()) return false;
    const double cpu = thread_cpu_seconds(), dt = elapsed();
    turn_began_at_ = seconds();
    if (input.happened) frames_due_ = kSettlingFrames;
    if (!input.pressed.empty()) last_key_ = input.pressed.back().key;
    follow_times();
    bool changed = fit_to_window();
    coarse_wanted_ |= changed;
    if (size_.width == 0 || size_.height == 0) return false;  // minimised
    const bool news = take();
    if (news) frames_due_ = std::max(frames_due_, kNewsFrames);

    // In the frame before: a tooltip goes when the pointer leaves.
    const bool panels_had_pointer = ImGui::GetIO().WantCaptureMouse;
    panel_system_->begin_frame(settings_.text_scale, view_.light_theme, input.pressed);
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
    // In one context the window's first frame would wait for the first picture.
    if (painter_->in_background() || patient() || drawn_at_ > 0.0) ask();
    if (input.moved && (panels_had_pointer || io.WantCaptureMouse))  // tooltips
        frames_due_ = std::max(frames_due_, kSettlingFrames);
    const bool reading = gallery_.is_open() ? gallery_.loading() : view_.show_panels && bookmark_panel_.loading();
    if (io.WantTextInput || patient() || reading) frames_due_ = std::max(frames_due_, 1);
    const bool drawn =
        patient() ? settled() : frames_due_ > 0 && (news || !painter_->busy() || seconds() - drawn_at_ >= kBusyWait);
    if (drawn) {
        --frames_due_;
        present();
        log_.turn({1e3 * (thread_cpu_seconds() - cpu), painter_->drawn_by_caller(), picture_.programs, pictures_,
                   picture_.texture != 0, picture_.coarse(), painter_->busy(),
                   news_due_at_ ? 1e3 * (seconds() - *news_due_at_) : 0.0});
        news_due_at_.reset();
    } else {
        ImGui::EndFrame();
    }
    log_rest();
    keep_settings();
    if (!patient())
        if (Status kept = autosave_.keep(view_.scene, view_.loaded, seconds()); !kept) say(kept.error().message());
    return drawn;
}

void Viewer::follow_times() {
    if (!message_.empty() && seconds() > message_until_) {
        message_.clear();
        frames_due_ = kSettlingFrames;
    }
    const bool slow = painter_->busy() && (picture_.texture == 0 || seconds() - asked_at_ > kProgressAfter);
    const PaintProgress progress = slow ? painter_->progress() : PaintProgress{};
    if (progress != progress_) frames_due_ = std::max(frames_due_, 1);
    progress_ = progress;
}

bool Viewer::panels(const Input& input) {
    const bool escape = std::ranges::count(input.pressed, GLFW_KEY_ESCAPE, &KeyPress::key) > 0;
    const float below_menu = view_.show_panels ? menu_height() : 0.0f, screen = ImGui::GetIO().DisplaySize.y;
    const auto command = view_.show_panels ? draw_menu(view_, escape) : std::nullopt;
    bool changed = command && perform(*command);
    if (gallery_.is_open()) {
        const std::string chosen = gallery_.draw(below_menu, screen, recent_files(view_), patient(), escape);
        if (!message_.empty()) draw_message(message_, 0.0f, ImGui::GetIO().DisplaySize.x, screen);
        return chosen.empty() ? changed : open_file(chosen) || changed;
    }
    draw_marks();
    const bool of_another = picture_.texture != 0 && shown_.source != view_.source;
    if (picture_.texture == 0 || (of_another && progress_ != PaintProgress()))
        draw_wait(view_.scene.name, progress_, of_another);
    // How tall the strips at the bottom were a frame ago: without the bookmarks, with them.
    const float timeline = view_.show_panels ? status_height() + timeline_panel_.height() : 0.0f;
    const float gap = timeline_panel_.height() > 0.0f ? kStripGap * ImGui::GetFontSize() : 0.0f;
    const bool bookmarks = view_.show_panels && bookmark_panel_.height() > 0.0f;
    const float above = timeline + (bookmarks ? gap + bookmark_panel_.height() : 0.0f);
    strips_top_ = screen - above;
    if (view_.show_probe)
        probe_.draw(view_.show_panels ? side_panel_right() : 0.0f, below_menu, screen - timeline - gap,
                    view_.show_potential, view_.numbers);
    draw_over_sides(below_menu, strips_top_);
    const FrameFacts facts{picture_,      picture_ms_shown_, moving_ ? fps_shown_ : 0.0, size_,
                           info_,         progress_,         painter_->in_background(),  measured_,
                           not_measured_, choice_,           accuracy_->facts(),         effect_times_};
    if (!settings_.hints_seen && !patient() && picture_.texture != 0 && !tour_.is_open()) draw_hints();
    if (view_.show_panels) {
        changed |= editor_.draw(view_, below_menu, strips_top_, escape);
        follow_path();  // keys and the editor may have taken it away
        changed |= timeline_panel_.draw(view_, timeline_, film_, side_panel_right(), screen - status_height(), escape);
        if (std::exchange(timeline_panel_.record_pressed, false)) record(), changed = true;
        changed |= draw_bookmarks(screen - timeline - gap, escape);
    }
    const float top = overlays(below_menu, strips_top_ - tour_.height());
    if (picture_.texture != 0) left_corner(strips_top_ - tour_.height());
    changed |= draw_panels(view_, facts, top, strips_top_, escape);
    if (const std::string wanted = std::exchange(view_.wanted, {}); !wanted.empty()) {
        leave_scene();
        changed |= static_cast<bool>(load_into(view_, wanted));  // an error is in the panel
    }
    changed |= tour_panels(view_.show_panels ? side_panel_right() : 0.0f, strips_top_ - gap);
    if (const std::string path = save_as_.draw(escape); !path.empty()) save_scene_as(path);
    return (left_ && offer_left_scene()) || changed;
}

// In the part of the picture that side panel and editor leave free.
float Viewer::overlays(float top, float bottom) {
    const float gap = kStripGap * ImGui::GetFontSize(), edge = view_.show_panels ? side_panel_right() : 0.0f,
                right = ImGui::GetIO().DisplaySize.x - (view_.show_panels ? editor_.width() : 0.0f);
    if (!message_.empty() || view_.fall.ended())
        draw_message(message_.empty() ? end_of_fall(view_) : message_, edge, right, bottom);
    if (picture_.texture != 0) top = std::max(top, marks_.labels_bottom());
    OverlayPlace place{view_, picture_.job.scene, probe_, edge + gap, right - gap, top + gap, bottom};
    draw_overlays(Overlay::Where::kTopLeft, place);
    const float left = place.left;
    draw_zoom_overlay(zoom_words_, left, right - gap, top + gap);
    if (!timeline_.records()) return top;
    return top + gap + draw_recording_sign(timeline_.recorded_s(), left + gap, right - gap, top + gap);
}

// What explains the picture there, one above the other.
void Viewer::left_corner(float bottom) {
    const float left = view_.show_panels ? side_panel_right() : 0.0f,
                right = ImGui::GetIO().DisplaySize.x -
                        std::max(view_.show_panels ? editor_.width() : 0.0f, view_.show_probe ? probe_.width() : 0.0f);
    OverlayPlace place{view_, picture_.job.scene, probe_, left, right, 0.0f, bottom};
    draw_overlays(Overlay::Where::kBottomLeft, place);
    if (shows_orders(0) || shows_orders(1)) draw_order_legend(left, right, place.bottom);
}

bool Viewer::move(const Input& input, double dt) {
    const ImGuiIO& io = ImGui::GetIO();
    bool moved = controls_.apply(input, view_, dt, io.WantCaptureMouse || divider_.has_mouse(),
                                 io.WantCaptureKeyboard || gallery_.is_open());
    if (const auto place = controls_.click(); place && view_.show_panels) pick((*place)[0], (*place)[1]);
    moved |= view_.fall.step(view_.scene, dt);
    moved |= step_clock(view_, dt);
    moved |= timeline_.step(view_.scene, dt);
    if (controls_.dragging()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return moved;
}

void Viewer::follow_changes(bool changed) {
    if (changed || moving_) {
        exposure_left_ = 1.0;
        coarse_wanted_ |= moving_ || ImGui::IsAnyItemActive() || view_.source != asked_.source;
        fit_to_window();  // a scene that was just loaded has a size of its own
        if (!picture_due_) due_at_ = turn_began_at_;
        picture_due_ = true;
        error_stays_ = false;
        frames_due_ = std::max(frames_due_, kSettlingFrames);
    } else {
        if (!ImGui::IsAnyItemActive() && !controls_.dragging() && !in_motion()) history_.rest(view_);
        picture_due_ = picture_due_ || adapting();
    }
    const bool whole = !picture_.job.scene.split;  // errors are a single spacetime's
    const bool watched = whole && (view_.show_errors || (view_.show_panels && view_.show_accuracy));
    if (accuracy_->update(watched, moving_ || changed || picture_due_))
        frames_due_ = std::max(frames_due_, kNewsFrames);
    for (std::size_t side = 0; side < orders_.size(); ++side)
        orders_[side].update(shows_orders(side), moving_ || changed || picture_due_);
}

// Under the panels' pointer it stays what it was.
void Viewer::probe(const Input& input) {
    if (!view_.show_probe) return probe_.forget();
    if (ImGui::GetIO().WantCaptureMouse) return;
    const bool on_b = shown_side_b() != nullptr && input.x >= divider_.x();
    probe_.look(on_b ? shown_side_b()->scene : picture_.job.scene, input.x, input.y);
    frames_due_ = kSettlingFrames + 1;  // then what stands beside its window finds its own size
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
    if (painting.job.rays || picture_due_) return;
    const CameraSpec now = std::exchange(view_.scene, shown_.scene).camera;
    view_.scene.camera.width = now.width, view_.scene.camera.height = now.height;
    view_.loaded = shown_.loaded;
    view_.method = shown_.method;
    view_.off = shown_.off;
    view_.hidden = shown_.hidden;
    view_.side_b = shown_.side_b, view_.sides = shown_.sides;
    view_.error = painting.ready.error().message();
    error_stays_ = true;
    frames_due_ = kSettlingFrames;
    if (!view_.show_panels) say(view_.error);
    picture_due_ = picture_.coarse();
}

void Viewer::say(const std::string& message) {
    message_ = message;
    message_until_ = seconds() + kMessageTime;
    frames_due_ = std::max(frames_due_, kSettlingFrames);  // a window that appears is drawn a frame later
}

}  // namespace nullscope::viewer
