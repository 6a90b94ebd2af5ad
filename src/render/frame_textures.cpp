#include "render/frame_textures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "base/assets.h"
#include "image/large_image.h"
#include "light/black_body.h"
#include "plan/dump_window.h"
#include "render/bloom.h"
#include "render/body_images.h"
#include "render/disc_warp_row.h"
#include "render/renderer.h"
#include "render/sky_faces.h"
#include "render/warp_texture.h"
#include "scene/bodies.h"
#include "scene/medium_dumps.h"
#include "scene/warp_mesh.h"
#include "shaderlib/passes.h"
#include "sky/packed_sky.h"
#include "sky/point_stars.h"
#include "table/disc_light.h"
#include "table/electron_table.h"

namespace nullscope {
namespace {

constexpr int kMostTexture = 16384;                            // px; what drivers allow is said by `nullscope info`
constexpr long long kTexel = 16, kHalfTexel = 8, kNumber = 4;  // bytes
constexpr long long kMipThirds = 4;                            // with mip levels: thirds of the finest one

bool meets(Effect effect) { return meets_objects({effect}); }
bool shades(Effect effect) {
    return uses_black_body({effect}) || effect == Effect::kPointStars || effect == Effect::kSkyShift;
}
bool keeps(Effect effect) { return keeps_light(passes({effect}, Output::kDisplay)); }
bool scatters(Effect effect) { return effect == Effect::kBloom || effect == Effect::kAutoExposure; }
template <Effect wanted>
bool is(Effect effect) {
    return effect == wanted;
}

// Adds textures with the effects that fetch from them and, where no key of a scene is named, what calls for these.
class List {
public:
    explicit List(const FrameTables& tables) : plan_(tables.plan()) {}

    template <class Fetches>
    FrameTexture& add(std::string name, long long layers, long long width, long long height, long long bytes,
                      Fetches fetches) {
        FrameTexture& made = list.emplace_back(FrameTexture{std::move(name), layers, width, height, bytes, {}, {}});
        std::vector<std::string> reasons;
        for (const EffectReason& each : plan_.reasons) {
            if (!fetches(each.effect)) continue;
            made.effects.push_back(each.effect);
            if (std::ranges::find(reasons, each.reason) == reasons.end()) reasons.push_back(each.reason);
        }
        made.reason = fmt::format("{}", fmt::join(reasons, ", "));
        return made;
    }

    std::vector<FrameTexture> list;

private:
    const FramePlan& plan_;
};

void add_rays(const FrameTables& tables, List& to) {
    if (const DeflectionTable* table = tables.path().table())
        to.add("deflection table", 3, table->size() + 1, table->size() + 1, static_cast<long long>(table->bytes()),
               is<Effect::kLensing>)
            .on_gpu = false;
    const std::string radius = fmt::format("camera.r = {}", tables.plan().scene.camera.r);
    for (const auto& [name, texels] : tables.path().tables()) {
        auto* fetches = name == "strip"              ? is<Effect::kLensing>
                        : name == "star lens"        ? is<Effect::kPointStars>
                        : name == "light-time table" ? is<Effect::kDelay>
                                                     : meets;
        FrameTexture& made = to.add(std::string(name), 1, texels->width, texels->height,
                                    static_cast<long long>(texels->bytes()), fetches);
        if (name == "strip" || name == "star lens" || made.effects.empty()) made.reason = radius;
        made.on_gpu = name != "ray ends" || meets_objects(tables.effects());
    }
    if (const BallPaths& paths = tables.ball_paths(); !paths.balls.empty())
        to.add("ball paths", 1, paths.rows.width, paths.rows.height, static_cast<long long>(paths.rows.bytes()),
               is<Effect::kBallPath>);
    if (const SurfaceClearances& clearances = tables.clearances(); clearances.rows() > 0)
        to.add("surface clearance", 1, kClearanceWidth, clearances.rows(),
               kNumber * kClearanceWidth * clearances.rows(), is<Effect::kSurface>);
}

void add_skies(const Scene& scene, const EffectSet& effects, List& to) {
    const bool far = effects.contains(Effect::kFarSky), near = effects.contains(Effect::kSky);
    if (!far && !near) return;
    const SkyFaces faces = sky_faces(sky_asked(scene, effects), largest_face(kMostTexture));
    const long long size = bordered_size(faces.size);
    const long long bytes = 6 * kMipThirds * size * size * (faces.halves ? kHalfTexel : kNumber) / 3;
    const std::string words = fmt::format("{}; {}", faces.words(), faces.halves ? "half floats" : "small floats");
    if (far) to.add("far sky", 6, size, size, bytes, is<Effect::kFarSky>).reason = words;
    if (near) to.add("sky", 6, size, size, bytes, is<Effect::kSky>).reason = words;
}

// About a rotating hole each picture has the images that are in view.
Status add_stars(const Scene& scene, bool finds_images, List& to) {
    TRY(stars, point_stars(scene.sky, assets_directory()));
    const auto count = static_cast<long long>(stars->size());
    constexpr long long kStar = 20;  // bytes
    to.add("stars", 1, count, 1, kStar * count, is<Effect::kPointStars>).reason =
        fmt::format("sky.kind, sky.magnitude_limit{}", finds_images ? "; some of them: the images in view" : "");
    return Done{};
}

Status add_files(const FramePlan& plan, const EffectSet& effects, List& to) {
    const Scene& scene = plan.scene;
    const auto add_image = [&](const std::string& name, const Image<float>& image, auto fetches) -> FrameTexture& {
        const long long w = image.width, h = image.height;
        return to.add(name, 1, w, h, kMipThirds * kHalfTexel * w * h / 3, fetches);
    };
    if (effects.contains(Effect::kDiscImage)) {
        TRY(image, load_disc_image(*scene.disc));
        add_image("disc image", image->image, is<Effect::kDiscImage>);
    }
    for (int number = 0; const ImageSource& source : body_images(scene)) {
        TRY(image, load_fitted_image(source.file, body_image_limits(ImageLimits().max_side, source.layer)));
        add_image(body_image_name(scene, number++), image->image, is<Effect::kBodyImage>).reason =
            fmt::format("an image of a body, \"{}\"", source.file.filename().string());
    }
    if (effects.contains(Effect::kWarp)) {
        TRY(mesh, load_warp_mesh(scene.camera));
        const auto bytes = static_cast<long long>(sizeof(float) * warp_texels(**mesh, input_half(scene.camera)).size());
        to.add("warp mesh", 1, kWarpRow, bytes / (kTexel * kWarpRow), bytes, is<Effect::kWarp>);
    }
    if (effects.contains(medium_effect(MediumKind::kGrid))) {
        TRY(grid, medium_form(scene));
        const long long layers = grid->around().count, width = 2LL * grid->rings().count, height = grid->polar().count,
                        bytes = static_cast<long long>(grid->bytes());
        constexpr auto kFetches = is<medium_effect(MediumKind::kGrid)>;
        const bool slow = has_slow_light(scene);
        const long long slots = slow ? dump_window(*plan.matter, scene, *grid).slots : 1;
        FrameTexture& texture = to.add("medium grid", layers, width, slots * height, slots * bytes, kFetches);
        if (slow) texture.reason = window_words(*plan.matter, scene, *grid);
        if (has_dumps(scene) && !slow) {  // two, and what is between them
            FrameTexture& dumps = to.add("medium dumps", 3 * layers, width, height, 3 * bytes, kFetches);
            dumps.on_gpu = false;
            dumps.reason = fmt::format("{}: the two about the time, and their mean", dump_words(scene.medium->grid));
        }
    }
    return Done{};
}

void add_pictures(const Scene& scene, const EffectSet& effects, List& to) {
    if (!keeps_light(passes(effects, Output::kDisplay))) return;
    const long long w = scene.camera.width, h = scene.camera.height;
    to.add("linear picture", 1, w, h, static_cast<long long>(gl::bytes_of(gl::filtered_light())) * w * h, keeps)
        .reason = "camera.size";
    if (std::ranges::any_of(effects.list(), scatters))  // halves of halves, down and up
        to.add("bloom", 2, (w + 1) / 2, (h + 1) / 2,
               static_cast<long long>(Bloom::bytes(scene.camera.width, scene.camera.height)), scatters);
}

}  // namespace

std::string body_image_name(const Scene& scene, int image) {
    const auto files = body_images(scene);
    std::size_t body = 0;
    while (scene.bodies[body].material.source() != files[static_cast<std::size_t>(image)]) ++body;
    return body_section(scene, body) + " image";
}

Result<std::vector<FrameTexture>> frame_textures(const FrameTables& tables) {
    const Scene& scene = tables.plan().scene;
    const EffectSet& effects = tables.effects();
    List to(tables);
    add_rays(tables, to);
    add_skies(scene, effects, to);
    if (effects.contains(Effect::kThermalDisc))
        to.add("disc flow", 1, kDiscFlowCells + 1, kDiscFlowRows, kTexel * (kDiscFlowCells + 1) * kDiscFlowRows,
               is<Effect::kThermalDisc>);
    if (effects.contains(Effect::kDiscWarp))
        to.add("disc warp", 1, kDiscWarpCells + 1, 1, kTexel * (kDiscWarpCells + 1), is<Effect::kDiscWarp>);
    if (uses_black_body(effects) || effects.contains(Effect::kPointStars))
        to.add("black body", 1, kBlackBodyCells + 1, 1, kTexel * (kBlackBodyCells + 1), shades);
    if (effects.contains(Effect::kMediumElectrons))
        to.add("electrons", 1, kElectronCells + 1, kElectronRows, kTexel * (kElectronCells + 1) * kElectronRows,
               is<Effect::kMediumElectrons>);
    if (effects.contains(Effect::kPointStars)) {
        TRY(added, add_stars(scene, tables.path().finds_star_images(), to));
    }
    TRY(added, add_files(tables.plan(), effects, to));
    add_pictures(scene, effects, to);
    return to.list;
}

}  // namespace nullscope
