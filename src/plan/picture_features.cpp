// Features of the skies, and what lens, film and eye do to the picture.
#include <fmt/format.h>

#include "plan/feature.h"
#include "scene/projection.h"
#include "spacetime/spacetime.h"

namespace nullscope {
namespace {

constexpr KeyRange kBloom{0.0, 1.0, false, true};
constexpr KeyRange kSamples{1.0, 16.0};

const char* name_of(SkyKind kind) { return kSkyKindNames[static_cast<int>(kind)]; }
std::string sky_words(const FrameFacts& f) { return fmt::format("sky.kind = \"{}\"", name_of(f.scene.sky.kind)); }

}  // namespace

std::span<const Feature> picture_features() {
    static const auto features = std::to_array<Feature>({
        {{Effect::kPointStars, "point-stars", "EFFECT_POINT_STARS", "Stars are points, each with all its images.",
          "sky.kind is \"points\"",
          "a pass of its own: a vertex a star and image; about a rotating hole a mesh of rays "
          "on the host"},
         [](const FrameFacts& f) { return reason_if(f.points(), sky_words(f)); },
         [](Scene& s) { s.sky.kind = s.sky.uniform_stars == 0 ? SkyKind::kStars : SkyKind::kBlack; },
         nothing,
         [](Scene& s) {
             s.sky.kind = SkyKind::kPoints;
             s.sky.uniform_stars = 100000;
             s.sky.magnitude_limit = 6.0;
             s.light = {false, false};
         }},
        {{Effect::kSky, "sky", "EFFECT_SKY", "Escaped rays show the celestial sphere.",
          "sky.kind is stars, image, nebula or points, and there are no sky.uniform_stars", "one fetch a pixel"},
         [](const FrameFacts& f) { return reason_if(f.sky_light, sky_words(f)); },
         [](Scene& s) { s.sky.kind = SkyKind::kBlack; },
         nothing,
         [](Scene& s) { s.sky.kind = SkyKind::kStars; }},
        {{Effect::kSkyShift, "sky-shift", "EFFECT_SKY_SHIFT",
          "The sky picture has the colour and brightness that g gives it.",
          "there is a sky.temperature, and the camera moves or is not far away",
          "a factor; one fetch and one logarithm a pixel where the camera moves"},
         [](const FrameFacts& f) -> Reason {
             if (!f.sky_shift) return kNot;
             const bool motion = f.moves && f.scene.light.doppler;
             return fmt::format("sky.temperature = {}, {}", *f.scene.sky.temperature_K,
                                motion ? "camera.velocity" : fmt::format("camera.r = {}", f.scene.camera.r));
         },
         [](Scene& s) { s.sky.temperature_K.reset(); },
         [](Scene& s) {
             s.sky.kind = SkyKind::kStars;
             s.camera.velocity = {0.1, 0.2, 0.3};
         },
         [](Scene& s) { s.sky.temperature_K = 6000.0; }},
        {{Effect::kSkyPattern, "sky-pattern", "EFFECT_SKY_PATTERN",
          "Escaped rays show a colour, a pattern or a formula.",
          "sky.kind is plain, checker, grid, stripes, noise or formula", "arithmetic a pixel"},
         [](const FrameFacts& f) { return reason_if(is_procedural(f.scene.sky.kind), sky_words(f)); },
         [](Scene& s) { s.sky.kind = SkyKind::kBlack; },
         nothing,
         [](Scene& s) { s.sky.kind = SkyKind::kPlain; }},
        {{Effect::kFarSky, "far-sky", "EFFECT_FAR_SKY", "Rays through the wormhole show the sky of its other side.",
          "spacetime.metric is a wormhole and far_sky.kind is not black", "one fetch a pixel"},
         [](const FrameFacts& f) -> Reason {
             if (!f.bends() || f.spacetime->inner_end() != InnerEnd::kOtherSky ||
                 f.scene.far_sky.kind == SkyKind::kBlack)
                 return kNot;
             return fmt::format("spacetime.metric = \"{}\", far_sky.kind = \"{}\"", f.scene.spacetime.metric,
                                name_of(f.scene.far_sky.kind));
         },
         [](Scene& s) { s.far_sky.kind = SkyKind::kBlack; },
         dark_wormhole,
         [](Scene& s) { s.far_sky.kind = SkyKind::kStars; }},
        {{Effect::kBloom, "bloom", "EFFECT_BLOOM", "Lens and eye scatter light into a halo.",
          "picture.bloom is above 0", "the picture in linear light, halved again and again and added up"},
         [](const FrameFacts& f) {
             return reason_if(f.scene.picture.bloom > 0.0, fmt::format("picture.bloom = {}", f.scene.picture.bloom));
         },
         [](Scene& s) { s.picture.bloom = 0.0; },
         nothing,
         [](Scene& s) { s.picture.bloom = 0.1; },
         nullptr,
         {{"picture", "bloom", KeyType::kNumber, "", "0", kBloom, "",
           "Fraction of the light that lens and eye scatter into a halo.", [](auto& s) { return &s.picture.bloom; }}}},
        {{Effect::kAutoExposure, "auto-exposure", "EFFECT_AUTO_EXPOSURE",
          "Exposure follows the picture's mean luminance.", "picture.auto_exposure is \"on\"",
          "the picture in linear light, halved again and again"},
         [](const FrameFacts& f) { return reason_if(f.scene.picture.auto_exposure, "picture.auto_exposure = \"on\""); },
         [](Scene& s) { s.picture.auto_exposure = false; },
         nothing,
         [](Scene& s) { s.picture.auto_exposure = true; },
         nullptr,
         {on_off_key("picture", "auto_exposure", "off",
                     "Whether exposure adapts to the picture's mean luminance, which counts as 1e-4 at least; "
                     "camera.exposure is then added.",
                     [](auto& s) { return &s.picture.auto_exposure; })}},
        {{Effect::kToneFilm, "tone-film", "EFFECT_TONE_FILM", "Bright light is compressed as on film.",
          "picture.tone is \"film\"", "arithmetic"},
         [](const FrameFacts& f) {
             return reason_if(f.scene.picture.tone == ToneCurve::kFilm, "picture.tone = \"film\"");
         },
         [](Scene& s) { s.picture.tone = ToneCurve::kShoulder; },
         nothing,
         [](Scene& s) { s.picture.tone = ToneCurve::kFilm; }},
        {{Effect::kToneNeutral, "tone-neutral", "EFFECT_TONE_NEUTRAL",
          "Bright light is compressed, other colours are kept.", "picture.tone is \"neutral\"", "arithmetic"},
         [](const FrameFacts& f) {
             return reason_if(f.scene.picture.tone == ToneCurve::kNeutral, "picture.tone = \"neutral\"");
         },
         [](Scene& s) { s.picture.tone = ToneCurve::kShoulder; },
         nothing,
         [](Scene& s) { s.picture.tone = ToneCurve::kNeutral; }},
        {{Effect::kDither, "dither", "EFFECT_DITHER", "Noise hides the steps of 8 bits.", "picture.dither is \"on\"",
          "arithmetic"},
         [](const FrameFacts& f) { return reason_if(f.scene.picture.dither, "picture.dither = \"on\""); },
         [](Scene& s) { s.picture.dither = false; },
         nothing,
         [](Scene& s) { s.picture.dither = true; },
         nullptr,
         {on_off_key("picture", "dither", "off",
                     "Adds noise of half an 8-bit step, so that dark gradients show no bands.",
                     [](auto& s) { return &s.picture.dither; })}},
        {{Effect::kSamples, "samples", "EFFECT_SAMPLES", "Several rays a pixel make edges smooth.",
          "picture.samples is above 1", "the picture once more for every ray, in linear light"},
         [](const FrameFacts& f) {
             return reason_if(f.scene.picture.samples > 1,
                              fmt::format("picture.samples = {}", f.scene.picture.samples));
         },
         [](Scene& s) { s.picture.samples = 1; },
         nothing,
         [](Scene& s) { s.picture.samples = 2; },
         nullptr,
         {{"picture", "samples", KeyType::kWhole, "", "1", kSamples, "",
           "Rays along each side of a pixel: N x N rays, averaged in linear light. Makes edges and thin rings smooth.",
           [](auto& s) { return &s.picture.samples; }}}},
        {{Effect::kRefine, "refine", "EFFECT_REFINE", "Pixels on edges and thin lines get more rays.",
          "picture.refine is \"on\", picture.samples is 1, and light is bent or there is a disc or a body",
          "a pass that compares neighbours; 4 to 36 rays for pixels that differ from one"},
         [](const FrameFacts& f) {
             const bool edges =
                 f.bends() || light_path_kind(f.so_far) == LightPathKind::kMino || meets_objects(f.so_far);
             return reason_if(edges && f.scene.picture.refine && f.scene.picture.samples == 1,
                              "picture.refine = \"on\"");
         },
         [](Scene& s) { s.picture.refine = false; },
         [](Scene& s) { still_disc(s), s.picture.refine = false; },
         [](Scene& s) { s.picture.refine = true; },
         nullptr,
         {on_off_key("picture", "refine", "on",
                     "Whether pixels that differ much from a neighbour are drawn again with more rays: edges and thin "
                     "lines become smooth. Where picture.samples is 1.",
                     [](auto& s) { return &s.picture.refine; })}},
        {{Effect::kWarp, "warp", "EFFECT_WARP", "A mesh lays the picture out anew, for a mirror or a curved screen.",
          "there is a camera.warp", "the mesh's cell and triangle, looked up a ray; no tiles"},
         [](const FrameFacts& f) {
             const auto& file = f.scene.camera.warp;
             return reason_if(!file.empty(), fmt::format("camera.warp = \"{}\"", file.filename().string()));
         },
         [](Scene& s) { s.camera.warp.clear(); },
         nothing,
         [](Scene& s) { s.camera.warp = assets_directory() / "warp" / "mirror.data"; },
         nullptr,
         {{"camera", "warp", KeyType::kFile, "", "", kNoRange, "warp mesh",
           "Warp mesh for mirror domes and curved screens: Paul Bourke's, Stellarium's, SGC or PFM.",
           [](auto& s) { return &s.camera.warp; }, [](const Scene& s) { return !projection_of(s.camera).faces; },
           "a projection that is no cube"},
          {"camera", "warp_intensity", KeyType::kChoice, "", "linear", kNoRange, "linear display",
           "What the mesh's intensities multiply: light, or displayed values, as players do (light by their power "
           "2.2).",
           [](auto& s) { return &s.camera.warp_intensity; }, [](const Scene& s) { return !s.camera.warp.empty(); },
           "a camera.warp"}}},
    });
    return features;
}

}  // namespace nullscope
