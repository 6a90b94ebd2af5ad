// The picture, by the renderer that window and files have. Needs the page's WebGL2 context.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "annotate/ticks.h"
#include "base/assets.h"
#include "base/stopwatch.h"
#include "core/exports.h"
#include "core/session.h"
#include "gl/gl.h"
#include "platform/filters.h"
#include "render/picture_layers.h"
#include "render/renderer.h"
#include "scene/picture_size.h"
#include "scene/split.h"
#include "shaderlib/frontier.h"
#include "viewer/streamline_layer.h"

namespace nullscope::web {
namespace {

std::unique_ptr<Renderer> renderer, right;  // of a split screen's right half, where there is one
std::optional<Halves> split;                // that is prepared
std::array<gl::Target, 2> drawn;            // of its halves
gl::Target under_lines;                     // of a picture with streamlines
RayFrame rays;

// The picture that is drawn: pass by pass, so that the page has turns between them.
struct Painting {
    Scene scene;
    bool lines;            // streamlines over it
    std::size_t half = 0;  // of a split screen
    std::optional<Renderer::Drawing> drawing{};
};
std::optional<Painting> painting;

bool float_targets = true;

std::unique_ptr<Renderer> make_renderer() {
    auto made = std::make_unique<Renderer>();
    if (!float_targets) made->limit_tiles(Tiles::kNone);
    made->keep_finer_sky();
    return made;
}

Scene shown(int width, int height) {
    set_size(session().scene, width, height);
    Scene scene = session().scene;
    scene.path.reset();
    return scene;
}

Status begin_by(Renderer& by, const Scene& scene) {
    const auto method = method_of(scene);
    if (!method) return method.error();
    by.set_method(*method);
    return by.begin_prepare(scene);
}

// All but the skies.
Status begin_prepare(const Scene& scene) {
    painting.reset();
    split = halves(scene);
    if (!split) right.reset();
    if (Status ready = begin_by(*renderer, split ? split->left : scene); !ready || !split) return ready;
    if (right == nullptr) right = make_renderer();
    return begin_by(*right, split->right);
}

// Whether they are there.
Result<bool> prepare_skies(const std::function<bool()>& goes_on) {
    auto ready = renderer->prepare_skies(goes_on);
    return ready && *ready && split ? right->prepare_skies(goes_on) : ready;
}

Status prepare_by(Renderer& by, const Scene& scene) {
    if (Status begun = begin_by(by, scene); !begun) return begun;
    const auto ready = by.prepare_skies([] { return true; });
    return ready ? Status(Done{}) : Status(ready.error());
}

gl::Target& sized(gl::Target& target, int width, int height) {
    if (target.width != width || target.height != height) target = gl::make_target(width, height, gl::Format::kRgba8);
    return target;
}

Renderer& painter() { return painting->half == 0 ? *renderer : *right; }

Renderer::Drawing begin_drawing() {
    const auto into = [](gl::Target* target, const CameraSpec& camera) {
        const unsigned framebuffer =
            target == nullptr ? 0 : sized(*target, camera.width, camera.height).framebuffer.id();
        return painter().begin_rows(framebuffer, camera.width, camera.height, Output::kDisplay, 0, camera.height);
    };
    if (split) return into(&drawn.at(painting->half), (painting->half == 0 ? split->left : split->right).camera);
    return into(painting->lines ? &under_lines : nullptr, painting->scene.camera);
}

// What follows the last pass of a drawing; whether another begins.
bool end_drawing() {
    painting->drawing.reset();
    if (split) {
        if (++painting->half < drawn.size()) return true;
        // Both at once, so that no half of a picture is shown between turns.
        int x = 0;
        for (const gl::Target& from : drawn) {
            gl::blit(from.colours.front().id(), from.width, from.height, 0, from.width, from.height, x);
            x += from.width;
        }
        return false;
    }
    const CameraSpec& camera = painting->scene.camera;
    if (painting->lines) {
        viewer::lay_streamlines(*renderer, painting->scene, under_lines);
        gl::blit(under_lines.colours.front().id(), camera.width, camera.height, 0, camera.width, camera.height);
    }
    return false;
}

}  // namespace

Result<Method> method_of(const Scene& scene) {
    static const auto measured = load_frontier(assets_directory() / "frontier.csv");
    if (!measured) return measured.error();
    return default_method(*measured, scene).method;
}

// For a new context, also after one was lost. floats: it draws to textures of floats; without that nothing is drawn in tiles. filtered:
// gl::filters_floats.
NULLSCOPE_EXPORT(start_view) void start_view(bool floats, bool filtered) {
    gl::prepare_context();
    gl::filters_floats = filtered;
    float_targets = floats;
    painting.reset();
    renderer = make_renderer();
    right.reset();
    drawn = {};
    under_lines = {};
}

// Begins a picture on the canvas, which paint_skies(), until all is there, and then draw_next() go on with. adaptation: of automatic exposure
// (Renderer::set_adaptation). quick: edges get no more rays than the rest, in programs that compile in a sixth of the time, and there are no
// streamlines. false: the answer says why not; files that are missing are named by missed_files().
NULLSCOPE_EXPORT(begin_picture) bool begin_picture(int width, int height, double adaptation, bool quick) {
    Scene scene = shown(width, height);
    if (quick) scene.picture.refine = false;
    if (const Status ready = begin_prepare(scene); !ready) return answer(ready.error());
    renderer->set_adaptation(adaptation);
    if (split) right->set_adaptation(adaptation);
    const bool lines = !split && !quick && float_targets && viewer::shows_streamlines(scene);
    painting.emplace(Painting{std::move(scene), lines});
    return answer(std::string());
}
// Paints its skies for so long, and a piece at least: [0], all is there; [1], there is more; [2], it has to be begun anew, as something else was
// asked for meanwhile. false: the answer says why not, as of begin_picture().
NULLSCOPE_EXPORT(paint_skies) bool paint_skies(double ms) {
    if (!painting) return answer("[2]");
    const Stopwatch watch;
    const auto ready = prepare_skies([&] { return watch.ms() < ms; });
    if (ready) return answer(*ready ? "[0]" : "[1]");
    painting.reset();
    return answer(Status(ready.error()));
}
// Whether the driver has compiled what it needs; where it does that beside other work, it is worth the wait.
NULLSCOPE_EXPORT(is_compiled) bool is_compiled() {
    return renderer->is_compiled(Output::kDisplay) && (!split || right->is_compiled(Output::kDisplay));
}
// Draws one pass of it: 1, there is more; 0, it was the last; 2, something else was asked for meanwhile, and it has to be begun anew.
NULLSCOPE_EXPORT(draw_next) int draw_next() {
    if (!painting) return 2;
    if (!painting->drawing) painting->drawing = begin_drawing();
    if (painter().draw_next(*painting->drawing) || end_drawing()) return 1;
    painting.reset();
    gl::check("picture");
    return 0;
}
// Ticks over the scene's picture in this size (annotate/ticks.h), px: {"thick", "lines": [x, y, right, up, ...]} as the answer, or null
// where there are none: none are asked for, in split screens, and where light cannot be read back. Draws their light.
NULLSCOPE_EXPORT(ticks) bool ticks(int width, int height) {
    Scene scene = session().scene;
    scene.path.reset();
    if (!scene.picture.ticks || !is_polarised(scene) || scene.split || !float_targets) return answer("null");
    set_size(scene, width, height);
    painting.reset();
    if (const Status ready = prepare_by(*renderer, tick_scene(scene, width, height)); !ready)
        return answer(ready.error());
    std::vector<double> lines;
    for (const Tick& tick : ticks_of(draw_stokes(*renderer), width, height))
        lines.insert(lines.end(), {tick.x, tick.y, tick.right, tick.up});
    return answer(
        fmt::format(R"({{"thick": {:.4g}, "lines": [{:.6g}]}})", tick_thickness(width, height), fmt::join(lines, ",")));
}
// Compiles one program of those that make the next picture faster; whether one was left.
NULLSCOPE_EXPORT(build_next) bool build_next() {
    painting.reset();
    return renderer->build_next() || (right != nullptr && right->build_next());
}

// Ray data of the picture: [width, height, place of the pixels, bytes of all] as the answer. Every row_step-th row.
NULLSCOPE_EXPORT(trace_rays) bool trace_rays(int width, int height, int row_step) {
    const Scene scene = shown(width, height);
    if (scene.split) return answer(bad_input("ray data are of one spacetime", "scenes without [split]"));
    painting.reset();
    split.reset();
    right.reset();
    if (const Status ready = prepare_by(*renderer, scene); !ready) return answer(ready.error());
    rays = renderer->ray_data(row_step);
    return answer(fmt::format("[{}, {}, {}, {}]", rays.width, rays.height,
                              reinterpret_cast<std::size_t>(rays.pixels.data()),
                              rays.pixels.size() * sizeof(RayPixel)));
}

}  // namespace nullscope::web
