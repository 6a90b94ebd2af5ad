#include "viewer/hidden_bodies.h"

#include <algorithm>
#include <map>

#include "plan/body_kind.h"

namespace nullscope::viewer {

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
    for (const auto& [section, number] : hidden_)
        shifted.emplace(section,
                        number + static_cast<std::size_t>(section == at.section && number > at.index ? by : 0));
    hidden_ = std::move(shifted);
}

void HiddenBodies::leave_out(Scene& scene) const {
    if (hidden_.empty()) return;
    std::map<std::string, std::size_t> seen;  // bodies of each kind
    std::erase_if(scene.bodies, [&](const Body& body) {
        const std::string kind(kind_of(body).key);
        return hidden_.contains({kind, seen[kind]++});
    });
}

}  // namespace nullscope::viewer
