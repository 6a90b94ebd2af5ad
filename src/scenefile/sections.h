// The sections of a scene file: the one table that reader, writer, checks and editors follow. A section is added by one row of sections.cpp
// (CONTRIBUTING.md); a kind of body has its own (plan/body_kind.h).
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "scene/scene_key.h"

namespace nullscope {

// What a scene may have several of, [[spot]]. Sections may share one list, in the file's order: bodies. place: in that list.
struct SectionList {
    std::size_t most = 0;
    std::string_view words = {};  // of messages: "bodies"
    std::size_t (*size)(const Scene&) = nullptr;
    void (*erase)(Scene&, std::size_t place) = nullptr;
    void (*repeat)(Scene&, std::size_t place) = nullptr;  // a second one right behind it
    void (*exchange)(Scene&, std::size_t place, std::size_t other) = nullptr;
    Scene (*alone)(const Scene&, std::size_t place) = nullptr;  // a scene that has only this one
};

// The spacetime of a section that names one. Made from [](auto& s) { return &s.spacetime; }.
class SpacetimePart {
public:
    constexpr SpacetimePart() = default;
    template <class F>
    requires std::is_pointer_v<std::invoke_result_t<F, Scene&>>
    constexpr SpacetimePart(F)  // NOLINT: implicit on purpose
        : read_([](const Scene& s) -> const SpacetimeSpec& { return *F{}(s); }),
          write_([](Scene& s) -> SpacetimeSpec& { return *F{}(s); }) {}
    explicit operator bool() const { return read_ != nullptr; }
    const SpacetimeSpec& of(const Scene& scene) const { return read_(scene); }
    SpacetimeSpec& of(Scene& scene) const { return write_(scene); }

private:
    const SpacetimeSpec& (*read_)(const Scene&) = nullptr;
    SpacetimeSpec& (*write_)(Scene&) = nullptr;
};

struct Section {
    std::string_view name;                  // "" for the top level
    std::string_view help = {};             // one sentence, where a scene may do without it
    std::function<void(Scene&)> add = {};   // one more, as where a file says nothing of it; empty: it is always there
    bool (*there)(const Scene&) = nullptr;  // of one that a scene has or has not
    void (*remove)(Scene&) = nullptr;
    const SectionList* list = nullptr;  // of one that a scene has several of, with what of the list is this section's
    std::function<bool(const Scene&, std::size_t place)> is = {};
    void (*propose)(Scene&) = nullptr;  // changes what add() gives, where an editor offers something else
    SpacetimePart spacetime = {};       // whose parameters and formulas are keys too
    std::string_view first = {};        // the key that decides what the others mean or are: it is read first
    std::string_view within = {};  // the section that may hold it as an inline table: camera = { zoom = { depth = 3 } }
    std::string_view inner = {};   // [[path.key]]: sections in it, read once the others are
    std::span<const SceneKey> keys =
        {};  // rows of the key table that stand neither there nor with a Feature or a kind of body
    bool optional() const { return add != nullptr; }
};

std::span<const Section> sections();  // in the order of written files
const Section* find_section(std::string_view name);
std::span<const SceneKey> keys_of(std::string_view section);  // the rows of the key table, in its order

// Of a scene: how many it has, and where in Section::list each of them is.
std::size_t count_of(const Scene& scene, const Section& section);
std::vector<std::size_t> places_of(const Scene& scene, const Section& section);

// f(section, label, scene) for each section that is there, with a scene that has it last of its kind. label: as a file and its messages call
// it, "ball[2]".
void for_each_section(const Scene& scene,
                      const std::function<void(const Section&, const std::string& label, const Scene& holder)>& f);

}  // namespace nullscope
