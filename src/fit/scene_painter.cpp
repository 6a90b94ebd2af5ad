#include "fit/scene_painter.h"

#include <utility>

#include "command/shot.h"
#include "scene/picture_size.h"
#include "scene/stereo.h"

namespace nullscope::fit {

ScenePainter::ScenePainter(SceneFamily family, cli::Session session)
    : family_(std::move(family)), session_(std::move(session)) {
    drawing_.listener.progress = [](const std::string&, long long) { return Advance([](long long) {}); };
}

Result<std::shared_ptr<ScenePainter>> ScenePainter::open(SceneFamily family, const ContextChoice& context) {
    TRY(scene, family.somewhere());
    if (scene->split || scene->camera.stereo != Stereo::kOff)
        return bad_input("a fit is to one picture", "no [split] and no camera.stereo");
    if (scene->path) return bad_input("the camera of a fit stands still", "no [path]");
    TRY(session, cli::open_session(context));
    TRY(method, cli::chosen_method("auto", {}, *scene, cli::Listener()));
    session->renderer->set_method(*method);
    return std::shared_ptr<ScenePainter>(new ScenePainter(std::move(family), std::move(*session)));
}

Result<ScenePainter::Painted> ScenePainter::paint(const std::vector<double>& values, const PaintedSize& size,
                                                  std::optional<double> time) {
    TRY(scene, family_.at(values));
    set_size(*scene, size.width, size.height);
    scene->picture.samples = size.samples;
    if (time) scene->time = *time;
    TRY(captured, cli::capture_picture(&session_, *scene, drawing_));
    return Painted{std::move(*scene), std::move(*captured)};
}

}  // namespace nullscope::fit
