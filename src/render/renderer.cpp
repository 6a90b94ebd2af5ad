#include "render/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "gl/abilities.h"
#include "plan/medium_model.h"
#include "scene/bodies.h"
#include "scene/projection.h"
#include "shaderlib/flat_frame.h"
#include "shaderlib/passes.h"
#include "table/star_lens.h"

namespace nullscope {
namespace {

constexpr int kTileUnit = FrameInputs::kFreeUnit;
// Passes that work on the picture sample none of the scene's tables: they share their units.
constexpr int kSourceUnit = FrameInputs::unit_of("strip_texture"), kHaloUnit = FrameInputs::unit_of("orbit_texture"),
              kMeterUnit = FrameInputs::unit_of("sky_texture");
constexpr std::pair<const char*, int> kPassSamplers[] = {{"source_texture", kSourceUnit},
                                                         {"bloom_texture", kHaloUnit},
                                                         {"meter_texture", kMeterUnit},
                                                         {"picture_texture", kPictureUnit},
                                                         {"listed_texture", kListUnit}};

}  // namespace

std::vector<std::string> Renderer::take_notes() {
    if (const std::string why = computed_.take_refusal(); !why.empty())
        notes_.push_back(fmt::format("fragment shaders draw in the place of compute shaders: {}", why));
    return std::exchange(notes_, {});
}

Renderer::Renderer()
    : info_(gl::info()),
      inputs_(info_),
      empty_(gl::make_vertex_array()),
      flat_frame_(gl::names_llvmpipe(info_.renderer)) {}

Status Renderer::prepare(const Scene& scene) {
    if (Status status = begin_prepare(scene); !status) return status;
    const auto ready = prepare_skies([] { return true; });
    return ready ? Status(Done{}) : Status(ready.error());
}

Result<bool> Renderer::prepare_skies(const std::function<bool()>& goes_on) {
    auto whole = inputs_.finish(notes_, goes_on);
    if (whole && *whole) blocks_.upload(tables_, inputs_.facts());
    return whole;
}

Status Renderer::begin_prepare(const Scene& scene) {
    const int limit = std::min(info_.max_texture_size, info_.max_renderbuffer_size);
    if (scene.camera.width > limit || scene.camera.height > limit)
        return bad_input(
            fmt::format("size {}x{} is beyond what this driver can draw", scene.camera.width, scene.camera.height),
            fmt::format("1x1 to {}x{}", limit, limit));
    if (Status status = tables_.update(scene); !status) return status;
    if (Status able = tables_.path().check(method_, tables_.plan()); !able) return able;
    body_text_ = body_text(scene, tables_.effects());
    if (Status status = inputs_.begin(tables_, method_, notes_); !status) return status;
    return stars_.update(scene, tables_, star_search_);
}

Renderer::ProgramKey Renderer::program_key(Stage stage, Output output) const {
    return knows_scene(stage) ? ProgramKey(stage, output, tables_.effects(), method_,
                                           std::string(tables_.spacetime().name()), body_text_)
                              : ProgramKey(stage, output, EffectSet{}, Method{}, std::string(), BodyText{});
}

ShaderSource Renderer::source_of(Stage stage, Output output) const {
    ShaderSource source =
        shader_source(stage, tables_.effects(), output, method_, tables_.spacetime().name(), body_text_);
    // Interpolated tiles have inputs enough of their own.
    const bool flat = flat_frame_ && (draws_picture(stage) || stage == Stage::kLattice) && !is_interpolated(stage);
    return flat ? with_flat_frame(source, kMostFlatInputs) : source;
}

const gl::Program& Renderer::program(Stage stage, Output output) {
    const ProgramKey key = program_key(stage, output);
    const auto found = programs_.find(key);
    if (found != programs_.end()) return found->second;
    const ShaderSource source = source_of(stage, output);
    auto begun = coming_.extract(key);
    gl::Program made = begun ? std::move(begun.mapped()) : gl::begin_program(source.vertex, source.fragment);
    gl::finish_program(made, source.vertex, source.fragment);
    name_inputs(made);
    return programs_.emplace(key, std::move(made)).first->second;
}

void Renderer::name_inputs(const gl::Program& program) {
    UniformBlocks::name(program);
    FrameInputs::name(program);
    for (const auto& [sampler, unit] : kPassSamplers) gl::set_integer(program, sampler, unit);
    for (int i = 0; const char* sampler : PictureTiles::kSamplers) gl::set_integer(program, sampler, kTileUnit + i++);
    for (int i = 0; const char* sampler : LightLattice::kSamplers) gl::set_integer(program, sampler, kTileUnit + i++);
}

const gl::Program* Renderer::compute_program(Stage stage, Output output, gl::Stored stored) {
    if (!computed_.wants(stage)) return nullptr;
    return computed_.program(
        program_key(stage, output), stored,
        [&] {
            std::string text = compute_source(stage, tables_.effects(), output, method_, tables_.spacetime().name(),
                                              body_text_, computed_.patches());
            return flat_frame_ ? with_frame_read_once(text, kMostFlatInputs) : text;
        },
        name_inputs);
}

// false: it is left to fragments.
bool Renderer::compute_picture(const Pass& pass, unsigned picture, int first, int last, const gl::Layer& layer) {
    const auto image = computed_.wants(pass.stage) ? gl::stored_image(picture) : std::nullopt;
    const gl::Program* built =
        image ? compute_program(pass.stage, pass.output, {image->format, gl::adds(layer)}) : nullptr;
    if (built == nullptr) return false;
    tell_picture(*built, pass.output);
    if (!lists_tiles(pass.stage)) {
        gl::compute_rows(*built, *image, kTileSide, first, last, layer);
        return true;
    }
    const gl::TileList* list =
        computed_.tiles(pass.stage, tiles_along(image->width), first / kTileSide, tiles_along(last), name_inputs,
                        [this](const gl::Program& lists) {
                            lattice_.tell(lists);
                            gl::set_integer(lists, "tile_groups", tile_side(tables_.effects()) / kTileSide);
                        });
    if (list != nullptr) gl::compute_tiles(*built, *image, *list, first, last, layer);
    return list != nullptr;
}

bool Renderer::is_compiled(Stage stage, Output output) {
    const ProgramKey key = program_key(stage, output);
    auto begun = coming_.find(key);
    if (begun == coming_.end()) {
        const ShaderSource source = source_of(stage, output);
        begun = coming_.emplace(key, gl::begin_program(source.vertex, source.fragment)).first;
    }
    return gl::is_compiled(begun->second);
}

int Renderer::picture_programs() const {
    return static_cast<int>(
               std::count_if(programs_.begin(), programs_.end(),
                             [](const auto& entry) { return draws_picture(std::get<Stage>(entry.first)); })) -
           built_ahead_;
}

void Renderer::bind_inputs() {
    blocks_.bind();
    inputs_.bind();
    picture_tiles_.bind(kTileUnit);
    lattice_.bind(kTileUnit);
}

// What passes of light work on, if there are any: made for the picture's size.
void Renderer::keep_light(const std::vector<Pass>& list, int width, int height, Output output) {
    const bool refine = refines(list), keep = keeps_light(list) || refine;
    // Linear light that is handed on is as exact as the target that it is copied to; for the eye it may be far from 1 before its exposure.
    const gl::Format format = output != Output::kDisplay ? gl::Format::kRgba32F
                              : keeps_light(list)        ? gl::filtered_light()
                                                         : gl::Format::kRgba16F;
    if (!keep) {
        linear_ = {};
    } else if (linear_.width != width || linear_.height != height || linear_format_ != format) {
        linear_ = gl::make_target(width, height, format);
        linear_format_ = format;
        gl::set_linear(linear_.colours.front());
        edges_ = {};
    }
    edges_.resize(list, linear_);
    if (refine)
        patches_.resize(linear_format_);
    else
        patches_.clear();
    if (keeps_light(list) && scatters_or_meters())
        bloom_.resize(width, height);
    else
        bloom_.clear();
}

bool Renderer::scatters_or_meters() const {
    return tables_.effects().contains(Effect::kBloom) || tables_.effects().contains(Effect::kAutoExposure);
}

bool Renderer::own_steps() const {
    const auto& medium = tables_.plan().scene.medium;
    return medium && model_of(*medium).traits.own_steps;
}

// What a program of the picture is told before it draws.
void Renderer::tell_picture(const gl::Program& built, Output output) const {
    lattice_.tell(built);
    if (output == Output::kLayers) gl::set_integer(built, "layer_shown", static_cast<int>(layer_));
}

const gl::Program& Renderer::picture_program(const Pass& pass) {
    const gl::Program& built = program(pass.stage, pass.output);
    tell_picture(built, pass.output);
    return built;
}

// The same of pixels that are drawn again with side x side rays.
bool Renderer::compute_patches(const Pass& pass, const gl::VertexList& pixels, const gl::Target& rays, int side) {
    const auto image = computed_.wants_patches(pass.stage) ? gl::stored_image(rays.framebuffer.id()) : std::nullopt;
    const gl::Program* built = image ? compute_program(pass.stage, pass.output, {image->format, false}) : nullptr;
    if (built == nullptr) return false;
    tell_picture(*built, pass.output);
    gl::compute_patches(*built, *image, pixels, kTileSide, patch_rows(side, pixels.count));
    return true;
}

void Renderer::draw_picture(const Pass& pass, unsigned picture, int width, int height, int first, int last,
                            const gl::Layer& layer) {
    if (compute_picture(pass, picture, first, last, layer)) return;
    const gl::Program& built = picture_program(pass);
    if (is_in_tiles(pass.stage))
        gl::draw_tiles(built, empty_, picture, width, height, tile_side(tables_.effects()), first, last, layer);
    else
        gl::draw_rows(built, empty_, picture, width, height, first, last, layer);
}

// Numbers that shaders/stage/interpolated.vert hands on with a disc: 24 vectors. OpenGL 3.3 promises 60; drivers have 120 and more.
constexpr int kVaryingOfDisc = 96;

// The method that follows from the scene alone may interpolate; others show what they are. The Kerr-Schild march has no tiles.
std::vector<Pass> Renderer::passes_with(Tiles most, Output output) const {
    const bool hands_on_rays = !interpolates_disc(tables_.effects()) || info_.max_varying >= kVaryingOfDisc;
    const Tiles able = method_.kind == MethodKind::kKerrSchild                                 ? Tiles::kNone
                       : method_.kind == MethodKind::kStrip && !method_.cubic && hands_on_rays ? Tiles::kInterpolated
                                                                                               : Tiles::kTraced;
    return passes(tables_.effects(), output, std::min(able, most));
}

std::vector<Pass> Renderer::picture_passes(Output output) const {
    if (most_built_tiles_ > most_tiles_) {
        std::vector<Pass> list = passes_with(most_built_tiles_, output);
        const bool matter = std::ranges::find(list, Stage::kLattice, &Pass::stage) != list.end();
        if (matter || std::ranges::all_of(list, [&](const Pass& pass) {
                return programs_.contains(program_key(pass.stage, pass.output));
            }))
            return list;
    }
    return passes_with(most_tiles_, output);
}

bool Renderer::build_next() {
    constexpr int kSide =
        3 * kFirstTiles * kTileSide;  // no power of two: llvmpipe compiles once more for textures of such sizes
    const std::vector<Pass> list = passes_with(most_built_tiles_, Output::kDisplay);
    for (const Pass& pass : list) {
        if (pass.stage == Stage::kPicture || !(goes_before(pass.stage) || draws_picture(pass.stage)) ||
            programs_.contains(program_key(pass.stage, pass.output)))
            continue;
        if (!is_compiled(pass.stage, pass.output)) return true;
        // Many drivers compile once more when something is drawn.
        const gl::Target target =
            gl::make_target(kSide, kSide, keeps_light(list) ? gl::filtered_light() : gl::Format::kRgba8);
        picture_tiles_.resize(list, kSide, kSide, tables_.effects());
        lattice_.resize(list, kSide, kSide, own_steps());
        bind_inputs();
        if (draws_picture(pass.stage))
            draw_picture(pass, target.framebuffer.id(), kSide, kSide, 0, kSide, {});
        else
            find_before(pass, 0, kSide);
        gl::finish();
        if (draws_picture(pass.stage)) ++built_ahead_;
        return true;
    }
    return false;
}

void Renderer::draw_pass(const Pass& pass, unsigned framebuffer, int width, int height) {
    const gl::Program& built = program(pass.stage, pass.output);
    const unsigned picture = linear_.width > 0 ? linear_.framebuffer.id() : framebuffer;
    switch (pass.stage) {
        case Stage::kStars:
            return stars_.draw(built, picture, width, height,
                               tables_.effects().contains(Effect::kLensing) ? kStarImages : 1,
                               tables_.plan().scene.camera.projection);
        case Stage::kBloomDown: return bloom_.draw_down(built, empty_, linear_.colours.front(), kSourceUnit);
        case Stage::kBloomUp: return bloom_.draw_up(built, empty_, kSourceUnit, kHaloUnit);
        case Stage::kMeter: return bloom_.draw_meter(built, empty_, kSourceUnit, adaptation_);
        case Stage::kDevelop:
            gl::bind_texture_2d(kPictureUnit, linear_.colours.front());
            if (tables_.effects().contains(Effect::kBloom)) gl::bind_texture_2d(kHaloUnit, bloom_.halo());
            if (tables_.effects().contains(Effect::kAutoExposure)) gl::bind_texture_2d(kMeterUnit, bloom_.metered());
            return gl::draw_fullscreen(built, empty_, framebuffer, width, height);
        default: return gl::draw_fullscreen(built, empty_, picture, width, height);
    }
}

void Renderer::draw_bare_fetch(unsigned framebuffer, int width, int height) {
    const gl::Program& built = program(Stage::kBareFetch, Output::kLinear);
    bind_inputs();
    gl::draw_fullscreen(built, empty_, framebuffer, width, height);
}

Status Renderer::prepare_list(const Scene& scene, bool crossings) {
    tables_.want_crossings(crossings);
    Status ready = tables_.update(scene);
    tables_.want_crossings(false);
    if (!ready) return ready;
    if (Status able = tables_.path().check(method_, tables_.plan()); !able) return able;
    body_text_ = body_text(scene, tables_.effects());
    inputs_.load_rays(tables_, method_);
    blocks_.upload(tables_, {});
    return Done{};
}

double Renderer::refined_share() const {
    return linear_.width == 0
               ? 0.0
               : static_cast<double>(edges_.count()) / (static_cast<double>(linear_.width) * linear_.height);
}

std::vector<TextureLine> Renderer::textures() const {
    std::vector<TextureLine> lines = inputs_.lines(tables_);
    if (stars_.count() > 0) lines.push_back({"stars", stars_.count(), 1, stars_.bytes()});
    if (linear_.width > 0)
        lines.push_back({"linear picture", linear_.width, linear_.height,
                         gl::bytes_of(linear_format_) * static_cast<std::size_t>(linear_.width) *
                             static_cast<std::size_t>(linear_.height)});
    if (bloom_.bytes() > 0)
        lines.push_back({"bloom", (linear_.width + 1) / 2, (linear_.height + 1) / 2, bloom_.bytes()});
    return lines;
}

}  // namespace nullscope
