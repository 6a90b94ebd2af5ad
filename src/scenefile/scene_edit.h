// Scenes changed key by key, as their files would be: what results is checked as a file is, so that whatever is edited can be saved and opened.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"
#include "scene/scene_key.h"

namespace nullscope {

// A section that a scene has: number `index` of its name, from 0. label: what files and messages call it, "ball[2]"; "" for the top level.
struct SectionRef {
    std::string section;
    std::size_t index = 0;
    std::string label;
};
std::vector<SectionRef> scene_sections(const Scene& scene);
std::string last_label(const Scene& scene, std::string_view section);  // of the last of these, which there must be

// A scene that has this section last of its kind, as the key table's functions want it; and the same where a file says no more of the section
// than words (KeyType::kChoice).
Scene section_holder(const Scene& scene, const SectionRef& at);
void exchange_with_last(Scene& scene,
                        const SectionRef& at);  // makes a scene its holder; once more undoes that. No copy
Scene section_defaults(const Scene& holder, std::string_view section);

// Of KeyType::kNumbers, as a hand types them: "86, 230"; what is no number becomes one that is not finite, which with_value() refuses. take: whether
// they are others than before.
std::string typed_numbers(const std::vector<double>& numbers);
bool take_typed_numbers(const std::string& text, std::vector<double>& numbers);

// The scene with another value of a key. Errors: as a scene file's, without file and line. Cost: 0.5 ms, more where bodies move.
Result<Scene> with_value(const Scene& scene, const SectionRef& at, const SceneKey& key, const KeyValue& value);

// The scene as a file can hold it: checked, and where a camera that was moved rules out the scale bar, without one. Errors: as above.
Result<Scene> savable(const Scene& scene);

// The camera that a line of view_line() says, in this scene's spacetime; the picture's size is the scene's. Errors: as above, and a line
// that is no view.
Result<CameraSpec> camera_of_view(const std::string& line, const Scene& scene);

// Sections that a scene may do without (Section::optional), by name, and whether one more can be added: of what there is once, if it is not
// there. Errors: as above.
std::vector<std::string> optional_sections();
bool is_of_several(std::string_view section);
bool can_be_added(const Scene& scene, std::string_view section);
Result<Scene> with_section(const Scene& scene, std::string_view section);
Result<Scene> with_copy(const Scene& scene, const SectionRef& at);  // of several: a second one right behind it
Result<Scene> without_section(const Scene& scene, const SectionRef& at);

}  // namespace nullscope
