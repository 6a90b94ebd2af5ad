// Scene files: whatever the text, a scene within its ranges or one line that says what is wrong.
#include <cmath>

#include "fuzz.h"
#include "plan/effects.h"
#include "scenefile/scene_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    const auto scene = parse_scene(fuzz::text_of(data, size), "scene.toml", "/nowhere");
    if (!scene) {
        fuzz::must_be_a_good_error(scene.error());
        fuzz::must(scene.error().message().starts_with("scene.toml:"), "the file is named");
        return 0;
    }
    const CameraSpec& camera = scene->camera;
    fuzz::must(camera.width > 0 && camera.height > 0, "the picture has a size");
    fuzz::must(std::isfinite(camera.plane_width / camera.focal_distance), "the field of view is finite");
    fuzz::must(length(camera.velocity) < 1.0, "the camera is slower than light");
    fuzz::must(!scene->disc || scene->disc->inner < scene->disc->outer, "the disc has a width");
    fuzz::must(required_effects(*scene).size() <= kEffectCount, "no effect is called for twice");
    return 0;
}
