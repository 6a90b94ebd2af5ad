#include "render/frame_inputs.h"

#include "base/assets.h"
#include "base/stopwatch.h"
#include "plan/medium.h"
#include "render/disc_warp_row.h"
#include "render/frame_textures.h"
#include "scene/bodies.h"
#include "scene/disc_emissivity.h"
#include "scene/orbit_sense.h"
#include "shaderlib/passes.h"
#include "sky/packed_sky.h"
#include "table/disc_light.h"
#include "table/electron_table.h"
#include "table/orbit_table.h"
#include "table/star_lens.h"
#include "table/table_grid.h"

namespace nullscope {
namespace {

gl::Texture texture_of(const TexelGrid& grid) {
    return gl::make_number_texture(grid.width, grid.height, 4, grid.texels.data(), false);
}
gl::Texture texture_of(const TexelGrid* grid) { return grid != nullptr ? texture_of(*grid) : gl::Texture(); }

std::filesystem::path disc_image_file(const DiscSpec& disc) {
    return disc.image.empty() ? assets_directory() / "images" / "accretion-disc.png" : disc.image;
}

// The image that ships has none.
std::string disc_layer(const DiscSpec& disc) { return disc.image.empty() ? "" : disc.image_layer; }

}  // namespace

Result<FittedImage> load_disc_image(const DiscSpec& disc) {
    return load_fitted_image(disc_image_file(disc), {.layer = disc_layer(disc)});
}

void FrameInputs::name(const gl::Program& program) {
    for (const char* sampler : kSamplers) gl::set_integer(program, sampler, unit_of(sampler));
    for (int i = 0; i < kMostBodyImages; ++i) gl::set_integer(program, body_image_sampler(i).c_str(), kBodyUnit + i);
}

Status FrameInputs::begin(const FrameTables& tables, const Method& method, std::vector<std::string>& notes) {
    const Scene& scene = tables.plan().scene;
    begin_skies(tables, notes);
    const auto disc_file =
        tables.effects().contains(Effect::kDiscImage) ? disc_image_file(*scene.disc) : std::filesystem::path();
    const std::string layer = disc_file.empty() ? "" : disc_layer(*scene.disc);
    if (Status status = disc_.update(disc_file, {.max_side = largest_picture_, .layer = layer}, notes); !status)
        return status;
    if (Status status = body_images_.update(scene, largest_picture_, notes); !status) return status;
    if (Status status = warp_.update(scene.camera, info_.max_texture_size); !status) return status;
    if (Status status = medium_.update(scene, tables.matter(), info_); !status) return status;
    if (const std::string word = medium_note(tables.matter(), scene); !word.empty() && word != medium_told_)
        notes.push_back(medium_told_ = word);
    load_table(tables, method);
    load_heat(tables);
    load_black_body(tables.effects());
    load_electrons(tables);
    load_disc_warp(tables);
    load_tables(tables, method);
    return Done{};
}

void FrameInputs::load_rays(const FrameTables& tables, const Method& method) {
    load_table(tables, method);
    load_tables(tables, method);
    load_ends(tables);
}

void FrameInputs::load_tables(const FrameTables& tables, const Method& method) {
    const BallPaths& paths = tables.ball_paths();
    ball_paths_ = paths.balls.empty() ? gl::Texture() : texture_of(paths.rows);
    if (clearances_revision_ != tables.clearances_revision()) {
        clearances_revision_ = tables.clearances_revision();
        const SurfaceClearances& clearances = tables.clearances();
        clearances_ = clearances.rows() == 0 ? gl::Texture()
                                             : gl::make_number_texture(kClearanceWidth, clearances.rows(), 1,
                                                                       clearances.cells().data(), false);
    }
    if (rows_revision_ != tables.revision()) {
        rows_revision_ = tables.revision();
        ends_ = {};
        strip_ = texture_of(tables.texels("strip"));
        const TexelGrid *places = tables.texels("orbit table"), *delays = tables.texels("light-time table");
        orbit_table_ = delays != nullptr ? texture_of(side_by_side(*places, *delays)) : texture_of(places);
        star_lens_ = texture_of(tables.texels("star lens"));
    }
    // A picture of the sky alone does not look where along the ray it is.
    if (!meets_objects(tables.effects()) && !tables.effects().contains(Effect::kLightTimes) && !method.cubic)
        ends_ = {};
    else
        load_ends(tables);
}

void FrameInputs::load_ends(const FrameTables& tables) {
    if (!ends_) ends_ = texture_of(tables.texels("ray ends"));
}

void FrameInputs::begin_skies(const FrameTables& tables, std::vector<std::string>& notes) {
    const Scene& scene = tables.plan().scene;
    const SkyAsked asked = sky_asked(scene, tables.effects());
    if (asked != sky_asked_) {  // it may look into files
        sky_asked_ = asked;
        const int most = std::min(largest_face(info_.max_texture_size), std::max(largest_picture_, kUsualSkyFace));
        sky_faces_ = asked.near || asked.far ? sky_faces(asked, most) : SkyFaces();
        if (sky_faces_.halves && sky_faces_.coarse()) notes.push_back("sky.image: " + sky_faces_.words());
    }
    const int wanted = sky_faces_.size;
    skies_.begin(asked.near, asked.far, keep_finer_sky_ && wanted > 0 ? std::max(wanted, skies_.size()) : wanted);
}

void FrameInputs::load_heat(const FrameTables& tables) {
    const Scene& scene = tables.plan().scene;
    if (!tables.effects().contains(Effect::kThermalDisc)) {
        disc_flow_ = {};
        flow_key_.reset();
        hottest_ = {};
        return;
    }
    const auto& accretion = scene.disc->accretion;
    const Sense sense = sense_about(tables.matter(), scene.disc->sense);
    if (!accretion)
        hottest_ = {};
    else if (!(hottest_.by == accretion && hottest_.about == scene.spacetime && hottest_.sense == sense))
        hottest_ = {accretion, scene.spacetime, sense,
                    disc_temperature_K(disc_flux_peak(tables.matter(), sense).flux, accretion->mass_suns,
                                       accretion->rate_eddington)};
    const auto leaning =
        tables.effects().contains(Effect::kDiscLean) ? std::optional(scene.disc->lean.tilt) : std::nullopt;
    const auto key =
        std::make_tuple(scene.spacetime, sense, leaning, scene.disc->inner, scene.disc->outer, scene.light.doppler,
                        scene.light.gravity, scene.light.lensing, scene.disc->emissivity);
    if (flow_key_ == key) return;
    RingLight shines;
    if (scene.disc->emissivity.by != Emissivity::kAccretion)
        shines = [&](const std::vector<double>& radii) {
            return disc_emissivity_shares(tables.matter(), radii, scene.disc->emissivity, sense);
        };
    const ShiftParts parts{scene.light.doppler, scene.light.gravity, !scene.light.lensing};
    disc_flow_ =
        texture_of(disc_flow_row(tables.matter(), scene.disc->inner, scene.disc->outer, parts, sense, leaning, shines));
    flow_key_ = key;
}

void FrameInputs::load_black_body(const EffectSet& effects) {
    const bool wanted = uses_black_body(effects) || effects.contains(Effect::kPointStars);
    if (!wanted)
        black_body_ = {};
    else if (!black_body_)
        black_body_ = texture_of(black_body_row());
}

void FrameInputs::load_electrons(const FrameTables& tables) {
    std::optional<ElectronEnergies> key;
    if (tables.effects().contains(Effect::kMediumElectrons)) key = electron_energies(*tables.plan().scene.medium);
    if (key == electrons_key_) return;
    electrons_ = key ? texture_of(electron_texels(*key)) : gl::Texture();
    electrons_key_ = key;
}

void FrameInputs::load_disc_warp(const FrameTables& tables) {
    std::optional<std::tuple<double, double, DiscWarp>> key;
    if (tables.effects().contains(Effect::kDiscWarp)) {
        const DiscSpec& disc = *tables.plan().scene.disc;
        key.emplace(disc.inner, disc.outer, disc.warp);
    }
    if (key == disc_warp_key_) return;
    disc_warp_ = key ? texture_of(disc_warp_row(*tables.plan().scene.disc)) : gl::Texture();
    disc_warp_key_ = std::move(key);
}

void FrameInputs::load_table(const FrameTables& tables, const Method& method) {
    const Scene& scene = tables.plan().scene;
    if (tables.path().table() == nullptr || method.kind != MethodKind::kTable) {
        table_ = {};
        table_key_.reset();
        table_bytes_ = 0;
        return;
    }
    const auto key = std::make_pair(scene.spacetime, method);
    if (table_key_ == key) return;
    const Stopwatch watch;
    const bool hermite = method.lookup == Lookup::kHermite;
    const TableGrid grid = build_table_grid(*tables.path().table(), method.size, hermite);
    table_ = gl::make_number_texture(grid.width, grid.height, grid.channels, grid.values.data(),
                                     method.lookup == Lookup::kHardware);
    table_bytes_ = grid.values.size() * sizeof(float);
    table_key_ = key;
    table_ms_ = watch.ms();
}

void FrameInputs::bind() const {
    for (const auto& [sampler, texture] : {std::pair{"strip_texture", &strip_},
                                           {"ends_texture", &ends_},
                                           {"orbit_texture", &orbit_table_},
                                           {"disc_texture", &disc_.texture},
                                           {"table_texture", &table_},
                                           {"disc_matter_texture", &disc_flow_},
                                           {"black_body_texture", &black_body_},
                                           {"star_lens_texture", &star_lens_},
                                           {"clearance_texture", &clearances_},
                                           {"ball_path_texture", &ball_paths_},
                                           {"electron_texture", &electrons_},
                                           {"disc_warp_texture", &disc_warp_}})
        gl::bind_texture_2d(unit_of(sampler), *texture);
    gl::bind_texture_2d(unit_of("warp_texture"), warp_.texture());
    gl::bind_texture_layers(unit_of("medium_texture"), medium_.texture());
    skies_.bind(unit_of("sky_texture"), unit_of("other_side_texture"));
    body_images_.bind(kBodyUnit);
}

TextureFacts FrameInputs::facts() const {
    return {skies_.size(), disc_.width, hottest_.by ? std::optional(hottest_.temperature_K) : std::nullopt,
            medium_.grid(), skies_.light()};
}

std::vector<TextureLine> FrameInputs::lines(const FrameTables& tables) const {
    std::vector<TextureLine> lines;
    const auto add = [&](std::string name, int width, int height, std::size_t thirds) {  // of a byte a texel
        lines.push_back({std::move(name), width, height,
                         thirds * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) / 3});
    };
    constexpr std::size_t kPicture = 32, kTexel = 48, kNumber = 12;  // half floats with mip levels; numbers
    const std::size_t sky = 24 * skies_.texel_bytes();               // 6 faces with mip levels
    for (const auto& [name, texels] : tables.path().tables())
        if (name != "ray ends" || ends_) add(std::string(name), texels->width, texels->height, kTexel);
    if (table_bytes_ > 0)
        lines.push_back(
            {"deflection table", table_key_->second.size + 1, 2 * (table_key_->second.size + 1), table_bytes_});
    if (ball_paths_) add("ball paths", tables.ball_paths().rows.width, tables.ball_paths().rows.height, kTexel);
    if (clearances_) add("surface clearance", kClearanceWidth, tables.clearances().rows(), kNumber);
    const int face = bordered_size(skies_.size());
    if (skies_.far()) add("far sky", face, face, sky);
    if (skies_.near()) add("sky", face, face, sky);
    if (disc_.texture) add("disc image", disc_.width, disc_.height, kPicture);
    for (int image = 0; image < kMostBodyImages; ++image)
        if (const auto& picture = body_images_.pictures()[static_cast<std::size_t>(image)]; picture.texture)
            add(body_image_name(tables.plan().scene, image), picture.width, picture.height, kPicture);
    if (flow_key_) add("disc flow", kDiscFlowCells + 1, kDiscFlowRows, kTexel);
    if (black_body_) add("black body", kBlackBodyCells + 1, 1, kTexel);
    if (disc_warp_) add("disc warp", kDiscWarpCells + 1, 1, kTexel);
    if (electrons_) add("electrons", kElectronCells + 1, kElectronRows, kTexel);
    if (warp_.rows() > 0) add("warp mesh", kWarpRow, warp_.rows(), kTexel);
    if (const MediumGrid* grid = medium_.grid())
        lines.push_back({"medium grid", grid->rings().count, grid->polar().count * grid->around().count,
                         medium_.dumps() * grid->bytes()});
    return lines;
}

}  // namespace nullscope
