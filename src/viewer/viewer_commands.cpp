// What keys and menus do.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "scene/bodies.h"
#include "scenefile/scene_edit.h"
#include "scenefile/scene_writer.h"
#include "studio/comparison.h"
#include "viewer/panel_rows.h"
#include "viewer/picking.h"
#include "viewer/sections.h"
#include "viewer/viewer.h"

namespace nullscope::viewer {
namespace {

constexpr double kTextStep = 0.25;
constexpr double kQuitWithin_s = 6.0;  // of an Escape that had nothing to close: as long as it says so

// Commands that mean nothing to a field of text.
bool works_while_typing(Command command) {
    return command == Command::kLargerText || command == Command::kSmallerText || command == Command::kFullScreen ||
           command == Command::kSave || command == Command::kSavePicture || command == Command::kGallery;
}

std::string clipboard() {
    const char* text = ImGui::GetClipboardText();
    return text != nullptr ? text : "";
}

}  // namespace

bool Viewer::handle_keys(const Input& input) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool in_picture = (input.left.pressed || input.middle.pressed || input.right.pressed) && !io.WantCaptureMouse;
    if (!gallery_.is_open() && shown_.is_there() && (in_picture || !input.pressed.empty()))
        settings_.now.hints_seen = true;
    bool changed = false;
    if (in_picture) panel_system_->navigate(false);
    for (const KeyPress& press : input.pressed) {
        if (press.key == GLFW_KEY_ESCAPE && panel_system_->navigates()) {
            if (!panel_system_->had_control()) panel_system_->navigate(false);
            continue;
        }
        const auto command = action_of(press);
        const bool pastes = command == Command::kPasteView && gallery_.is_open() && is_view(clipboard());
        if (io.WantCaptureKeyboard && !pastes && (!command || !works_while_typing(command->command))) continue;
        if (press.key == GLFW_KEY_ESCAPE && !press.control) close_topmost();
        if (command) changed |= perform(*command);
    }
    return changed;
}

// What is open closes, one thing at a time; when nothing is, a second Escape quits. Lists and the gallery see to themselves.
void Viewer::close_topmost() {
    if (gallery_.is_open() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return;
    if (close_topmost_panel(view_)) return;
    if (panels_.tour.is_open()) return panels_.tour.close();
    if (seconds() - std::exchange(escaped_at_, seconds()) < kQuitWithin_s) return window_->close();
    say("Escape once more, or Ctrl + Q, quits");
}

bool Viewer::perform(const Action& action) {
    const auto toggle = [](bool& shown) { return shown = !shown, false; };
    const auto scale_text = [&](double by) {
        settings_.now.text_scale = std::clamp(settings_.now.text_scale + by, kLeastTextScale, kMostTextScale);
        pace_.want(kSettlingFrames);
        return false;
    };
    const bool ends = (action.overlay != nullptr && shows(view_, *action.overlay)) ||
                      (action.panel != nullptr && is_open(view_, *action.panel));
    if (const std::string reason = why_not(action, view_); !reason.empty() && !ends) return say(reason), false;
    history_.rest(view_);  // what was flown until now
    switch (action.command) {
        case Command::kGallery: return gallery_.open(view_.shipped, panels_.all_tours()), false;
        case Command::kSave: return save_scene(), false;
        case Command::kSaveAs: return files_.save_as.ask(usual_path()), false;
        case Command::kSavePicture: return save_picture(), false;
        case Command::kReload: return open_file(view_.source);
        case Command::kQuit: return window_->close(), false;
        case Command::kUndo: return step_history(true);
        case Command::kRedo: return step_history(false);
        case Command::kCopyView: return copy_view(), false;
        case Command::kPasteView: return paste();
        case Command::kResetCamera: return reset_camera(view_), true;
        case Command::kAddPlanet: return add("ball");
        case Command::kAddShell: return add("sphere");
        case Command::kAddRing: return add("cylinder");
        case Command::kAddSurface: return add("surface");
        case Command::kAddDisc: return add("disc");
        case Command::kAddSpot: return add("spot");
        case Command::kAddSplit: return add("split");
        case Command::kFall: return fall_freely(), true;
        case Command::kPlay: return flight_.timeline.play(!flight_.timeline.plays()), false;
        case Command::kRecord: return record(), true;
        case Command::kErrors: return toggle(view_.show_errors);
        case Command::kPotential: return toggle_potential(), false;
        case Command::kFullScreen: return window_->toggle_full_screen(), false;
        case Command::kLargerText: return scale_text(kTextStep);
        case Command::kSmallerText: return scale_text(-kTextStep);
        case Command::kBookmark: return due_.bookmark = true, false;
        case Command::kLightTheme: return toggle(view_.light_theme);
        case Command::kOrders: return toggle(view_.show_orders);
        case Command::kCompare: return compare();
        case Command::kSwapSides: return history_.rest(view_), swap_sides(view_), history_.rest(view_), true;
        case Command::kNavigate: return navigate(), false;
        case Command::kTourNext: return step_tour(1);
        case Command::kTourBack: return step_tour(-1);
        case Command::kPanel: return set_open(view_, *action.panel, !ends), false;
        case Command::kOverlay: return viewer::toggle(view_, *action.overlay), false;
    }
    return false;
}

bool Viewer::step_history(bool back) {
    std::string what;
    const std::string source = view_.source;
    const bool done = back ? history_.undo(view_, what) : history_.redo(view_, what);
    if (view_.source != source) view_.side_b.reset();
    say(!done ? (back ? "Nothing to undo" : "Nothing to redo")
              : fmt::format("{}: {}", back ? "Undone" : "Redone", what));
    return done;
}

bool Viewer::compare() {
    view_.sides = 2 * (view_.sides / 2 + 1);
    if (view_.side_b != nullptr) return view_.side_b.reset(), true;
    if (view_.scene.split) return say("A split screen has two sides already"), false;
    view_.side_b = std::make_shared<SideB>(SideB{view_.scene, view_.method, view_.off});
    say("Side B keeps these settings; changes apply to side A. X ends it");
    return true;
}

void Viewer::navigate() {
    set_open(view_, kSidePanel, true);
    panel_system_->navigate(true);
    pace_.want(kSettlingFrames);
    say("Arrow keys and Enter work in the panels; Escape returns to the picture");
}

void Viewer::copy_view() {
    const std::string line = copied_view(view_);
    if (line.empty()) return say("Not copied: the scene is too large for a line");
    ImGui::SetClipboardText(line.c_str());
    say(is_scene_line(line)
            ? "Scene copied as one line of text, for Ctrl + V here or in another window"
            : "Camera copied as one line of text, for Ctrl + V here, in another window or in a scene file");
}

// As a file that is opened: what was shown before can be opened again, and saving asks for a name.
bool Viewer::paste_scene(const std::string& line) {
    const auto scene = scene_of_line(line);
    const Status kept = scene ? keep_pasted(*scene) : Status(scene.error());
    if (!kept) return say("Clipboard: " + kept.error().message()), false;
    if (!open_file(last_pasted().string())) return false;
    gallery_.close();
    say("Scene pasted");
    return true;
}

// In the gallery no scene is chosen yet: the view's own opens if it ships.
bool Viewer::paste() {
    const std::string line = clipboard(), of = scene_of_view(line);
    if (is_scene_line(line)) return paste_scene(line);
    const auto own = std::ranges::find(view_.shipped, of, &SceneInfo::title);
    const bool opens = gallery_.is_open() && own != view_.shipped.end() && of != view_.scene.name;
    if (opens && !open_file(own->name)) return false;
    const Status pasted = paste_view(view_, line);
    if (!pasted) return say("Clipboard: " + pasted.error().message()), opens;
    gallery_.close();
    say(of.empty() || of == view_.scene.name
            ? "View pasted"
            : fmt::format("View pasted: the camera alone. It is of the scene {}, this one is {}", of,
                          view_.scene.name));
    return true;
}

bool Viewer::add(const std::string& section) {
    auto added = with_addition(view_.scene, section, SceneEditor::free_part(menu_height(), panels_.strips_top));
    if (!added) return say(added.error().message()), false;
    view_.scene = std::move(*added);
    if (view_.scene.disc) view_.hidden_disc = *view_.scene.disc;
    const std::string label = last_label(view_.scene, section);
    set_open(view_, kEditorPanel, true);
    panels_.editor.reveal(label);
    say(fmt::format("Added {}: its numbers and colours are in the scene editor; Ctrl + Z takes it back", label));
    return true;
}

// What is on the screen is asked, and looked for in the scene as it is now.
void Viewer::pick(double x, double y) {
    const Scene& drawn =
        shown_.side_b() != nullptr && x >= cover_.divider.x() ? shown_.side_b()->scene : shown_.scene();
    const auto hit = shown_.is_there() ? body_at(drawn, x, y) : std::nullopt;
    if (!hit) return;
    const auto found = std::ranges::find(view_.scene.bodies, drawn.bodies[*hit]);
    if (found == view_.scene.bodies.end()) return;
    const auto number = static_cast<std::size_t>(found - view_.scene.bodies.begin());
    set_open(view_, kEditorPanel, true);
    panels_.editor.reveal(body_section(view_.scene, number));
    pace_.want(kSettlingFrames);
}

void Viewer::toggle_potential() {
    view_.show_potential = !view_.show_potential;
    const auto spacetime = spacetime_of(view_.scene);
    if (!view_.show_potential || spacetime == nullptr) return;
    if (spacetime->rotates())
        say("No effective potential about a rotating hole: rays do not stay in a plane");
    else if (!is_open(view_, kProbePanel))
        say("Effective potential: shown with the ray of a pixel (P)");
}

void Viewer::fall_freely() {
    Fall& fall = view_.fall;
    if (fall.active() && fall.tau() < fall.line().last()) return fall.run(!fall.runs());
    if (const Status gone = release(view_); !gone) return say(gone.error().message());
    say("Falling freely: F pauses, R returns to the scene's camera");
}

void Viewer::record() {
    if (!flight_.timeline.records()) {
        flight_.record(view_.scene, seconds());
        return say("Recording: fly, turn, fall; F9 ends it");
    }
    const bool had_path = view_.scene.path.has_value();
    if (!flight_.timeline.stop_record(view_.scene)) return say("Nothing was recorded: too short");
    view_.fall.stop();
    say(had_path ? "Recorded. The path before was put aside: Ctrl + Z brings it back"
                 : "Recorded: a path of the scene now. Play it (L), draw a film of it, save it (Ctrl + S)");
}

void Viewer::leave_scene() {
    history_.rest(view_);
    if (flight_.timeline.records() && flight_.timeline.stop_record(view_.scene)) history_.rest(view_);
    Scene loaded = view_.loaded;
    set_size(loaded, view_.scene.camera.width, view_.scene.camera.height);
    if (!view_.scene.path || view_.scene.path == loaded.path) return;
    const Status kept = keep_recording(flight_.timeline.to_save(view_.scene));
    say(kept ? "The recording was put aside: Ctrl + Z or Last recording in the gallery brings it back"
             : "The recording was put aside: Ctrl + Z brings it back. " + kept.error().message());
}

}  // namespace nullscope::viewer
