#include "command/shot.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "annotate/marks.h"
#include "annotate/streamlines.h"
#include "annotate/ticks.h"
#include "base/assets.h"
#include "command/stereo_capture.h"
#include "plan/dump_window.h"
#include "plan/shutter.h"
#include "render/picture_layers.h"
#include "scene/medium_bands.h"
#include "scene/medium_dumps.h"
#include "scene/split.h"
#include "scenefile/path_values.h"
#include "scenefile/photo_sphere.h"
#include "shaderlib/frontier.h"

namespace nullscope::cli {
namespace {

// Says once why there are no letters.
void annotate(const Scene& scene, const std::optional<Halves>& split, const Listener& listener, Captured& captured) {
    static bool said = false;
    const Marks marks = make_marks(annotations_of(scene, split), captured.width(), captured.height());
    if (!marks.note.empty() && !std::exchange(said, true)) listener.note(marks.note);
    if (!marks.marks.empty()) captured.arrive();
    if (!captured.bytes.empty()) lay_over(marks.marks, captured.bytes);
    if (!captured.words.empty()) lay_over(marks.marks, captured.words);
}

void say_no_bands(const Scene& scene, const Listener& listener) {
    static bool said = false;
    if (has_bands(scene) && !std::exchange(said, true))
        listener.note("medium.frequency: of two pictures side by side no band is written by itself");
}

// Of the light of a smaller picture: streamlines, and ticks over them.
Status show_polarisation(Session* session, const Scene& scene, const Listener& listener, Captured& captured) {
    const PictureSpec& picture = scene.picture;
    if (!(picture.ticks || picture.streamlines) || !is_polarised(scene)) return Done{};
    const int width = captured.width(), height = captured.height();
    if (width == 0) return Done{};
    captured.arrive();
    if (session == nullptr) {
        listener.note("picture.ticks and picture.streamlines are drawn by the shader only");
        return Done{};
    }
    const auto lay = [&](const Scene& smaller, auto marks_of) -> Status {
        TRY(ready, session->renderer->prepare(smaller));
        const std::vector<Mark> marks = marks_of(draw_stokes(*session->renderer), width, height);
        if (!captured.bytes.empty()) lay_over(marks, captured.bytes);
        if (!captured.words.empty()) lay_over(marks, captured.words);
        return Done{};
    };
    if (picture.streamlines) {
        TRY(laid, lay(streamline_scene(scene, width, height), streamline_marks));
    }
    return picture.ticks ? lay(tick_scene(scene, width, height), tick_marks) : Done{};
}

}  // namespace

Scene scene_at(const Shot& shot, double time_step, double frame) {
    Scene now = shot.scene;
    now.time += (frame - shot.time_frame) * time_step;
    if (!shot.path) return now;
    now.camera = shot.path->at(frame);
    set_path_values(now, shot.path->values(frame));
    now.path.reset();  // its camera is where the path has led it
    now.time += shot.path->clock(frame);
    now.camera.width = shot.scene.camera.width, now.camera.height = shot.scene.camera.height;
    return now;
}

Exposure exposure_in(const Shot& shot, double time_step, int frame) {
    const bool varies = shot.path && !shot.scene.path->keyed.empty();
    return exposure_of([&](double at) { return scene_at(shot, time_step, at); }, frame, varies);
}

std::vector<double> times_in(const Shot& shot, double time_step, Frames frames) {
    std::vector<double> times;
    if (!has_dumps(shot.scene) && !(shot.split && has_dumps(*shot.split))) return times;
    for (int frame = frames.first; frame < frames.end; ++frame)
        for (const double time : times_of(exposure_in(shot, time_step, frame))) times.push_back(time);
    return times;
}

namespace {

// A path's camera of a frame: how long light takes depends on its place.
Scene with_camera(Scene scene, const Shot& shot, double time_step, int frame) {
    if (shot.path) scene.camera = scene_at(shot, time_step, frame).camera;
    return scene;
}

}  // namespace

Status check_times(const Shot& shot, double time_step, Frames frames, const std::string& file) {
    for (const Scene* scene : {&shot.scene, shot.split ? &*shot.split : nullptr}) {
        if (scene == nullptr || !has_dumps(*scene)) continue;
        for (int frame = frames.first; frame < frames.end; ++frame)
            for (const Scene timed = with_camera(*scene, shot, time_step, frame);
                 const double time : times_in(shot, time_step, {frame, frame + 1}))
                if (const auto fault = medium_time_fault(timed, time)) {
                    Error error = bad_input(
                        fmt::format("{}time {}", frames.end - frames.first > 1 ? fmt::format("frame {}: ", frame) : "",
                                    fault->what),
                        fault->allowed);
                    error.file = file;
                    return error;
                }
    }
    return Done{};
}

std::optional<FilmSphere> sphere_in(const Shot& shot, double time_step, Frames frames) {
    if (shot.split || shot.scene.split) return {};
    const auto of = [&](int frame) { return film_sphere(scene_at(shot, time_step, frame).camera); };
    const auto sphere = of(frames.first);
    for (int frame = frames.first + 1; sphere && frame < frames.end; ++frame)
        if (of(frame) != sphere) return {};
    return sphere;
}

Result<Method> chosen_method(const std::string& name, std::optional<double> max_error, const Scene& scene,
                             const Listener& listener) {
    if (name != "auto") {
        auto method = parse_method(name);
        // The renderer takes the default for auto.
        if (method && *method == Method{} &&
            light_path_kind(effect_set(required_effects(scene))) == LightPathKind::kMino)
            return bad_input("method strip does not work for a rotating hole",
                             "auto, mino[:ORDER[:STEP]], kerr-schild:STEP");
        return method;
    }
    TRY(measured, load_frontier(assets_directory() / "frontier.csv"));
    TRY(choice, max_error ? choose_method(*measured, scene, *max_error) : default_method(*measured, scene));
    if (max_error || choice->says || choice->error_px > kDefaultMaxError_px) listener.note("method " + choice->reason);
    return choice->method;
}

bool worth_tiles(const Shot& shot, int frames) {
    constexpr double kWorth_px = 2.0e7;  // with a disc some 25 ns a pixel are saved on two cores
    const CameraSpec& camera = shot.scene.camera;
    const PictureSpec& picture = shot.scene.picture;
    const double pictures = picture.shutter > 0.0 ? picture.sub_frames : 1.0;
    const double rays = pictures * camera.width * camera.height * picture.samples * picture.samples;
    return rays * frames >= kWorth_px;
}

Result<Captured> draw_shot(const Shot& shot, Session* session, const Exposure& shown, const DrawOptions& options,
                           bool lettered, const Scene* next) {
    const Scene& scene = shown.scene;
    const auto split_of = [&](const Scene& s) { return shot.split ? halves(s, *shot.split) : halves(s); };
    const std::optional<Halves> split = split_of(scene);
    const auto half = [&](Scene Halves::*side) {
        return changed(shown, [&](const Scene& s) { return *split_of(s).*side; });
    };
    const bool stereo = scene.camera.stereo != Stereo::kOff;
    DrawOptions each = options;
    each.bands = options.bands && !stereo && !split;  // of two pictures there are none
    each.in_flight = options.in_flight && !stereo && !split;
    if (options.bands && !each.bands) say_no_bands(scene, options.listener);
    TRY(captured, stereo ? capture_stereo(session, shown, each)
                         : capture_picture(session, split ? half(&Halves::left) : shown, each, next));
    if (lettered && !stereo) {
        TRY(laid, show_polarisation(session, split ? split->left : scene, options.listener, *captured));
    }
    if (split) {
        TRY(right, capture_picture(session, half(&Halves::right), each));
        if (lettered) {
            TRY(laid, show_polarisation(session, split->right, options.listener, *right));
        }
        captured->linear = side_by_side(captured->linear, right->linear);
        captured->stokes = {};  // of two pictures there are none
        captured->bytes = side_by_side(captured->bytes, right->bytes);
        captured->words = side_by_side(captured->words, right->words);
    }
    if (lettered && options.sample != Sample::kLight) annotate(scene, split, options.listener, *captured);
    return captured;
}

}  // namespace nullscope::cli
