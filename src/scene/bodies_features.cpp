// Features of solid bodies, and what they are painted with.
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "scene/feature.h"
#include "scene/named_surface.h"

namespace nullscope {
namespace {

using Kinds = std::initializer_list<TextureKind>;

void make_plain(BodyLook& look, Kinds kinds) {
    if (std::find(kinds.begin(), kinds.end(), look.texture) != kinds.end()) look.texture = TextureKind::kPlain;
}

void make_bodies_plain(Scene& scene, Kinds kinds) {
    if (scene.sphere) make_plain(scene.sphere->look, kinds);
    if (scene.cylinder) make_plain(scene.cylinder->look, kinds);
    if (scene.ball) make_plain(scene.ball->look, kinds);
    if (scene.surface) make_plain(scene.surface->look, kinds);
}

void make_all_plain(Scene& scene, Kinds kinds) {
    make_bodies_plain(scene, kinds);
    if (scene.disc) make_plain(scene.disc->look, kinds);
    if (BodyLook sky = sky_look(scene.sky); has_look(scene.sky.kind)) {
        make_plain(sky, kinds);
        if (sky.texture == TextureKind::kPlain) scene.sky.kind = SkyKind::kPlain;
    }
}

// The first thing that is painted in one of these ways.
Reason texture_among(const Scene& scene, std::initializer_list<std::pair<TextureKind, const char*>> kinds) {
    std::vector<std::pair<const char*, TextureKind>> looks;
    if (scene.disc && scene.disc->look.texture != TextureKind::kImage)
        looks.emplace_back("disc.texture", scene.disc->look.texture);
    if (scene.sphere) looks.emplace_back("sphere.texture", scene.sphere->look.texture);
    if (scene.cylinder) looks.emplace_back("cylinder.texture", scene.cylinder->look.texture);
    if (scene.ball) looks.emplace_back("ball.texture", scene.ball->look.texture);
    if (scene.surface) looks.emplace_back("surface.texture", scene.surface->look.texture);
    if (has_look(scene.sky.kind)) looks.emplace_back("sky.kind", sky_look(scene.sky).texture);
    for (const auto& [key, texture] : looks)
        for (const auto& [kind, word] : kinds)
            if (texture == kind) return fmt::format("{} = \"{}\"", key, word);
    return kNot;
}

void ball_of_four(Scene& s) { s.sphere.emplace().radius = 4.0; }

}  // namespace

std::span<const Feature> bodies_features() {
    static const auto features = std::to_array<Feature>({
        {{Effect::kSphere, "sphere", "EFFECT_SPHERE", "A solid sphere about the centre ends rays.",
          "there is a [sphere]", "ray ends, orbit map; some four steps of four fetches where it is seen"},
         [](const FrameFacts& f) -> Reason {
             return !f.scene.sphere ? kNot : Reason(fmt::format("[sphere] of radius {}", f.scene.sphere->radius));
         },
         [](Scene& s) { s.sphere.reset(); },
         nothing,
         ball_of_four},
        {{Effect::kCylinder, "cylinder", "EFFECT_CYLINDER", "A solid disc of finite thickness ends rays.",
          "there is a [cylinder]", "ray ends, orbit map; steps of four fetches, at most 128"},
         [](const FrameFacts& f) -> Reason {
             const auto& c = f.scene.cylinder;
             if (!c) return kNot;
             return fmt::format("[cylinder] from {} to {}, |z| up to {}", c->inner, c->outer, c->height);
         },
         [](Scene& s) { s.cylinder.reset(); },
         nothing,
         [](Scene& s) { s.cylinder.emplace(); }},
        {{Effect::kBall, "ball", "EFFECT_BALL", "A solid sphere anywhere ends rays.", "there is a [ball]",
          "ray ends, orbit map; steps of four fetches, at most 128, shared with other bodies"},
         [](const FrameFacts& f) -> Reason {
             const auto& b = f.scene.ball;
             if (!b) return kNot;
             return fmt::format("[ball] of radius {} at [{}, {}, {}]", b->radius, b->position.x, b->position.y,
                                b->position.z);
         },
         [](Scene& s) { s.ball.reset(); },
         nothing,
         [](Scene& s) { s.ball.emplace(); }},
        {{Effect::kSurface, "surface", "EFFECT_SURFACE", "A solid given by a formula ends rays.",
          "there is a [surface]", "ray ends, orbit map; equal steps of four fetches and seven times the formula"},
         [](const FrameFacts& f) -> Reason {
             const auto& s = f.scene.surface;
             if (!s) return kNot;
             return fmt::format("[surface] {} within {}",
                                s->kind == SurfaceKind::kFormula
                                    ? s->shape
                                    : std::string(kNamedSurfaces[static_cast<std::size_t>(s->kind)].key),
                                s->bound);
         },
         [](Scene& s) { s.surface.reset(); },
         nothing,
         [](Scene& s) { s.surface.emplace(); }},
        {{Effect::kPattern, "pattern", "EFFECT_PATTERN",
          "A body, the disc or the sky has a checker, a grid of coordinates or stripes.",
          "a texture or sky.kind is checker, grid or stripes", "arithmetic where it is seen"},
         [](const FrameFacts& f) -> Reason {
             return texture_among(f.scene, {{TextureKind::kChecker, "checker"},
                                            {TextureKind::kGrid, "grid"},
                                            {TextureKind::kStripes, "stripes"}});
         },
         [](Scene& s) {
             make_all_plain(s, {TextureKind::kChecker, TextureKind::kGrid, TextureKind::kStripes});
         },
         ball_of_four,
         [](Scene& s) { s.sphere->look.texture = TextureKind::kChecker; }},
        {{Effect::kNoise, "noise", "EFFECT_NOISE", "A body, the disc or the sky has noise on it.",
          "a texture or sky.kind is noise", "eight hashes an octave, four octaves, where it is seen"},
         [](const FrameFacts& f) -> Reason {
             return texture_among(f.scene, {{TextureKind::kNoise, "noise"}});
         },
         [](Scene& s) { make_all_plain(s, {TextureKind::kNoise}); },
         ball_of_four,
         [](Scene& s) { s.sphere->look.texture = TextureKind::kNoise; }},
        {{Effect::kFormula, "formula", "EFFECT_FORMULA", "A formula of the scene file is part of the shader.",
          "a texture or sky.kind is a formula", "four times the formula where it is seen"},
         [](const FrameFacts& f) -> Reason {
             return texture_among(f.scene, {{TextureKind::kFormula, "formula"}});
         },
         [](Scene& s) { make_all_plain(s, {TextureKind::kFormula}); },
         ball_of_four,
         [](Scene& s) {
             s.sphere->look.texture = TextureKind::kFormula;
             s.sphere->look.formula = "0.5 + 0.5 * sin(40 * u) * sin(20 * v)";
         }},
        {{Effect::kBodyImage, "body-image", "EFFECT_BODY_IMAGE", "A body has an image on it.",
          "a body's texture is an image", "a picture with mip levels; one fetch where the body is seen"},
         [](const FrameFacts& f) -> Reason {
             return texture_among(f.scene, {{TextureKind::kImage, "image"}});
         },
         [](Scene& s) { make_bodies_plain(s, {TextureKind::kImage}); },
         ball_of_four,
         [](Scene& s) {
             s.sphere->look.texture = TextureKind::kImage;
             s.sphere->look.image = example_image();
         }},
        {{Effect::kBallPath, "ball-path", "EFFECT_BALL_PATH", "The ball moves.", "ball.motion is not \"still\"",
          "the ball's way; two fetches a step"},
         [](const FrameFacts& f) -> Reason {
             return !f.scene.ball || f.scene.ball->motion == BallMotion::kStill ? kNot : Reason("ball.motion");
         },
         [](Scene& s) {
             if (s.ball) s.ball->motion = BallMotion::kStill;
         },
         [](Scene& s) {
             s.ball.emplace().position = {-6, 0, 0}, s.spacetime.metric = "schwarzschild", s.light.delay = false;
         },
         [](Scene& s) { s.ball->motion = BallMotion::kOrbit; }},
        {{Effect::kPulse, "pulse", "EFFECT_PULSE", "The sphere pulsates.", "sphere.swing is above 0",
          "steps of four fetches"},
         [](const FrameFacts& f) -> Reason {
             return !f.scene.sphere || !(f.scene.sphere->swing > 0.0)
                        ? kNot
                        : Reason(fmt::format("sphere.swing = {}", f.scene.sphere->swing));
         },
         [](Scene& s) {
             if (s.sphere) s.sphere->swing = 0.0;
         },
         [](Scene& s) { ball_of_four(s), s.light.delay = false; },
         [](Scene& s) { s.sphere->swing = 0.1; }},
    });
    return features;
}

}  // namespace nullscope
