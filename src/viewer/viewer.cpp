#include "viewer/viewer.h"
#include "viewer/sections.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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
constexpr double kBusyWait = 0.03;        // s, while a picture is awaited and another is due
constexpr double kFirstStep = 1.0 / 60;  // s of motion that a key's first frame stands for
constexpr double kLongestStep = 0.1;     // s: a hitch is no leap
constexpr double kMessageTime = 6.0;     // s
constexpr double kPatience = 0.12;       // s that a turn waits for its picture before it shows the last one again
constexpr double kRestBeforeTimes = 0.5; // s without a change before effects are measured
constexpr double kAdaptation = 0.4;      // s in which exposure goes all but 1/e of its way
constexpr double kAdapted = 2.5;         // s after the last change until it is there
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
    viewer->info_ = gl::info();
    viewer->painter_ = std::make_unique<Painter>(*viewer->window_, !options.one_context, [] { glfwPostEmptyEvent(); });
    viewer->accuracy_ = std::make_unique<FrameAccuracy>();
    auto measured = load_frontier(assets_directory() / "frontier.csv");
    if (measured)
        viewer->measured_ = std::move(*measured);
    else
        viewer->not_measured_ = measured.error().message;
    if (Status started = viewer->start(); !started) return started.error();
    return viewer;
}

Viewer::~Viewer() {
    if (turns_ != nullptr) std::fclose(turns_);
}

// The first picture, without which there is nothing to keep on the screen.
Status Viewer::start() {
    if (!options_.turns.empty() && (turns_ = std::fopen(options_.turns.c_str(), "w")) == nullptr)
        return failed(fmt::format("{}: cannot be written", options_.turns));
    fit_to_window();
    shown_ = view_.scene;
    shown_loaded_ = view_.loaded;
    ask();
    painter_->wait(std::numeric_limits<double>::infinity());
    auto painting = painter_->take();
    if (!painting->ready) return painting->ready.error();
    adopt(std::move(*painting));
    return Done{};
}

Status Viewer::run() {
    while (!window_->closing()) {
        if (!step() || options_.after_frames == 0 || ++frames_ < options_.after_frames) continue;
        if (options_.screenshot.empty()) break;
        return save_png(options_.screenshot, drawn_apart(size_, [this](unsigned framebuffer) {
                            draw(framebuffer);
                            ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
                        }));
    }
    return Done{};
}

bool Viewer::step() {
    const double wait = wait_time();
    waited_ = wait > 0.0;
    const Input& input = window_->poll(wait);
    const double begun = seconds();
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
    if (view_.show_errors && !picture_.job.scene.beside) accuracy_->draw_overlay();
    const AccuracyPanel accuracy{measured_, not_measured_, choice_, accuracy_->facts(), picture_ms_shown_};
    const EffectsPanel effects{effect_times_, picture_.job.scene, painter_->in_background(), picture_.programs, picture_.compile_ms};
    if (view_.show_probe) probe_.draw(ImGui::GetIO().DisplaySize.y - (view_.show_panels ? 2.0f * ImGui::GetFontSize() : 0.0f));
    changed = draw_panels(view_, facts(), accuracy, effects, message_, escape) || changed;
    moving_ = controls_.apply(input, view_, dt, io.WantCaptureMouse, io.WantCaptureKeyboard);
    moving_ = view_.fall.step(view_.scene, dt) || moving_;
    moving_ = step_clock(view_, dt) || moving_;
    if (controls_.dragging()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (input.moved || input.happened || changed || moving_) probe(input);
    if (changed || moving_) {
        adapting_until_ = seconds() + kAdapted;
        fit_to_window();  // a scene that was just loaded has a size of its own
        picture_due_ = true;
        frames_due_ = kSettlingFrames;
    } else if (seconds() < adapting_until_ && drawn_scene(view_).picture.auto_exposure && options_.after_frames == 0) {
        picture_due_ = true;
    }
    const bool whole = !picture_.job.scene.beside;   // errors are a single spacetime's
    const bool watched = whole && (view_.show_errors || (view_.show_panels && view_.show_accuracy));
    if (accuracy_->update(watched, moving_ || changed || picture_due_)) frames_due_ = std::max(frames_due_, kNewsFrames);
    measure_effects(!moving_ && !changed);
    const bool patient = options_.after_frames > 0;   // every frame of a screenshot's run is of the scene as it is
    ask();
    if (take(patient ? std::numeric_limits<double>::infinity() : kPatience)) frames_due_ = std::max(frames_due_, kNewsFrames);
    if (input.moved && (panels_had_pointer || io.WantCaptureMouse)) frames_due_ = kSettlingFrames;  // tooltips
    if (io.WantTextInput || options_.after_frames > 0) frames_due_ = std::max(frames_due_, 1);
    if (frames_due_ == 0) {
        ImGui::EndFrame();
        return false;
    }
    --frames_due_;
    present();
    log_turn(begun);
    return true;
}

// Under the panels' pointer it stays what it was.
void Viewer::probe(const Input& input) {
    if (!view_.show_probe) return probe_.forget();
    if (ImGui::GetIO().WantCaptureMouse) return;
    probe_.look(picture_.job.scene, input.x, input.y);
    frames_due_ = kSettlingFrames;
}

// Screenshots' runs do not depend on time.
double Viewer::adaptation(const Scene& scene) {
    const double now = seconds(), since = std::min(now - adapted_at_, kLongestStep);
    adapted_at_ = now;
    return options_.after_frames > 0 || !scene.picture.auto_exposure ? 1.0 : 1.0 - std::exp(-since / kAdaptation);
}

void Viewer::log_turn(double begun) {
    if (turns_ == nullptr) return;
    fmt::print(turns_, "{:.4f} {:.1f} {} {}\n", begun, 1e3 * (seconds() - begun), picture_.programs, painter_->busy() ? 1 : 0);
    std::fflush(turns_);
}

double Viewer::wait_time() const {
    if (size_.width == 0 || size_.height == 0) return kIdleWait;
    if (frames_due_ > 0 || controls_.in_motion() || view_.fall.runs() || view_.clock_runs || options_.after_frames > 0) return 0.0;
    if (ImGui::GetCurrentContext() != nullptr && ImGui::GetIO().WantTextInput) return kCaretWait;
    if (painter_->busy() && picture_due_) return kBusyWait;
    if (seconds() < adapting_until_ && picture_.job.scene.picture.auto_exposure) return kBusyWait;
    double idle = std::min(kIdleWait, accuracy_->wait());
    if (view_.show_effects && !times_asked_) idle = std::min(idle, std::max(changed_at_ + kRestBeforeTimes - seconds(), 0.01));
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
        else if (key == GLFW_KEY_P)
            view_.show_probe = !view_.show_probe;
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

void Viewer::ask() {
    if (painter_->busy()) return;
    if (picture_due_) {
        picture_due_ = false;
        asked_ = view_;
        const Scene scene = drawn_scene(view_);
        asked_choice_ = method_choice(measured_, view_.method, scene);
        painter_->ask({scene, asked_choice_.method, false, adaptation(scene)});
    } else if (accuracy_->asks_for_rays()) {
        painter_->ask({picture_.job.scene, picture_.job.method, true});
    }
}

bool Viewer::take(double patience_s) {
    if (!painter_->busy() || !painter_->wait(patience_s)) return false;
    auto painting = painter_->take();
    if (painting->rays)
        accuracy_->take_rays(painting->job.scene, std::move(*painting->rays));
    else if (painting->ready)
        adopt(std::move(*painting));
    else
        refuse(*painting);
    return true;
}

void Viewer::adopt(Painting painting) {
    if (asked_.scene.name != shown_.name) window_->set_title(title_of(asked_.scene));
    if (painting.job.method != picture_.job.method || effects_of(painting.job.scene) != effects_of(picture_.job.scene) ||
        painting.job.scene.camera.width != picture_.job.scene.camera.width) {
        effect_times_ = {};
        times_asked_ = false;
        changed_at_ = seconds();
    }
    picture_ = std::move(painting);
    if (!picture_.notes.empty()) say(picture_.notes.back());
    choice_ = asked_choice_;
    accuracy_->frame_is(picture_.job.scene, picture_.job.method);
    view_.error.clear();
    shown_ = asked_.scene;
    shown_loaded_ = asked_.loaded;
    shown_method_ = asked_.method;
    shown_off_ = asked_.off;
}

// What was shown is shown on, unless the hands have gone on meanwhile.
void Viewer::refuse(const Painting& painting) {
    if (painting.job.rays || picture_due_) return;
    const CameraSpec camera = view_.scene.camera;
    view_.scene = shown_;
    view_.scene.camera.width = camera.width, view_.scene.camera.height = camera.height;
    view_.loaded = shown_loaded_;
    view_.method = shown_method_;
    view_.off = shown_off_;
    view_.error = painting.ready.error().message;
    frames_due_ = kSettlingFrames;
}

// Once for every set of effects, when the picture rests and somebody looks.
void Viewer::measure_effects(bool still) {
    if (auto times = painter_->take_times()) {
        effect_times_ = std::move(*times);
        frames_due_ = std::max(frames_due_, kNewsFrames);
    }
    const bool wanted = view_.show_panels && view_.show_effects;
    if (!wanted || times_asked_ || !still || picture_due_ || painter_->busy() || seconds() - changed_at_ < kRestBeforeTimes) return;
    times_asked_ = true;
    painter_->measure(picture_.job.scene, picture_.job.method);
}

void Viewer::draw(unsigned framebuffer) {
    const CameraSpec& camera = picture_.job.scene.camera;
    gl::blit(picture_.texture, camera.width, camera.height, framebuffer, size_.width, size_.height);
}

void Viewer::present() {
    ImGui::Render();
    draw(0);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    gl::finish();  // the picture's texture may be drawn to again
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
    picture_ms_shown_ = picture_.draw_ms;
    fps_shown_ = frames_due_ > 0 && moving_ && frame_s_ > 0.0 ? 1.0 / frame_s_ : 0.0;
}

void Viewer::save_picture() {
    const auto path = fresh_screenshot_path();
    const Status saved = save_png(path, drawn_apart(size_, [this](unsigned framebuffer) { draw(framebuffer); }));
    say(saved ? fmt::format("Saved {}", path.string()) : saved.error().message);
}

void Viewer::say(const std::string& message) {
    message_ = message;
    message_until_ = seconds() + kMessageTime;
}

FrameFacts Viewer::facts() const {
    const std::string version = info_.version.substr(0, info_.version.find(' '));
    const bool last = frames_due_ <= 1;  // what this frame shows stays
    return {picture_ms_shown_, last ? 0.0 : fps_shown_, picture_.table_ms, picture_.rows_ms, size_, info_.renderer, version, painter_->busy()};
}

}  // namespace nullscope::viewer
