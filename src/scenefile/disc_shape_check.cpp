#include "scenefile/disc_shape_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/disc_shape.h"

namespace nullscope {
namespace {

using ShapeFaults = std::vector<SceneFault>;
constexpr double kShapeCheckDegree = M_PI / 180.0;

// Rows of the warp: as many numbers in each list, and no ring turned far from the next.
ShapeFaults row_faults(const DiscWarp& warp) {
    const std::size_t rows = warp.radii.size();
    for (const auto& [key, list] :
         {std::pair{"disc.warp_tilts", &warp.tilts_deg}, {"disc.warp_nodes", &warp.nodes_deg}})
        if (list->size() != rows)
            return {{key, fmt::format("{} numbers, and disc.warp_radii has {}", list->size(), rows),
                     "one for each radius", "disc.warp_radii"}};
    if (rows == 1) return {{"disc.warp_radii", "one row is no warp", "two radii or more; disc.tilt tilts a flat disc"}};
    for (std::size_t i = 1; i < rows; ++i) {
        DiscSpec row;
        row.warp = {{warp.radii[i - 1], warp.radii[i]},
                    {warp.tilts_deg[i - 1], warp.tilts_deg[i]},
                    {warp.nodes_deg[i - 1], warp.nodes_deg[i]},
                    {}};
        const DiscShape shape(row, 0.0);
        const double turn = angle_between(shape.normal(warp.radii[i - 1]), shape.normal(warp.radii[i])),
                     most = std::min(kMostWarpTurn, kSteepestWarp * std::log(warp.radii[i] / warp.radii[i - 1]));
        if (turn > most)
            return {{"disc.warp_tilts",
                     fmt::format("from r = {:g} to {:g} the disc turns by {:.3g} degrees", warp.radii[i - 1],
                                 warp.radii[i], turn / kShapeCheckDegree),
                     fmt::format("at most {:.3g} degrees there", most / kShapeCheckDegree)}};
    }
    return {};
}

ShapeFaults ring_faults(const DiscSpec& disc) {
    const std::vector<double>& rings = disc.warp.rings;
    if (rings.empty()) return {};
    if (rings.size() % 2 != 0)
        return {{"disc.rings", fmt::format("{} radii", rings.size()), "pairs: where each ring begins and ends"}};
    if (rings.front() < disc.inner || rings.back() > disc.outer)
        return {{"disc.rings",
                 fmt::format("they reach from {:g} to {:g}, beyond the disc", rings.front(), rings.back()),
                 fmt::format("[{:g}, {:g}]", disc.inner, disc.outer)}};
    return {};
}

}  // namespace

std::vector<SceneFault> disc_shape_faults(const Spacetime* world, const Scene& scene,
                                          const std::function<bool(const std::string&)>& given) {
    if (!disc_warps(scene)) {
        for (const char* key : {"disc.warp_tilts", "disc.warp_nodes"})
            if (given(key)) return {{key, "there are no radii that it belongs to", "none, or disc.warp_radii too"}};
        return {};
    }
    const DiscSpec& disc = *scene.disc;
    if (ShapeFaults faults = row_faults(disc.warp); !faults.empty()) return faults;
    if (ShapeFaults faults = ring_faults(disc); !faults.empty()) return faults;
    ShapeFaults faults;
    const std::string by = disc.warp.bends() ? "disc.warp_radii" : "disc.rings";
    const auto refuse = [&](bool there, const char* key, const char* what, const char* allowed) {
        if (there) faults.push_back({key, fmt::format("{}, and the disc has a warp or rings", what), allowed, by});
    };
    refuse(world != nullptr && world->rotates(), by.c_str(), "the hole rotates, so that rays keep to no plane",
           "a metric without rotation, or disc.tilt");
    refuse(has_polarised_disc(scene), "disc.polarisation", "there is one", "off");
    refuse(disc.effects.limb_darkening, "disc.limb_darkening", "it needs the slope of the disc's surface", "off");
    refuse(disc.emission == DiscEmission::kThermal && disc.emissivity.by == Emissivity::kLamp, "disc.emissivity",
           "a lamp lights flat discs", "another emissivity");
    refuse(scene.camera.zoom.has_value(), "zoom", "there is one", "a disc without warp and rings");
    return faults;
}

}  // namespace nullscope
