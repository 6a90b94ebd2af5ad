// Bodies of the scene that are not drawn, by kind and number within the kind, as the sections of a file. Edits of a scene keep the order
// within a kind. Pure: no window, no OpenGL.
#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "scenefile/scene_edit.h"

namespace nullscope::viewer {

class HiddenBodies {
public:
    static bool is_body(const SectionRef& at);  // not a spot, nor the disc
    bool has(const SectionRef& at) const { return hidden_.contains({at.section, at.index}); }
    void toggle(const SectionRef& at);
    void clear() { hidden_.clear(); }

    // The scene has changed: without_section(), with_copy(). The copy is shown.
    void removed(const SectionRef& at);
    void copied(const SectionRef& at);

    void leave_out(Scene& scene) const;
    // Of another scene whose bodies were the same once: what has the number of a hidden one of `scene`, as long as there are as many of its
    // kind, else what equals one.
    void leave_out_of(Scene& other, const Scene& scene) const;

private:
    void shift_behind(const SectionRef& at, int by);
    std::set<std::pair<std::string, std::size_t>> hidden_;
};

}  // namespace nullscope::viewer
