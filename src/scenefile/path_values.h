// Numbers of a scene that change along its path ([[path.key]] set = { "spacetime.spin" = 0.5 }): read, set and written by their names.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"
#include "scene/scene_fault.h"
#include "scene/scene_key.h"

namespace nullscope {

// "disc.outer", "spacetime.spin", "ball[2].radius": a number of a section that the scene has, but none of [camera], [zoom] and [path].
struct PathValue {
    SceneKey key;            // its row; of a metric's parameter its range
    std::string section;     // that it is in
    std::size_t place = 0;   // of several sections of that kind
    bool of_metric = false;  // a parameter of the section's metric
};
// Errors, without file and line: no such section or key, no number.
Result<PathValue> path_value(const Scene& scene, const std::string& name);

// In Scene's units. Nothing: the scene has no value there.
std::optional<double> number_of(const Scene& scene, const PathValue& value);
void set_number(Scene& scene, const PathValue& value, double number);

// The scene as its path has it in a frame: values as CameraPath::values() gives them, of scene.path->keyed.
void set_path_values(Scene& scene, const std::vector<double>& values);
// Those of the scene itself, in the same order.
std::vector<double> path_values_of(const Scene& scene);

// What is wrong with a closed path, and the frames of keys where none are given: up to the last; of a closed path as far beyond it as that is beyond
// the one before. Two keys or more.
std::vector<SceneFault> closed_faults(const PathSpec& path);
int frames_of_keys(const PathSpec& path);

// What does not go together in a frame between the keys, where each value is within its range.
struct PathFault {
    double frame;
    std::string key, what, allowed;
};
// All frames of a path, at most a thousand of them evenly. Cost: a check of the scene for each.
std::optional<PathFault> path_fault(const Scene& scene);

}  // namespace nullscope
