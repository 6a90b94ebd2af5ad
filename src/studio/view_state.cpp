#include "studio/view_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/text.h"
#include "observer/observer.h"
#include "scene/bodies.h"
#include "scene/projection.h"
#include "scenefile/scene_edit.h"
#include "scenefile/scene_keys.h"
#include "scenefile/scene_text.h"
#include "scenefile/scene_writer.h"
#include "spacetime/registry.h"
#include "studio/autosave.h"
#include "studio/fly_camera.h"

namespace nullscope::viewer {

Status load_into(ViewState& view, const std::string& file_or_name) {
    view.note.clear();
    auto loaded = load_scene(file_or_name, [&](const std::string& line) { view.note = line; });
    if (!loaded) {
        view.error = loaded.error().message();
        return loaded.error();
    }
    view.source = file_or_name;
    if (std::ranges::find(view.shipped, file_or_name, &SceneInfo::name) == view.shipped.end()) {
        view.source = std::filesystem::absolute(file_or_name).string();
        const std::filesystem::path path(view.source);
        if (path != last_session() && path != last_recording() && path != last_pasted()) own_file(view, view.source);
    }
    view.loaded = view.scene = std::move(*loaded);
    if (view.scene.disc) view.hidden_disc = *view.scene.disc;
    if (const double speed = length(view.scene.camera.velocity); speed > 0.0)
        view.boost_direction = view.scene.camera.velocity / speed;
    view.off = {};
    view.hidden.clear();
    ++view.jumps;
    view.side_b.reset();
    view.clock_runs = false;
    view.fall.stop();
    view.error.clear();
    return Done{};
}

void own_file(ViewState& view, const std::string& path) {
    std::erase(view.own, path);
    view.own.insert(view.own.begin(), path);
}

namespace {

// Light that travels straight would shine through the hole: a black sphere stands where its horizon is.
void keep_hole_black(Scene& scene) {
    constexpr double kOutside = 1.0 + 1e-3;  // of the horizon: bodies are
    const auto spacetime = spacetime_of(scene);
    if (scene.light.lensing || spacetime == nullptr || spacetime->rotates()) return;
    const double radius = spacetime->horizon_radius().value_or(0.0) * kOutside;
    if (radius == 0.0 || scene.camera.r <= radius || scene.bodies.size() == kMostBodies) return;
    add_body(scene, SphereSpec{.radius = radius}).material.colour = {0, 0, 0};
}

const std::string kOfScene = " # of the scene ";  // behind a view that is copied

}  // namespace

Scene drawn_scene(const ViewState& view) {
    Scene scene = view.scene;
    view.hidden.leave_out(scene);
    if (view.show_grid) {  // every 15 degrees; on the disc's radius 12 lines
        scene.sky.kind = SkyKind::kGrid;
        scene.sky.material = SkySpec{}.material;
        if (scene.disc) scene.disc->material = Material{.texture = TextureKind::kGrid};
    }
    for (const Effect effect : view.off.list())
        if (auto less = without_effect(scene, effect)) scene = std::move(*less);
    keep_hole_black(scene);
    return scene;
}

bool is_as_shipped(const ViewState& view) {
    const auto own = std::ranges::find(view.shipped, view.scene.name, &SceneInfo::title);
    auto shipped = own != view.shipped.end() ? load_scene(own->path.string()) : bad_input("not one that ships");
    if (!shipped) return false;
    shipped->camera = view.scene.camera;
    set_size(*shipped, shipped->camera.width, shipped->camera.height);
    return scene_lines(*shipped) == scene_lines(view.scene);
}

std::string copied_view(const ViewState& view) {
    if (is_as_shipped(view)) return view_line(view.scene.camera) + kOfScene + without_controls(view.scene.name);
    Scene scene = view.scene;
    set_size(scene, CameraSpec{}.width, CameraSpec{}.height);
    return scene_line(scene);
}

bool is_view(const std::string& text) { return text.starts_with("camera = {") || is_scene_line(text); }

std::string scene_of_view(const std::string& line) {
    const std::size_t at = line.find(kOfScene);
    if (at == std::string::npos) return "";
    const std::size_t name = at + kOfScene.size();
    return line.substr(name, line.find_first_of("\r\n", name) - name);
}

Status paste_view(ViewState& view, const std::string& line) {
    TRY(camera, camera_of_view(line, view.scene));
    view.scene.camera = *camera;
    ++view.jumps;
    view.fall.stop();
    return Done{};
}

Status load_step(ViewState& view, const TourStep& step) {
    const std::vector<std::string> own = view.own;
    if (Status loaded = load_into(view, step.scene); !loaded) return loaded;
    view.own = own;  // a tour's scenes are none
    if (step.view) view.scene.camera = view.loaded.camera = *step.view;
    view.off = step.off;
    return Done{};
}

void reset_camera(ViewState& view) {
    const CameraSpec now = std::exchange(view.scene.camera, view.loaded.camera);
    view.scene.camera.width = now.width, view.scene.camera.height = now.height;
    ++view.jumps;
    view.fall.stop();
    keep_outside_horizon(view.scene);
}

std::shared_ptr<const Spacetime> spacetime_of(const Scene& scene) {
    auto made = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    return made ? *made : nullptr;
}

void keep_outside_horizon(Scene& scene) {
    const auto spacetime = spacetime_of(scene);
    if (spacetime == nullptr) return;
    const FlightRange range = flight_range(*spacetime);
    if (!(falls(scene.camera) ? camera_can_be : camera_can_rest)(*spacetime, scene.camera.r))
        scene.camera.r = range.throat > 0.0 ? range.throat : range.nearest;
}

void set_fov(CameraSpec& camera, double fov) {
    const FieldOfView& field = projection_of(camera).field;
    set_exact_fov(camera, std::clamp(fov, field.steered_least, field.steered_most));
}

void set_exact_fov(CameraSpec& camera, double fov) {
    const ProjectionRow& row = projection_of(camera);
    if (row.faces) return;
    if (!row.flat) {
        const bool too_wide = row.field.below && fov >= row.field.most;
        camera.plane_width = too_wide ? row.field.steered_most : std::clamp(fov, row.field.least, row.field.most);
        return;
    }
    const KeyRange widths = key_range("camera.plane_width");
    const double width = fov < row.field.most ? camera.focal_distance * row.width(fov) : widths.high;
    camera.plane_width = std::clamp(width, widths.low, widths.high);
}

}  // namespace nullscope::viewer
