#include "fit/scene_painter.h"

#include <utility>

#include "command/shot.h"
#include "scene/picture_size.h"
#include "scene/stereo.h"

namespace nullscope::fit {

SessionSource own_session(const ContextChoice& context) {
    return [context, kept = std::make_shared<std::optional<cli::Session>>()]() -> Result<cli::Session*> {
        if (!*kept) {
            TRY(session, cli::open_session(context));
            kept->emplace(std::move(*session));
        }
        return &**kept;
    };
}

ScenePainter::ScenePainter(SceneFamily family, SessionSource sessions, const Method& method)
    : family_(std::move(family)), sessions_(std::move(sessions)), method_(method) {
    drawing_.listener.progress = [](const std::string&, long long) { return Advance([](long long) {}); };
}

Result<std::shared_ptr<ScenePainter>> ScenePainter::open(SceneFamily family, SessionSource sessions) {
    TRY(scene, family.somewhere());
    if (scene->split || scene->camera.stereo != Stereo::kOff)
        return bad_input("a fit is to one picture", "no [split] and no camera.stereo");
    if (scene->path) return bad_input("the camera of a fit stands still", "no [path]");
    TRY(method, cli::chosen_method("auto", {}, *scene, cli::Listener()));
    TRY(there, sessions());
    return std::shared_ptr<ScenePainter>(new ScenePainter(std::move(family), std::move(sessions), *method));
}

Result<ScenePainter::Painted> ScenePainter::paint(const std::vector<double>& values, const PaintedSize& size,
                                                  std::optional<double> time) {
    TRY(scene, family_.at(values));
    set_size(*scene, size.width, size.height);
    scene->picture.samples = size.samples;
    if (time) scene->time = *time;
    TRY(session, sessions_());
    (*session)->renderer->set_method(method_);
    (*session)->renderer->limit_tiles(Tiles::kBodies);
    cli::DrawOptions drawing = drawing_;
    drawing.bands = size.bands;
    TRY(captured, cli::capture_picture(*session, *scene, drawing));
    return Painted{std::move(*scene), std::move(*captured)};
}

}  // namespace nullscope::fit
