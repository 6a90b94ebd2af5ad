// The kinds of solid bodies: what the host says of each in one place, a file a kind (sphere.cpp, cylinder.cpp, ball.cpp, surface.cpp). A
// kind is added by a struct in scene.h, its file and its lines here (CONTRIBUTING.md); what of it runs on the GPU is in shaders/object.
#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plan/effects.h"
#include "scene/bodies.h"
#include "scene/scene.h"
#include "scene/scene_fault.h"
#include "scene/scene_key.h"

namespace nullscope {

// Where a body is checked.
struct BodyCheck {
    const Scene& scene;
    double horizon;                          // radius, 0 if there is none
    std::function<void(SceneFault)> report;  // key: of the body
    Vec3 camera() const;                     // where it is, on its own side of a wormhole
    bool camera_is_there(bool far) const { return (scene.camera.r < 0.0) == far; }
};

// Adds what is wrong with a material that is a checker which does not close round about.
void check_checker(const Material& material, const std::string& section, std::vector<SceneFault>& faults);
// What of a scene's bodies does not fit together. horizon: radius, 0 if there is none.
std::vector<SceneFault> check_bodies(const Scene& scene, double horizon);

// Radii about the centre between which a body lies, and its least extent: what is looked for in steps is looked for in parts of that.
struct BodyExtent {
    double from, to, thinnest;
    double height = 1e30;  // the largest distance from the plane theta = pi/2
};

struct BodyKind {
    std::string_view key;             // its section, and what the functions and the file of shaders/object are named by
    EffectRow effect;                 // that there is one
    Body (*make)();                   // as it is where a file says nothing
    std::vector<SceneKey> (*keys)();  // of its form; they apply to the last of the kind
    void (*check)(const Body&, const BodyCheck&);
    std::string (*words)(const Body&);         // of a plan: "of radius 3"
    BodyExtent (*extent)(const Body&);         // of one that rests
    double (*size)(const Body&);               // the length that grains of its noise are counted over
    const char* (*moves)(const Body&);         // the key by which it depends on time; nullptr: none
    bool has_side = true, has_mapping = true;  // keys side; mapping and band_latitude
};

extern const BodyKind kSphereKind, kCylinderKind, kBallKind, kSurfaceKind;
inline std::array<const BodyKind*, std::variant_size_v<BodyShape>> body_kinds() {  // in the order of BodyShape
    return {&kSphereKind, &kCylinderKind, &kBallKind, &kSurfaceKind};
}
// f.operator()<Shape>(kind) for each.
template <class F>
void for_each_kind(const F& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (f.template operator()<std::variant_alternative_t<I, BodyShape>>(*body_kinds()[I]), ...);
    }
    (std::make_index_sequence<std::variant_size_v<BodyShape>>{});
}
inline const BodyKind& kind_of(const Body& body) { return *body_kinds()[body.shape.index()]; }

// For the rows of `keys`: the last body of a kind, which there must be, and its shape.
template <class Shape>
auto& last_of(auto& scene) {
    return *std::find_if(scene.bodies.rbegin(), scene.bodies.rend(), has_shape<Shape>);
}
template <class Shape>
auto& last_body(auto& scene) {
    return std::get<Shape>(last_of<Shape>(scene).shape);
}

}  // namespace nullscope
