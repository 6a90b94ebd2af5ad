#include "scene/bodies.h"

#include <fmt/format.h>

#include "scene/ray.h"

namespace nullscope {
namespace {

constexpr int kNumbersApart = 8;  // above the numbers of all that there is once (scene/ray.h)

std::string_view kind_name(const Body& body) {
    return std::visit([](const auto& shape) { return shape.kName; }, body.shape);
}

std::size_t ordinal(const Scene& scene, std::size_t i) {  // among those of its kind, from 0
    std::size_t before = 0;
    for (std::size_t k = 0; k < i; ++k) before += scene.bodies[k].shape.index() == scene.bodies[i].shape.index();
    return before;
}

}  // namespace

const Body* seen_sphere(const Scene& scene) {
    const Body* seen = nullptr;
    double most = 0.0;
    for (const Body& body : scene.bodies)
        if (const auto* sphere = std::get_if<SphereSpec>(&body.shape);
            sphere != nullptr && !(sphere->amplitude > 0.0) && sphere->radius > most)
            seen = &body, most = sphere->radius;
    return seen;
}

std::string section_label(std::string_view section, std::size_t i) {
    return i == 0 ? std::string(section) : fmt::format("{}[{}]", section, i + 1);
}

std::string body_section(const Scene& scene, std::size_t i) {
    return section_label(kind_name(scene.bodies[i]), ordinal(scene, i));
}

std::string body_name(const Scene& scene, std::size_t i) {
    if (!scene.bodies[i].name.empty()) return scene.bodies[i].name;
    const std::size_t number = ordinal(scene, i);
    const std::string_view kind = kind_name(scene.bodies[i]);
    return number == 0 ? std::string(kind) : fmt::format("{}-{}", kind, number + 1);
}

int object_number(const Scene& scene, std::size_t i) {
    const int kind = kSphereHit + static_cast<int>(scene.bodies[i].shape.index());
    return kind + (kind >= kStarHit ? 1 : 0) + kNumbersApart * static_cast<int>(ordinal(scene, i));
}

std::string object_name(const Scene& scene, int number) {
    if (number == kDiscHit) return "disc";
    if (number == kStarHit) return "star";
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (object_number(scene, i) == number) return body_name(scene, i);
    return "";
}

}  // namespace nullscope
