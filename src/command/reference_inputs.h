// What a scene shows, loaded for the reference: skies and images.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "reference/reference.h"
#include "scene/scene.h"

namespace nullscope::cli {

struct ReferenceInputs {
    SkyCube sky;
    std::optional<SkyCube> far_sky;
    std::optional<Image<float>> disc;
    std::map<ImageSource, Image<float>> bodies;
    std::vector<std::string> notes;  // what was done to files, and what of them is not used: a line each

    const SkyCube* far() const { return far_sky ? &*far_sky : nullptr; }
    reference::Pictures pictures(const Scene& scene) const;
};

// Errors: files that are missing or broken.
Result<std::unique_ptr<const ReferenceInputs>> load_reference_inputs(const Scene& scene);

}  // namespace nullscope::cli
