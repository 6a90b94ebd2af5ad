#include "studio/hidden_bodies.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "plan/body_kind.h"

namespace nullscope::viewer {

namespace {

std::map<std::string, std::vector<const Body*>> bodies_by_kind(const Scene& scene) {
    std::map<std::string, std::vector<const Body*>> bodies;
    for (const Body& body : scene.bodies) bodies[std::string(kind_of(body).key)].push_back(&body);
    return bodies;
}

}  // namespace

bool HiddenBodies::is_body(const SectionRef& at) {
    return std::ranges::any_of(body_kinds(), [&](const BodyKind* kind) { return kind->key == at.section; });
}

void HiddenBodies::toggle(const SectionRef& at) {
    if (hidden_.erase({at.section, at.index}) == 0) hidden_.emplace(at.section, at.index);
}

void HiddenBodies::removed(const SectionRef& at) {
    hidden_.erase({at.section, at.index});
    shift_behind(at, -1);
}

void HiddenBodies::copied(const SectionRef& at) { shift_behind(at, 1); }

void HiddenBodies::shift_behind(const SectionRef& at, int by) {
    std::set<std::pair<std::string, std::size_t>> shifted;
    for (const auto& [kind, number] : hidden_)
        shifted.emplace(kind, number + static_cast<std::size_t>(kind == at.section && number > at.index ? by : 0));
    hidden_ = std::move(shifted);
}

void HiddenBodies::leave_out(Scene& scene) const { leave_out_of(scene, scene); }

void HiddenBodies::leave_out_of(Scene& other, const Scene& scene) const {
    if (hidden_.empty()) return;
    const auto these = bodies_by_kind(scene), those = bodies_by_kind(other);
    std::vector<Body> shown;
    std::map<std::string, std::size_t> seen;  // bodies of each kind
    for (const Body& body : other.bodies) {
        const std::string kind(kind_of(body).key);
        const std::size_t number = seen[kind]++;
        const auto same_kind = these.find(kind);
        const bool numbered = same_kind != these.end() && same_kind->second.size() == those.at(kind).size();
        const auto equal = [&](const auto& hidden) {
            return hidden.first == kind && same_kind != these.end() && hidden.second < same_kind->second.size() &&
                   *same_kind->second[hidden.second] == body;
        };
        if (!(numbered ? hidden_.contains({kind, number}) : std::ranges::any_of(hidden_, equal))) shown.push_back(body);
    }
    other.bodies = std::move(shown);
}

}  // namespace nullscope::viewer
