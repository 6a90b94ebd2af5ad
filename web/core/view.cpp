// The picture, by the renderer that window and files have. Needs the page's WebGL2 context.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "core/exports.h"
#include "core/session.h"
#include "gl/gl.h"
#include "render/renderer.h"

namespace nullscope::web {
namespace {

std::unique_ptr<Renderer> renderer;
RayFrame rays;

bool prepare(int width, int height) {
    session().scene.camera.width = width, session().scene.camera.height = height;
    Scene scene = session().scene;
    scene.path.reset();
    const Status prepared = renderer->prepare(scene);
    return prepared ? true : answer(prepared.error());
}

}  // namespace

// For a new context, also after one was lost. floats: it draws to textures of floats; without that nothing is drawn in tiles.
NULLSCOPE_EXPORT(start_view) void start_view(bool floats) {
    gl::prepare_context();
    renderer = std::make_unique<Renderer>();
    if (!floats) renderer->limit_tiles(Tiles::kNone);
    renderer->keep_finer_sky();
    renderer->follow_camera();
}

// Draws to the canvas, adaptation: of automatic exposure (Renderer::set_adaptation). false: the answer says why not; files that are missing
// are named by missed_files().
NULLSCOPE_EXPORT(draw) bool draw(int width, int height, double adaptation) {
    if (!prepare(width, height)) return false;
    renderer->set_adaptation(adaptation);
    renderer->draw(0, width, height, Output::kDisplay);
    gl::check("picture");
    return answer(std::string());
}
// Compiles one program of those that make the next picture faster; whether one was left.
NULLSCOPE_EXPORT(build_next) bool build_next() { return renderer->build_next(); }

// Ray data of the picture: [width, height, place of the pixels, bytes of all] as the answer. Every row_step-th row.
NULLSCOPE_EXPORT(trace_rays) bool trace_rays(int width, int height, int row_step) {
    if (!prepare(width, height)) return false;
    rays = renderer->ray_data(row_step);
    return answer(fmt::format("[{}, {}, {}, {}]", rays.width, rays.height,
                              reinterpret_cast<std::size_t>(rays.pixels.data()),
                              rays.pixels.size() * sizeof(RayPixel)));
}

// What was done to images, for people: ["...", ...], since the last call.
NULLSCOPE_EXPORT(notes) bool notes() {
    std::vector<std::string> list;
    for (const std::string& note : renderer->take_notes()) list.push_back(in_json(note));
    return answer(fmt::format("[{}]", fmt::join(list, ", ")));
}

}  // namespace nullscope::web
