// The cases of cases.csv.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace nullscope::test {

struct GoldenCase {
    std::string scene, name;  // as in the file; and what the golden picture is called
    int width = 0, height = 0;
    std::string contexts;
    double rays_px = 0, mean = 0, above = 0, fraction = 0;
    std::string reason;
};

std::filesystem::path golden_folder();

// Errors: file, line and what is wrong.
Result<std::vector<GoldenCase>> read_golden_cases(const std::filesystem::path& file);

// The scene at the case's size.
Result<Scene> golden_scene(const GoldenCase& golden);

}  // namespace nullscope::test
