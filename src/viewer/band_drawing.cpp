#include "viewer/band_drawing.h"

#include "studio/bands.h"
#include "viewer/window.h"

namespace nullscope::viewer {

std::optional<DrawTimes> draw_in_bands(Renderer& renderer, const gl::Target& target, double& ray_ms,
                                       const DrawWatch& watch) {
    using Stage = PaintProgress::Stage;
    const double start = seconds();
    constexpr double kRefined = 3.0;  // rays a pixel that edges make of one, about
    const int samples = renderer.tables().plan().scene.picture.samples;
    const double rays =  // in a row
        target.width * (renderer.tables().effects().contains(Effect::kRefine) ? kRefined : samples * samples);
    BandCutter bands(target.height, ray_ms * rays);
    watch.tell({ray_ms > 0.0 ? Stage::kDrawing : Stage::kCompiling, 0, target.height});
    while (!bands.done()) {
        if (watch.give_up()) return std::nullopt;
        const int programs = renderer.picture_programs();
        const double begun = seconds();
        renderer.draw_rows(target.framebuffer.id(), target.width, target.height, Output::kDisplay, bands.first(),
                           bands.last());
        gl::finish();  // drivers compile until the first rows are there
        bands.took(1e3 * (seconds() - begun), renderer.picture_programs() > programs);
        watch.tell({Stage::kDrawing, bands.first(), target.height});
    }
    if (bands.row_ms() > 0.0) ray_ms = bands.row_ms() / rays;
    return DrawTimes{1e3 * (seconds() - start) - bands.compile_ms(), bands.compile_ms()};
}

}  // namespace nullscope::viewer
