#include "viewer/viewer.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "base/assets.h"
#include "base/image_file.h"
#include "gl/gl.h"
#include "viewer/screenshot.h"
#include "viewer/theme.h"

namespace nullscope::viewer {
namespace {

constexpr int kSettlingFrames = 3;       // panels answer an event a frame later, and take another to find their size
constexpr int kNewsFrames = 2;           // a measured number may make its panel wider a frame later
constexpr double kIdleWait = 1.0;        // s
constexpr double kCaretWait = 0.1;       // s, while a text field shows a blinking caret
constexpr double kFirstStep = 1.0 / 60;  // s of motion that a key's first frame stands for
constexpr double kLongestStep = 0.1;     // s: a hitch is no leap
constexpr double kMessageTime = 6.0;     // s
constexpr double kRateTime = 0.25;       // s between changes of the numbers in the status line

std::string title_of(const Scene& scene) { return scene.name + " - nullscope"; }

}  // namespace

PanelSystem::PanelSystem(Window& window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

PanelSystem::~PanelSystem() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void PanelSystem::begin_frame() {
    const double scale = window_.content_scale(), ratio = window_.pixel_ratio();
    if (scale != content_scale_ || ratio != pixel_ratio_) {
        content_scale_ = scale, pixel_ratio_ = ratio;
        ImGui_ImplOpenGL3_DestroyDeviceObjects();  // made again, with the new font, by the next NewFrame
        apply_theme(scale, ratio);
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

Result<std::unique_ptr<Viewer>> Viewer::open(const ViewerOptions& options) {
    std::unique_ptr<Viewer> viewer(new Viewer(options));
    if (Status loaded = load_into(viewer->view_, options.scene); !loaded) return loaded.error();
    viewer->view_.shipped = shipped_scenes();
    const CameraSpec& camera = viewer->view_.scene.camera;
    const PixelSize size = options.size.value_or(PixelSize{camera.width, camera.height});
    auto window = Window::open({size, !options.size, options.hidden, title_of(viewer->view_.scene)});
    if (!window) return window.error();
    viewer->window_ = std::move(*window);
    viewer->panel_system_ = std::make_unique<PanelSystem>(*viewer->window_);
    viewer->renderer_ = std::make_unique<Renderer>();
    viewer->renderer_->keep_finer_sky();
    viewer->accuracy_ = std::make_unique<FrameAccuracy>();
    auto measured = load_frontier(assets_directory() / "frontier.csv");
    if (measured)
        viewer->measured_ = std::move(*measured);
    else
        viewer->not_measured_ = measured.error().message;
    viewer->fit_to_window();
    if (Status ready = viewer->try_prepare(); !ready) return ready.error();
    viewer->shown_ = viewer->view_.scene;
    viewer->shown_loaded_ = viewer->view_.loaded;
    return viewer;
}

Status Viewer::run() {
    while (!window_->closing()) {
        if (!step() || options_.after_frames == 0 || ++frames_ < options_.after_frames) continue;
        if (options_.screenshot.empty()) break;
        return save_png(options_.screenshot, drawn_apart(size_, [this](unsigned framebuffer) { draw(framebuffer); }));
    }
    return Done{};
}

bool Viewer::step() {
    const double wait = wait_time();
    waited_ = wait > 0.0;
    const Input& input = window_->poll(wait);
    const double dt = elapsed();
    if (input.happened) frames_due_ = kSettlingFrames;
    if (!message_.empty() && seconds() > message_until_) {
        message_.clear();
        frames_due_ = kSettlingFrames;
    }
    bool changed = fit_to_window();
    if (size_.width == 0 || size_.height == 0) return false;  // minimised

    const ImGuiIO& io = ImGui::GetIO();
    const bool panels_had_pointer = io.WantCaptureMouse;  // in the frame before: a tooltip goes when the pointer leaves
    panel_system_->begin_frame();
    changed = handle_keys(input) || changed;
    const bool escape = std::find(input.pressed.begin(), input.pressed.end(), GLFW_KEY_ESCAPE) != input.pressed.end();
    if (view_.show_errors) accuracy_->draw_overlay();
    const AccuracyPanel accuracy{measured_, not_measured_, choice_, accuracy_->facts(), picture_ms_shown_};
    changed = draw_panels(view_, facts(), accuracy, message_, escape) || changed;
    moving_ = controls_.apply(input, view_, dt, io.WantCaptureMouse, io.WantCaptureKeyboard);
    if (controls_.dragging()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (changed || moving_) {
        prepare();
        frames_due_ = kSettlingFrames;
    }
    const bool watched = view_.show_errors || (view_.show_panels && view_.show_accuracy);
    if (accuracy_->update(watched, moving_ || changed, *renderer_)) frames_due_ = std::max(frames_due_, kNewsFrames);
    if (input.moved && (panels_had_pointer || io.WantCaptureMouse)) frames_due_ = kSettlingFrames;  // tooltips
    if (io.WantTextInput || options_.after_frames > 0) frames_due_ = std::max(frames_due_, 1);
    if (frames_due_ == 0) {
        ImGui::EndFrame();
        return false;
    }
    --frames_due_;
    present();
    return true;
}

double Viewer::wait_time() const {
    if (size_.width == 0 || size_.height == 0) return kIdleWait;
    if (frames_due_ > 0 || controls_.in_motion() || options_.after_frames > 0) return 0.0;
    if (ImGui::GetCurrentContext() != nullptr && ImGui::GetIO().WantTextInput) return kCaretWait;
    const double idle = std::min(kIdleWait, accuracy_->wait());
    return message_.empty() ? idle : std::clamp(message_until_ - seconds(), 0.01, idle);
}

double Viewer::elapsed() {
    const double now = seconds(), since = now - stepped_at_;
    stepped_at_ = now;
    return waited_ ? kFirstStep : std::min(since, kLongestStep);
}

bool Viewer::handle_keys(const Input& input) {
    const ImGuiIO& io = ImGui::GetIO();
    bool changed = false;
    if (io.WantCaptureKeyboard) return false;
    for (const int key : input.pressed) {
        if (key == GLFW_KEY_ESCAPE && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup))
            window_->close();
        else if (key == GLFW_KEY_TAB)
            view_.show_panels = !view_.show_panels;
        else if (key == GLFW_KEY_H)
            view_.show_errors = !view_.show_errors;
        else if (key == GLFW_KEY_F1)
            view_.show_keys = !view_.show_keys;
        else if (key == GLFW_KEY_F12)
            save_picture();
        else if (key == GLFW_KEY_R)
            reset_camera(view_), changed = true;
    }
    return changed;
}

bool Viewer::fit_to_window() {
    const PixelSize size = window_->framebuffer();
    CameraSpec& camera = view_.scene.camera;
    const bool changed = size != size_;
    size_ = size;
    camera.width = std::max(size.width, 1);
    camera.height = std::max(size.height, 1);
    return changed;
}

Status Viewer::try_prepare() {
    choice_ = method_choice(measured_, view_.method, view_.scene);
    renderer_->set_method(choice_.method);
    Status ready = renderer_->prepare(view_.scene);
    if (ready) accuracy_->frame_is(view_.scene, choice_.method);
    return ready;
}

void Viewer::prepare() {
    fit_to_window();  // a scene that was just loaded has a size of its own
    if (Status ready = try_prepare(); !ready) {
        view_.scene = shown_;
        view_.loaded = shown_loaded_;
        view_.method = shown_method_;
        fit_to_window();
        if (Status again = try_prepare(); !again) throw gl::GlError(again.error().message);
        view_.error = ready.error().message;
        return;
    }
    if (view_.scene.name != shown_.name) window_->set_title(title_of(view_.scene));
    view_.error.clear();
    shown_ = view_.scene;
    shown_loaded_ = view_.loaded;
    shown_method_ = view_.method;
}

void Viewer::draw(unsigned framebuffer) {
    renderer_->draw(framebuffer, size_.width, size_.height, Output::kDisplay);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Viewer::present() {
    ImGui::Render();
    const double start = seconds();
    renderer_->draw(0, size_.width, size_.height, Output::kDisplay);
    gl::finish();  // so that the time is the picture's
    picture_ms_ = 1e3 * (seconds() - start);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    window_->swap();
    measure_rate();
}

// Frames that follow each other without a wait tell a rate.
void Viewer::measure_rate() {
    constexpr double kMemory = 0.9;
    const double now = seconds(), frame = now - drawn_at_;
    drawn_at_ = now;
    frame_s_ = waited_ ? 0.0 : frame_s_ > 0.0 ? kMemory * frame_s_ + (1.0 - kMemory) * frame : frame;
    if (now - rate_shown_at_ < kRateTime && frames_due_ > 0) return;
    rate_shown_at_ = now;
    picture_ms_shown_ = picture_ms_;
    fps_shown_ = frames_due_ > 0 && moving_ && frame_s_ > 0.0 ? 1.0 / frame_s_ : 0.0;
}

void Viewer::save_picture() {
    const auto path = fresh_screenshot_path();
    const Status saved = save_png(path, renderer_->picture8());
    say(saved ? fmt::format("Saved {}", path.string()) : saved.error().message);
}

void Viewer::say(const std::string& message) {
    message_ = message;
    message_until_ = seconds() + kMessageTime;
}

FrameFacts Viewer::facts() const {
    const FrameTables& tables = renderer_->tables();
    const gl::Info& info = renderer_->info();
    const std::string version = info.version.substr(0, info.version.find(' '));
    const bool last = frames_due_ <= 1;  // what this frame shows stays
    return {
        picture_ms_shown_, last ? 0.0 : fps_shown_, tables.table_ms(), tables.rows_ms(), size_, info.renderer, version};
}

}  // namespace nullscope::viewer
