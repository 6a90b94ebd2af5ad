// Features of the skies, and what lens, film and eye do to the picture.
#include <fmt/format.h>

#include "scene/feature.h"
#include "spacetime/spacetime.h"

namespace nullscope {
namespace {

const char* name_of(SkyKind kind) { return kSkyKindNames[static_cast<int>(kind)]; }

}  // namespace

std::span<const Feature> picture_features() {
    static const auto features = std::to_array<Feature>({
        {{Effect::kPointStars, "point-stars", "EFFECT_POINT_STARS", "Stars are points, each with all its images.",
          "sky.kind is \"points\"",
          "a pass of its own: a vertex a star and image; star lens, black body; about a rotating hole a mesh of rays "
          "on the host"},
         [](const FrameFacts& f) -> Reason { return f.points() ? Reason("sky.kind = \"points\"") : kNot; },
         [](Scene& s) { s.sky.kind = s.sky.even_stars == 0 ? SkyKind::kStars : SkyKind::kBlack; },
         nothing,
         [](Scene& s) {
             s.sky.kind = SkyKind::kPoints;
             s.sky.even_stars = 100000;
             s.sky.faintest = 6.0;
             s.light = {false, false};
         }},
        {{Effect::kSky, "sky", "EFFECT_SKY", "Escaped rays show the celestial sphere.",
          "sky.kind is stars, image or points, and there are no sky.even_stars", "a cube map; one fetch a pixel"},
         [](const FrameFacts& f) -> Reason {
             return !f.sky_light ? kNot : Reason(fmt::format("sky.kind = \"{}\"", name_of(f.scene.sky.kind)));
         },
         [](Scene& s) { s.sky.kind = SkyKind::kBlack; },
         nothing,
         [](Scene& s) { s.sky.kind = SkyKind::kStars; }},
        {{Effect::kSkyShift, "sky-shift", "EFFECT_SKY_SHIFT",
          "The light of the sky's picture has the colour and brightness that g gives it.",
          "there is a sky.temperature, and the camera moves or is not far away",
          "a factor; black body and one logarithm a pixel where the camera moves"},
         [](const FrameFacts& f) -> Reason {
             return !f.sky_shift ? kNot
                                 : Reason(fmt::format("sky.temperature = {}, {}", *f.scene.sky.temperature_K,
                                                      f.moves && f.scene.light.doppler
                                                          ? "camera.velocity"
                                                          : fmt::format("camera.r = {}", f.scene.camera.r)));
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
         [](const FrameFacts& f) -> Reason {
             return !has_look(f.scene.sky.kind) ? kNot
                                                : Reason(fmt::format("sky.kind = \"{}\"", name_of(f.scene.sky.kind)));
         },
         [](Scene& s) { s.sky.kind = SkyKind::kBlack; },
         nothing,
         [](Scene& s) { s.sky.kind = SkyKind::kPlain; }},
        {{Effect::kFarSky, "far-sky", "EFFECT_FAR_SKY", "Rays through the wormhole show the sky of its other side.",
          "spacetime.metric is a wormhole and far_sky.kind is not black", "a cube map; one fetch a pixel"},
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
        {{Effect::kBloom, "bloom", "EFFECT_BLOOM", "Lens and eye scatter light about its place.",
          "picture.bloom is above 0", "the picture in linear light, halved again and again and added up"},
         [](const FrameFacts& f) -> Reason {
             return !(f.scene.picture.bloom > 0.0) ? kNot
                                                   : Reason(fmt::format("picture.bloom = {}", f.scene.picture.bloom));
         },
         [](Scene& s) { s.picture.bloom = 0.0; },
         nothing,
         [](Scene& s) { s.picture.bloom = 0.1; }},
        {{Effect::kAutoExposure, "auto-exposure", "EFFECT_AUTO_EXPOSURE",
          "Exposure follows the picture's mean luminance.", "picture.auto_exposure is \"on\"",
          "the picture in linear light, halved again and again"},
         [](const FrameFacts& f) -> Reason {
             return f.scene.picture.auto_exposure ? Reason("picture.auto_exposure = \"on\"") : kNot;
         },
         [](Scene& s) { s.picture.auto_exposure = false; },
         nothing,
         [](Scene& s) { s.picture.auto_exposure = true; }},
        {{Effect::kToneFilm, "tone-film", "EFFECT_TONE_FILM", "Bright light is compressed as by film.",
          "picture.tone is \"film\"", "arithmetic"},
         [](const FrameFacts& f) -> Reason {
             return f.scene.picture.tone == ToneCurve::kFilm ? Reason("picture.tone = \"film\"") : kNot;
         },
         [](Scene& s) { s.picture.tone = ToneCurve::kShoulder; },
         nothing,
         [](Scene& s) { s.picture.tone = ToneCurve::kFilm; }},
        {{Effect::kToneNeutral, "tone-neutral", "EFFECT_TONE_NEUTRAL",
          "Bright light is compressed, other colours are kept.", "picture.tone is \"neutral\"", "arithmetic"},
         [](const FrameFacts& f) -> Reason {
             return f.scene.picture.tone == ToneCurve::kNeutral ? Reason("picture.tone = \"neutral\"") : kNot;
         },
         [](Scene& s) { s.picture.tone = ToneCurve::kShoulder; },
         nothing,
         [](Scene& s) { s.picture.tone = ToneCurve::kNeutral; }},
        {{Effect::kDither, "dither", "EFFECT_DITHER", "Noise hides the steps of 8 bits.", "picture.dither is \"on\"",
          "arithmetic"},
         [](const FrameFacts& f) -> Reason {
             return f.scene.picture.dither ? Reason("picture.dither = \"on\"") : kNot;
         },
         [](Scene& s) { s.picture.dither = false; },
         nothing,
         [](Scene& s) { s.picture.dither = true; }},
    });
    return features;
}

}  // namespace nullscope
