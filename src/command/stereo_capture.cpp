#include "command/stereo_capture.h"

#include <fmt/format.h>

#include <utility>

#include "observer/eye.h"
#include "scene/stereo.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

Result<Scene> scene_of_eye(const Scene& scene, const Spacetime& spacetime, const EyePart& part) {
    TRY(eye, eye_beside(spacetime, part.camera, part.offset));
    Scene seen = scene;
    seen.camera = eye->camera;
    seen.time += eye->later;
    return seen;
}

// What the eye of part i sees.
Result<Exposure> seen_by_eye(const Exposure& shown, const Spacetime& spacetime, std::size_t i) {
    return tried(shown, [&](const Scene& scene) { return scene_of_eye(scene, spacetime, eye_parts(scene.camera)[i]); });
}

template <class T>
void paste(const Image<T>& from, const EyePart& part, Image<T>& to) {
    if (from.empty() || to.empty()) return;
    copy_part(from, part.skip, 0, part.columns, from.height, to, part.left, part.top);
}

// Tables of the strips, whose radii differ little, are made from each other's: not from those of a picture before, so that a frame does
// not depend on which frames were drawn.
Status begin_strips(Renderer& renderer, const Scene& scene, const EyePart& first) {
    Scene middle = scene;
    middle.camera = first.camera;
    renderer.follow_camera(false);
    Status ready = renderer.prepare(middle);
    renderer.follow_camera();
    return ready;
}

}  // namespace

Status check_stereo(const Scene& scene, const DrawOptions& options, bool split) {
    if (scene.camera.stereo == Stereo::kOff) return Done{};
    for (const auto& [option, given] : {std::pair{"--split", split},
                                        {"--raydata", options.raydata},
                                        {"--layers", options.layers},
                                        {"--st-map", !options.st_map.empty()}})
        if (given)
            return bad_input(fmt::format("{} is of one picture, and the scene has camera.stereo", option),
                             fmt::format("stereo = \"off\", or no {}", option));
    const auto [width, height] = stereo_size(scene.camera);
    return options.sample == Sample::kLight ? Done{} : check_size8(width, height);
}

Status check_stereo_frames(const CameraPath& path, const Scene& scene, int first, int end) {
    if (scene.camera.stereo == Stereo::kOff) return Done{};
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    for (int frame = first; frame < end; ++frame)
        if (Status there = check_eyes(**spacetime, path.at(frame)); !there) {
            Error error = there.error();
            error.what = fmt::format("frame {}: {}", frame, error.what);
            return error;
        }
    return Done{};
}

Result<std::vector<Exposure>> side_by_side_pictures(const Exposure& shown) {
    const Scene& scene = shown.scene;
    if (scene.camera.stereo != Stereo::kPair) return std::vector{shown};
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    std::vector<Exposure> eyes;
    for (std::size_t i = 0; i < eye_parts(scene.camera).size(); ++i) {
        TRY(seen, seen_by_eye(shown, **spacetime, i));
        eyes.push_back(std::move(*seen));
    }
    return eyes;
}

Result<Captured> capture_stereo(Session* session, const Exposure& shown, const DrawOptions& options) {
    const Scene& scene = shown.scene;
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    TRY(draw, picture_drawer(session, scene, options));
    const auto [width, height] = stereo_size(scene.camera);
    Captured both;
    switch (options.sample) {
        case Sample::kByte: both.bytes = Image<unsigned char>(width, height, 3); break;
        case Sample::kWord: both.words = Image<unsigned short>(width, height, 3); break;
        case Sample::kLight: both.linear = Image<float>(width, height, 3); break;
    }
    const std::vector<EyePart> parts = eye_parts(scene.camera);
    Advance advance = [](long long) {};
    if (scene.camera.stereo == Stereo::kAllRound) {
        advance = options.listener.progress("strips", std::ssize(parts));
        if (session != nullptr) {
            TRY(ready, begin_strips(*session->renderer, scene, parts.front()));
        }
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        TRY(seen, seen_by_eye(shown, **spacetime, i));
        TRY(captured, (*draw)(*seen));
        paste(captured->linear, parts[i], both.linear);
        paste(captured->bytes, parts[i], both.bytes);
        paste(captured->words, parts[i], both.words);
        both.made_by = captured->made_by;
        advance(1);
    }
    return both;
}

}  // namespace nullscope::cli
