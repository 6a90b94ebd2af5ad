// The solid bodies of a scene by kind, and what each is called.
#pragma once
#include <algorithm>
#include <string>
#include <utility>

#include "scene/scene.h"

namespace nullscope {

template <class Shape>
bool has_shape(const Body& body) {
    return std::holds_alternative<Shape>(body.shape);
}

// The first body of a kind; nullptr where there is none.
template <class Shape>
auto* first_body(auto& scene) {
    const auto found = std::find_if(scene.bodies.begin(), scene.bodies.end(), has_shape<Shape>);
    return found != scene.bodies.end() ? &*found : nullptr;
}
template <class Shape>
auto* first_shape(auto& scene) {
    auto* body = first_body<Shape>(scene);
    return body != nullptr ? &std::get<Shape>(body->shape) : nullptr;
}

template <class Shape>
Body& add_body(Scene& scene, Shape shape = {}) {
    return scene.bodies.emplace_back(Body{.shape = std::move(shape)});
}
template <class Shape>
Shape& add(Scene& scene, Shape shape = {}) {
    return std::get<Shape>(add_body<Shape>(scene, std::move(shape)).shape);
}
template <class Shape>
void remove_bodies(Scene& scene) {
    std::erase_if(scene.bodies, has_shape<Shape>);
}

// The still sphere that hides all others: the largest, of equal ones the first. nullptr: there is none.
const Body* seen_sphere(const Scene& scene);

// What files and messages call section number i of those with one name, from 0: "spot", the second "spot[2]".
std::string section_label(std::string_view section, std::size_t i);
// Where body number i of the scene stands in a file: "ball", the second ball "ball[2]".
std::string body_section(const Scene& scene, std::size_t i);
// Its name in ray data; of one without a name "ball", the second ball "ball-2".
std::string body_name(const Scene& scene, std::size_t i);

// Its number in ray data: 2 for a sphere, 3 a cylinder, 4 a ball, 5 a surface, and 8 more for each body of that kind before it.
int object_number(const Scene& scene, std::size_t i);
// What a number of ray data stands for: "disc", "star", body_name(); empty for 0.
std::string object_name(const Scene& scene, int number);

}  // namespace nullscope
