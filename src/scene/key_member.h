// Inside scene: the value of a key, and the member of a Scene that it stands in, to be read and written by one row of the key table.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "scene/scene.h"

namespace nullscope {

// A checked value, in the units of Scene.
struct KeyValue {
    double number = 0;
    Vec3 vector{};
    std::vector<double> numbers{};
    int width = 0, height = 0;  // kSize; kWhole: width
    int choice = 0;             // index in SceneKey::choices
    std::string text{};
    std::filesystem::path path{};  // resolved against the scene file's folder
    bool there = true;             // false: of an optional member that has no value
};

// What a member's type is in a KeyValue: of enumerations the number of the word; bool: the second word is true.
template <class T, class Value>
auto& part_of(Value& value) {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>)
        return value.number;
    else if constexpr (std::is_same_v<T, Vec3>)
        return value.vector;
    else if constexpr (std::is_same_v<T, int>)
        return value.width;
    else if constexpr (std::is_same_v<T, std::string>)
        return value.text;
    else if constexpr (std::is_same_v<T, std::filesystem::path>)
        return value.path;
    else
        return value.choice;
}

class KeyMember {
public:
    using Get = KeyValue (*)(const Scene&);
    using Set = void (*)(Scene&, const KeyValue&);
    constexpr KeyMember() = default;
    // reads: nullptr for a key that says the same as others.
    constexpr KeyMember(Get reads, Set writes) : get_(reads), set_(writes) {}
    // [](auto& s) { return &s.camera.r; }, of a scene that has the section.
    template <class F>
    requires std::is_pointer_v<std::invoke_result_t<F, Scene&>>
    constexpr KeyMember(F)  // NOLINT: implicit on purpose
        : get_([](const Scene& scene) {
              const auto& member = *F{}(scene);
              using T = std::decay_t<decltype(member)>;
              KeyValue value;
              if constexpr (std::is_same_v<T, std::optional<double>>)
                  value.number = member.value_or(0.0), value.there = member.has_value();
              else
                  part_of<T>(value) = static_cast<std::decay_t<decltype(part_of<T>(value))>>(member);
              return value;
          }),
          set_([](Scene& scene, const KeyValue& value) {
              auto& member = *F{}(scene);
              using T = std::decay_t<decltype(member)>;
              member = static_cast<T>(part_of<T>(value));
          }) {}

    bool readable() const { return get_ != nullptr; }
    KeyValue get(const Scene& scene) const { return get_(scene); }
    void set(Scene& scene, const KeyValue& value) const { set_(scene, value); }

private:
    Get get_ = nullptr;
    Set set_ = nullptr;
};

}  // namespace nullscope
