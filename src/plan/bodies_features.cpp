// Features of solid bodies, and what they are painted with.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "plan/body_kind.h"
#include "plan/feature.h"

namespace nullscope {
namespace {

using Kinds = std::initializer_list<TextureKind>;

bool is_among(Kinds kinds, TextureKind kind) { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); }

void make_plain(Material& material, Kinds kinds) {
    if (is_among(kinds, material.texture)) material.texture = TextureKind::kPlain;
}

void make_bodies_plain(Scene& scene, Kinds kinds) {
    for (Body& body : scene.bodies) make_plain(body.material, kinds);
}

void make_all_plain(Scene& scene, Kinds kinds) {
    make_bodies_plain(scene, kinds);
    if (scene.disc) make_plain(scene.disc->material, kinds);
    if (is_procedural(scene.sky.kind) && is_among(kinds, sky_material(scene.sky).texture))
        scene.sky.kind = SkyKind::kPlain;
}

// The first thing that is painted in one of these ways.
Reason texture_among(const Scene& scene, Kinds kinds) {
    std::vector<std::pair<std::string, TextureKind>> textures;
    if (scene.disc && scene.disc->material.texture < TextureKind::kImage)
        textures.emplace_back("disc.texture", scene.disc->material.texture);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        textures.emplace_back(body_section(scene, i) + ".texture", scene.bodies[i].material.texture);
    if (is_procedural(scene.sky.kind)) textures.emplace_back("sky.kind", sky_material(scene.sky).texture);
    for (const auto& [key, texture] : textures)
        if (is_among(kinds, texture)) return fmt::format("{} = \"{}\"", key, texture_name(texture));
    return kNot;
}

// Bodies of a kind, as a plan names them: the first, and how many more there are.
template <class Shape>
Reason bodies_of(const FrameFacts& f) {
    const Body* first = first_body<Shape>(f.scene);
    if (first == nullptr) return kNot;
    const auto more = std::count_if(f.scene.bodies.begin(), f.scene.bodies.end(), has_shape<Shape>) - 1;
    const BodyKind& kind = kind_of(*first);
    return fmt::format("[{}] {}{}", kind.key, kind.words(*first), more > 0 ? fmt::format(" and {} more", more) : "");
}

// The effect of a kind of bodies.
template <class Shape>
Feature body_feature(const BodyKind& kind) {
    return {kind.effect, bodies_of<Shape>, [](Scene& s) { remove_bodies<Shape>(s); }, nothing,
            [](Scene& s) { add<Shape>(s); }};
}

std::vector<Feature> with_kinds(std::vector<Feature> features) {
    for_each_kind([&]<class Shape>(const BodyKind& kind) { features.push_back(body_feature<Shape>(kind)); });
    return features;
}

void sphere_of_four(Scene& s) { add_body(s, SphereSpec{.radius = 4.0}); }
Material& first_material(Scene& s) { return s.bodies.front().material; }

// What features of textures do, as functions of a scene.
template <TextureKind... kinds>
Reason painted(const FrameFacts& f) {
    return texture_among(f.scene, {kinds...});
}
template <TextureKind... kinds>
void without_texture(Scene& s) {
    make_all_plain(s, {kinds...});
}
template <TextureKind kind>
void paint_first(Scene& s) {
    first_material(s).texture = kind;
}

Feature glow_feature() {
    return {{Effect::kGlow, "glow", "EFFECT_GLOW", "A body shines by its heat, and g acts on its light.",
             "a body has a temperature", "its motion and one logarithm or two where it is seen"},
            [](const FrameFacts& f) -> Reason {
                for (std::size_t i = 0; i < f.scene.bodies.size(); ++i)
                    if (const auto& kelvin = f.scene.bodies[i].material.temperature_K)
                        return fmt::format("{}.temperature = {}", body_section(f.scene, i), *kelvin);
                return kNot;
            },
            [](Scene& s) {
                for (Body& body : s.bodies) body.material.temperature_K.reset();
            },
            sphere_of_four,
            [](Scene& s) { first_material(s).temperature_K = 6000.0; }};
}

Feature turn_feature() {
    return {{Effect::kSphereTurn, "sphere-turn", "EFFECT_SPHERE_TURN", "A sphere turns about the polar axis.",
             "sphere.spin_rate is not 0", "an angle where it is seen"},
            [](const FrameFacts& f) -> Reason {
                const Body* body = seen_sphere(f.scene);
                const double rate = body != nullptr ? std::get<SphereSpec>(body->shape).spin_rate : 0.0;
                return reason_if(rate != 0.0, fmt::format("sphere.spin_rate = {}", rate));
            },
            [](Scene& s) {
                for (Body& body : s.bodies)
                    if (auto* sphere = std::get_if<SphereSpec>(&body.shape)) sphere->spin_rate = 0.0;
            },
            [](Scene& s) { sphere_of_four(s), s.light.delay = false; },
            [](Scene& s) { first_shape<SphereSpec>(s)->spin_rate = 0.1; }};
}

std::vector<SceneKey> cap_keys() {
    return {
        {"cap", "colatitude", KeyType::kNumber, "deg", "45", closed(0.0, 180.0), "",
         "Angle of its middle from the north pole.", [](auto& s) { return &s.caps.back().colatitude; }},
        {"cap", "azimuth", KeyType::kNumber, "deg", "0", kAnyAngle, "", "Azimuth of its middle at time 0.",
         [](auto& s) { return &s.caps.back().azimuth; }},
        {"cap", "radius", KeyType::kNumber, "deg", "15", KeyRange{0.0, 180.0, true, false}, "",
         "Angle from its middle to its rim, as seen from the sphere's middle.",
         [](auto& s) { return &s.caps.back().radius; }},
        {"cap", "temperature", KeyType::kNumber, "K", "20000", closed(1e3, 1e9), "",
         "It shines as a black body of this temperature, as much brighter than the sphere as Planck's law says.",
         [](auto& s) { return &s.caps.back().temperature_K; }},
        {"cap", "brightness", KeyType::kNumber, "", "1", kBrightness, "", "Multiplies its light.",
         [](auto& s) { return &s.caps.back().brightness; }},
        {"cap", "colour", KeyType::kColour, "", "[1, 1, 1]", closed(0.0, 1000.0), "",
         "Its light is multiplied by this, linear red, green and blue.", [](auto& s) { return &s.caps.back().colour; }},
    };
}

Feature cap_feature() {
    return {{Effect::kCaps, "caps", "EFFECT_CAPS", "There are hot caps on a sphere.",
             "there is a [cap] and a [sphere] with a temperature", "a distance and a logarithm a cap where it is seen"},
            [](const FrameFacts& f) -> Reason {
                const Body* body = seen_sphere(f.scene);
                if (f.scene.caps.empty() || body == nullptr || !body->material.temperature_K) return kNot;
                return fmt::format("[cap] of {:.3g} degrees", 180.0 / M_PI * f.scene.caps.front().radius);
            },
            [](Scene& s) { s.caps.clear(); },
            [](Scene& s) { sphere_of_four(s), first_material(s).temperature_K = 6000.0; },
            [](Scene& s) { s.caps.emplace_back(); },
            nullptr,
            cap_keys()};
}

}  // namespace

std::span<const Feature> bodies_features() {
    static const auto features = with_kinds({
        {{Effect::kPattern, "pattern", "EFFECT_PATTERN",
          "A body, the disc or the sky has a checker, a grid of coordinates or stripes.",
          "a texture or sky.kind is checker, grid or stripes", "arithmetic where it is seen"},
         painted<TextureKind::kChecker, TextureKind::kGrid, TextureKind::kStripes>,
         without_texture<TextureKind::kChecker, TextureKind::kGrid, TextureKind::kStripes>,
         sphere_of_four,
         paint_first<TextureKind::kChecker>},
        {{Effect::kNoise, "noise", "EFFECT_NOISE", "A body, the disc or the sky has noise on it.",
          "a texture or sky.kind is noise", "eight hashes an octave, four octaves, where it is seen"},
         painted<TextureKind::kNoise>,
         without_texture<TextureKind::kNoise>,
         sphere_of_four,
         paint_first<TextureKind::kNoise>},
        {{Effect::kFormula, "formula", "EFFECT_FORMULA", "A formula of the scene file is part of the shader.",
          "a texture or sky.kind is a formula", "four times the formula where it is seen"},
         painted<TextureKind::kFormula>,
         without_texture<TextureKind::kFormula>,
         sphere_of_four,
         [](Scene& s) {
             paint_first<TextureKind::kFormula>(s);
             first_material(s).formula = "0.5 + 0.5 * sin(40 * u) * sin(20 * v)";
         }},
        {{Effect::kBodyImage, "body-image", "EFFECT_BODY_IMAGE", "A body has an image on it.",
          "a body's texture is an image", "a picture with mip levels; one fetch where the body is seen"},
         painted<TextureKind::kImage>,
         [](Scene& s) { make_bodies_plain(s, {TextureKind::kImage}); },
         sphere_of_four,
         [](Scene& s) {
             paint_first<TextureKind::kImage>(s);
             first_material(s).image = example_image();
         }},
        glow_feature(),
        turn_feature(),
        cap_feature(),
        {{Effect::kBallPath, "ball-path", "EFFECT_BALL_PATH", "A ball moves.", "ball.motion is not \"still\"",
          "a table of the ball's path; two fetches a step"},
         [](const FrameFacts& f) -> Reason {
             for (std::size_t i = 0; i < f.scene.bodies.size(); ++i)
                 if (const auto* ball = std::get_if<BallSpec>(&f.scene.bodies[i].shape); ball && ball->moves())
                     return body_section(f.scene, i) + ".motion";
             return kNot;
         },
         [](Scene& s) {
             for (Body& body : s.bodies)
                 if (auto* ball = std::get_if<BallSpec>(&body.shape)) ball->motion = BallMotion::kStill;
         },
         [](Scene& s) {
             add<BallSpec>(s).position = {-6, 0, 0}, s.spacetime.metric = "schwarzschild", s.light.delay = false;
         },
         [](Scene& s) { first_shape<BallSpec>(s)->motion = BallMotion::kOrbit; }},
        {{Effect::kPulse, "pulse", "EFFECT_PULSE", "A sphere pulsates.", "sphere.amplitude is above 0",
          "steps of four fetches"},
         [](const FrameFacts& f) -> Reason {
             for (std::size_t i = 0; i < f.scene.bodies.size(); ++i)
                 if (const auto* sphere = std::get_if<SphereSpec>(&f.scene.bodies[i].shape);
                     sphere && sphere->amplitude > 0)
                     return fmt::format("{}.amplitude = {}", body_section(f.scene, i), sphere->amplitude);
             return kNot;
         },
         [](Scene& s) {
             for (Body& body : s.bodies)
                 if (auto* sphere = std::get_if<SphereSpec>(&body.shape)) sphere->amplitude = 0.0;
         },
         [](Scene& s) { sphere_of_four(s), s.light.delay = false; },
         [](Scene& s) { first_shape<SphereSpec>(s)->amplitude = 0.1; }},
    });
    return features;
}

}  // namespace nullscope
