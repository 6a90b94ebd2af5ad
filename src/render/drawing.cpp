// How Renderer draws a picture: pass by pass.
#include <algorithm>
#include <utility>

#include "plan/medium.h"
#include "render/renderer.h"

namespace nullscope {
namespace {

constexpr int kRaysAtOnce = 16;  // that every pixel traces in one draw
// Where each goes through matter in spans of some six rounds: llvmpipe ends a shader after 65535 rounds of all its loops, in silence.
constexpr int kRaysAtOnceInMatter = 4;
constexpr double kSpansOfMany = 1024;  // of a ray; of longer ones one at once

}  // namespace

void Renderer::draw(unsigned framebuffer, int width, int height, Output output) {
    draw_rows(framebuffer, width, height, output, 0, height);
}

void Renderer::draw_rows(unsigned framebuffer, int width, int height, Output output, int first, int last) {
    Drawing drawing = begin_rows(framebuffer, width, height, output, first, last);
    while (draw_next(drawing)) {
    }
}

bool Renderer::is_compiled(Output output) {
    std::erase_if(coming_, [this](const auto& begun) {  // for another scene
        return begun.first != program_key(std::get<Stage>(begun.first), std::get<Output>(begun.first));
    });
    std::vector<Pass> list = picture_passes(output);
    std::erase_if(list, [this](const Pass& pass) { return programs_.contains(program_key(pass.stage, pass.output)); });
    for (const Pass& pass : list) {
        if (coming_.contains(program_key(pass.stage, pass.output))) continue;
        is_compiled(pass.stage, pass.output);
        return false;
    }
    return std::ranges::all_of(list, [this](const Pass& pass) { return is_compiled(pass.stage, pass.output); });
}

Renderer::Drawing Renderer::begin_rows(unsigned framebuffer, int width, int height, Output output, int first,
                                       int last) {
    Drawing drawing{picture_passes(output), framebuffer, width, height, first, last};
    const std::vector<Pass>& list = drawing.passes;
    keep_light(list, width, height, output);
    picture_tiles_.resize(list, width, height, tables_.effects());
    lattice_.resize(list, width, height, own_steps());
    bind_inputs();
    if (refines(list) && first == 0) {
        if (layer_ == PictureLayer::kAll) edges_.begin();
        blocks_.upload_pixel(refining_);
    }
    return drawing;
}

bool Renderer::draw_next(Drawing& drawing) {
    const auto& [list, framebuffer, width, height, first, last, next, refined] = drawing;
    const bool keep = linear_.width > 0;
    if (next < list.size()) {
        const bool refines = list[next].stage == Stage::kEdges && refining_;
        if (refines)
            refine_rows(drawing);
        else
            draw_rows_of(list[next], drawing, keep ? linear_.framebuffer.id() : framebuffer);
        if (!refines || ++drawing.refined > kRefined.size()) ++drawing.next;
        return true;
    }
    if (keep && !keeps_light(list) && last == height)
        gl::blit(linear_.colours.front().id(), width, height, framebuffer, width, height);
    return false;
}

// First the edges of these rows, then their pixels with each number of rays.
void Renderer::refine_rows(const Drawing& drawing) {
    gl::bind_texture_2d(kPictureUnit, linear_.colours.front());
    if (drawing.refined == 0) {
        if (layer_ == PictureLayer::kAll)
            edges_.compare(program(Stage::kEdges, Output::kLinear), empty_, drawing.first, drawing.last);
    } else if (const auto& pixels_of = edges_.patches()[drawing.refined - 1]; !pixels_of.empty()) {
        const int rays_along = kRefined[drawing.refined - 1];
        blocks_.upload_samples(rays_along, 0, 1);
        patches_.draw(
            rays_along, pixels_of,
            [&](const gl::VertexList& pixels, const gl::Target& rays) {
                bind_inputs();
                for (const Pass& pass : drawing.passes)
                    if (draws_picture(pass.stage) && !compute_patches(pass, pixels, rays, rays_along))
                        gl::draw_listed_points(picture_program(pass), pixels, rays.framebuffer.id(), rays.width,
                                               rays.height);
            },
            [&](const gl::VertexList& pixels, const gl::Target& rays) {
                gl::bind_texture_2d(kPictureUnit, rays.colours.front());
                gl::draw_listed_points(program(Stage::kPatches, Output::kLinear), pixels, linear_.framebuffer.id(),
                                       drawing.width, drawing.height, {.marked = gl::Marked::kOnly});
            });
    }
    blocks_.upload_pixel(refining_);
    bind_inputs();
}

// The passes that follow the picture's need all of it: they run with its last rows.
void Renderer::draw_rows_of(const Pass& pass, const Drawing& drawing, unsigned picture) {
    const auto& [list, framebuffer, width, height, first, last, next, refined] = drawing;
    if (goes_before(pass.stage)) {
        find_before(pass, first, last);
    } else if (draws_picture(pass.stage) && tables_.plan().scene.picture.samples > 1) {
        draw_samples(tables_.plan().scene.picture.samples, kRaysAtOnce, [&](const gl::Layer& layer) {
            draw_picture(pass, picture, drawing.width, drawing.height, drawing.first, drawing.last, layer);
        });
    } else if (draws_picture(pass.stage)) {
        draw_picture(pass, picture, width, height, first, last,
                     {.marked = refines(list) ? gl::Marked::kNot : gl::Marked::kAny});
    } else if (pass.stage != Stage::kEdges && pass.stage != Stage::kPatches && last == height &&
               (layer_ == PictureLayer::kAll || layer_ == PictureLayer::kSky)) {
        draw_pass(pass, framebuffer, width, height);
    }
}

// What a picture's rows ask for before they are drawn: tiles with its first ones.
void Renderer::find_before(const Pass& pass, int first, int last) {
    if (pass.stage == Stage::kLattice) {
        if (first == 0) lattice_.begin();
        const auto compute = [&](const LightLattice::Tell& tell, const gl::Target& nodes, int from, int to) {
            return compute_nodes(pass.output, tell, nodes, from, to);
        };
        const auto traced = [&]() -> const gl::Program& { return program(Stage::kLattice, pass.output); };
        lattice_.extend({compute, traced, program(Stage::kLatticeTold, pass.output),
                         program(Stage::kLatticeCells, pass.output), empty_},
                        last);
    } else if (first == 0 && !draws_lattice(pass.stage)) {
        find_tiles(pass.stage, pass.output);
    }
}

void Renderer::find_tiles(Stage stage, Output output) {
    const gl::Program* computed = compute_program(stage, output, {});
    const gl::Program& built = computed != nullptr ? *computed : program(stage, output);
    picture_tiles_.find(stage, built, [&](const gl::Target& to) {
        if (computed != nullptr)
            gl::compute_rows(built, to, kTileSide, 0, to.height);
        else
            gl::draw_fullscreen(built, empty_, to.framebuffer.id(), to.width, to.height);
    });
}

// Those of a lattice's nodes that are traced. false: they are left to fragments.
bool Renderer::compute_nodes(Output output, const LightLattice::Tell& tell, const gl::Target& nodes, int first,
                             int last) {
    const gl::Program* built = compute_program(Stage::kLattice, output, {});
    const gl::TileList* list = built == nullptr
                                   ? nullptr
                                   : computed_.tiles(Stage::kLattice, tiles_along(nodes.width), first / kTileSide,
                                                     tiles_along(last), name_inputs, tell);
    if (list == nullptr) return false;
    tell(*built);
    gl::compute_tiles(*built, {nodes.colours.front().id(), gl::Format::kRgba32F, nodes.width, nodes.height}, *list,
                      first, last);
    return true;
}

// samples x samples rays of each pixel: at_once of them in a draw, so that a weak card does not take long for it.
template <class Draw>
void Renderer::draw_samples(int samples, int at_once, Draw draw) {
    const int rays = samples * samples;
    const FramePlan& plan = tables_.plan();
    if (const auto& medium = plan.scene.medium)
        at_once = std::min(at_once, medium_spans(*plan.matter, *medium) < kSpansOfMany ? kRaysAtOnceInMatter : 1);
    for (int first = 0; first < rays; first += at_once) {
        const int count = std::min(at_once, rays - first);
        blocks_.upload_samples(samples, first, count);
        draw(gl::Layer{static_cast<double>(count) / rays, first == 0});
    }
    blocks_.upload_pixel(refining_);
}

}  // namespace nullscope
