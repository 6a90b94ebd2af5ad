#include "scenefile/emissivity_check.h"

#include <fmt/format.h>

#include "scene/disc_emissivity.h"
#include "scene/leaning_disc.h"

namespace nullscope {
namespace {

std::vector<SceneFault> lamp_faults(const Spacetime& world, const Scene& scene) {
    const double height = scene.disc->emissivity.lamp.height, low = world.horizon_radius().value_or(0.0);
    if (const double high = world.camera_range().high; !(height > low && height < high))
        return {{"disc.lamp_height", fmt::format("no lamp is at rest at {:g}", height),
                 high < kAnyRadius ? fmt::format("({:g}, {:g})", low, high) : fmt::format("above {:g}", low)}};
    if (world.rotates() && disc_leans(scene))
        return {{"disc.emissivity", "the lamp is on the disc's axis, and the disc leans about a rotating hole",
                 "another emissivity, or disc.tilt = 0", "disc.tilt"}};
    return {};
}

}  // namespace

std::vector<SceneFault> emissivity_faults(const Spacetime* world, const Scene& scene,
                                          const std::function<bool(const std::string&)>& given) {
    if (!scene.disc || scene.disc->emission != DiscEmission::kThermal) return {};
    const EmissivitySpec& spec = scene.disc->emissivity;
    if (spec.by == Emissivity::kAccretion) return {};
    if (given("disc.mass"))
        return {{"disc.mass", "the disc does not shine by accretion", "disc.temperature, or emissivity = \"accretion\"",
                 "disc.emissivity"}};
    if (spec.by == Emissivity::kPowerLaw && spec.breaks.size() > kMostBreaks)
        return {{"disc.breaks", fmt::format("{} radii are too many", spec.breaks.size()), "one or two"}};
    if (spec.by == Emissivity::kTable && !spec.file.empty()) {
        const auto rows = load_emissivity(spec.file);
        if (!rows) return {file_fault("disc.emissivity_file", spec.file, rows.error(), "a table of emissivities")};
        if (!((*rows)->front().r < scene.disc->outer && (*rows)->back().r > scene.disc->inner))
            return {
                {"disc.emissivity_file",
                 fmt::format("its radii, {:g} to {:g}, are outside of the disc", (*rows)->front().r, (*rows)->back().r),
                 fmt::format("radii within [{:g}, {:g}]", scene.disc->inner, scene.disc->outer)}};
    }
    return spec.by == Emissivity::kLamp && world != nullptr ? lamp_faults(*world, scene) : std::vector<SceneFault>();
}

}  // namespace nullscope
