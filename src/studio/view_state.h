// What the viewer shows, and what the user has changed of it. Panels and keys edit `scene`; the viewer prepares it.
#pragma once
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "plan/effects.h"
#include "scene/picture_size.h"
#include "scene/scene.h"
#include "scenefile/scene_file.h"
#include "scenefile/tour_file.h"
#include "shaderlib/frontier.h"
#include "spacetime/spacetime.h"
#include "studio/fall.h"
#include "studio/hidden_bodies.h"
#include "studio/number_words.h"
#include "studio/paint_job.h"

namespace nullscope::viewer {

// How rays shall be traced.
struct MethodWish {
    bool automatic = true;  // the cheapest that keeps max_error_px
    double max_error_px = kDefaultMaxError_px;
    Method method;  // unless automatic
    friend bool operator==(const MethodWish&, const MethodWish&) = default;
};

// What a comparison keeps: everything but the camera, the path and the time.
struct SideB {
    Scene scene;
    MethodWish method;
    EffectSet off;
};

struct ViewState {
    std::string source;  // what load_scene was given
    std::string wanted;  // what the panel asks to open next, or ""
    Scene loaded;        // as the file has it
    Scene scene;         // as it is now
    std::vector<SceneInfo> shipped;
    std::vector<std::string> own;                      // paths of files that were opened or saved, the last first
    std::string error;                                 // of the last change, or nothing
    std::string note;                                  // of the file that was opened last, or nothing
    bool show_accuracy = false, show_effects = false;  // the section is open
    bool show_numbers = false;                         // likewise
    bool show_errors = false;                          // over the picture
    bool show_grid = false;                            // of coordinates, on sky and disc
    bool show_potential = false;                       // of the probe's ray
    bool show_orders = false;                          // image orders in colours
    std::set<std::string, std::less<>> panels{};       // that are open, by their names
    std::set<std::string, std::less<>> overlays{};     // that are on, likewise
    bool light_theme = false;                          // of the panels
    NumberStyle numbers;                               // how Numbers, probe and clocks are written
    std::shared_ptr<const SideB> side_b;               // right of the divider; nullptr: no comparison
    int sides = 0;  // twice the number of comparisons until now, 1 more while sides are swapped
    MethodWish method;
    StageWish stage = StageWish::kAuto;
    Fall fall;                       // of the camera, once it was let go
    bool clock_runs = false;         // the scene's own
    double clock_rate = 5.0;         // r_s/c a second
    EffectSet off;                   // of the scene's effects, switched off by hand
    Vec3 boost_direction{-1, 0, 0};  // kept while the camera is at rest
    DiscSpec hidden_disc;            // kept while the disc is switched off
    HiddenBodies hidden;
    int jumps = 0;  // how often a command put the camera elsewhere: undo does not join what lies on both sides of it
};

// Replaces what is shown; on an error everything stays and view.error says why.
Status load_into(ViewState& view, const std::string& file_or_name);
// This file was opened or saved: the first of view.own.
void own_file(ViewState& view, const std::string& path);
// What is drawn: the scene without what is hidden or switched off. A hole without lensing is a black sphere as large as its horizon.
Scene drawn_scene(const ViewState& view);

// The scene is one that ships, but for its camera. Reads the file: a millisecond.
bool is_as_shipped(const ViewState& view);
// One line. Of a scene that ships view_line() of the camera, and the scene's name as a comment; of any other scene_line().
std::string copied_view(const ViewState& view);
bool is_view(const std::string& text);               // it begins as such a line does
std::string scene_of_view(const std::string& line);  // the name, or ""
// Of a camera's line: the camera that it says, in the scene's spacetime. Errors: as a scene file's.
Status paste_view(ViewState& view, const std::string& line);
// What a step of a tour shows, its camera as if the file had it (R returns to it). Errors: as load_into's.
Status load_step(ViewState& view, const TourStep& step);

void reset_camera(ViewState& view);  // to the file's, pixels apart

// The scene's spacetime; nullptr while the metric or its parameters are not valid. Cheap.
std::shared_ptr<const Spacetime> spacetime_of(const Scene& scene);

// For cameras that came with another spacetime: at least the flight range's nearest radius.
void keep_outside_horizon(Scene& scene);

void set_fov(CameraSpec& camera, double fov);        // clamped to what can be steered: of a pinhole 1 to 170 degrees
void set_exact_fov(CameraSpec& camera, double fov);  // to what a scene file may say

}  // namespace nullscope::viewer
