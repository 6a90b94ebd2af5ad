// The shader's text for what a scene has several of: solid bodies and hot spots; for what bodies, disc and sky are painted with; and for matter by formula. It
// depends on more than which effects are on: kinds of texture, formulas, how many there are.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "plan/effects.h"
#include "scene/scene.h"

namespace nullscope {

inline constexpr int kBallPathAhead = 64;  // cells of a ball's path, for which a node knows the largest acceleration

// What generated/objects, surfaces, bodies_march, bodies_hit, bodies_light, bodies_shift, materials, medium_matter and medium_law stand for where a shader includes them.
// Compared as a whole: two scenes with equal texts and equal effects have one program.
struct BodyText {
    std::string objects;    // OBJECT_VECTORS and where in them what begins
    std::string surfaces;   // surface_value, ...: the solids that are given by formulas
    std::string march;      // march_ask, march_nearest, march_object, MARCH_MOST_STEPS
    std::string hit;        // solid_hit: the first body on the ray; about a rotating hole the tracer finds it
    std::string light;      // solid_light: and its light
    std::string shift;      // solid_g: of bodies with a temperature how the frequencies of their light arrive
    std::string materials;  // disc_material_pattern, sky_pattern: what a disc and a sky without images are painted with
    std::string medium;     // medium_matter: names of its numbers, and what is by formula
    std::string law;        // medium_law: the file of its emission law
    bool law_by_place = false;                                            // which asks for temperature or field
    friend auto operator<=>(const BodyText&, const BodyText&) = default;  // NOLINT(modernize-use-nullptr): no pointer
};

// effects: what the scene calls for. Empty for a scene without bodies and spots whose disc and sky are not painted. Formulas must be valid
// (scene files are checked).
BodyText body_text(const Scene& scene, const EffectSet& effects);

// The bodies in the shader's order, as indices of Scene::bodies: those whose text is the same are next to each other. Still spheres within
// another are left out: they are never seen.
std::vector<std::size_t> shader_bodies(const Scene& scene);
// The number that SolidHit of the shader gives the first of these; above the numbers of all else that rays hit (scene/ray.h).
inline constexpr int kFirstBody = 8;

// The images on bodies, each once: shaders know number k as body_image_k. A scene may have kMostBodyImages.
inline constexpr int kMostBodyImages = 4;
std::vector<ImageSource> body_images(const Scene& scene);

}  // namespace nullscope
