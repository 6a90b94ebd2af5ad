// Matter at the nodes of a file's grid (scene/medium_grid.h).
#include <fmt/format.h>

#include <cmath>

#include "base/assets.h"
#include "plan/medium.h"
#include "plan/medium_model.h"
#include "spacetime/spacetime.h"

namespace nullscope {
namespace {

bool is_grid(const Scene& s) { return s.medium->kind == MediumKind::kGrid; }
constexpr std::string_view kGrid = "kind = \"grid\"";
constexpr double kShippedGridSpin = 0.9;  // of assets/medium/torus.grid

std::vector<SceneKey> grid_keys() {
    const std::string_view scaled = kinds_with(kDensityScale);
    return {
        {"medium", "file", KeyType::kFile, "", "", kNoRange, "grid of matter",
         "File with the matter; docs/matter.md has its format. Needs kind = \"grid\".",
         [](auto& s) { return &s.medium->grid.file; }, is_grid, kGrid, true},
        {"medium", "density_scale", KeyType::kNumber, "", "1", closed(1e-12, 1e12), "",
         kept(fmt::format("Multiplies the density of model or file (with synchrotron and bremsstrahlung, electrons per "
                          "cm^3), and the magnetic field of a file by its square root. Needs {}.",
                          scaled)),
         [](auto& s) { return &s.medium->density_scale; }, shared<kDensityScale>, scaled},
    };
}

// What is wrong with the file, another hole's spin (flat space takes any), an end of the matter beyond its last nodes.
void grid_faults(const Spacetime& spacetime, const Scene& scene, std::vector<SceneFault>& faults) {
    constexpr double kSame = 1e-6;  // of spins and radii
    const MediumSpec& medium = *scene.medium;
    const auto& file = medium.grid.file;
    if (file.empty()) return;
    const auto grid = load_medium_grid(file);
    if (!grid) {
        faults.push_back(file_fault("medium.file", file, grid.error(), "a grid of matter"));
        return;
    }
    const auto hole = medium_hole(spacetime);
    const double spin = (*grid)->spin(), a = hole ? 2.0 * hole->a : 0.0, farthest = (*grid)->farthest();
    if (spacetime.bends_light() && std::abs(spin - a) > kSame)
        faults.push_back({"medium.file",
                          fmt::format("its matter is about a hole of spin {}, the scene's has {}", spin, a),
                          fmt::format("a file with spin {}", a)});
    else if (medium.outer > (1.0 + kSame) * farthest)
        faults.push_back({"medium.outer", fmt::format("{} is beyond the last node of medium.file", medium.outer),
                          fmt::format("at most {:.9g}", farthest), "medium.file"});
    else if (spacetime.bends_light() && hole && (*grid)->nearest() <= hole->outer)
        faults.push_back({"medium.file",
                          fmt::format("its first node, r = {:.9g}, is not outside the horizon", (*grid)->nearest()),
                          fmt::format("a file whose first r is above {:.9g}", hole->outer)});
}

std::vector<double> grid_values(const MediumFrame& f) {
    std::vector<double> values = sphere_values(f);
    if (f.grid == nullptr) return values;
    const auto &rings = f.grid->rings(), &polar = f.grid->polar(), &around = f.grid->around();
    const double scale = f.medium().density_scale;
    for (const double value :
         {rings.first, 1.0 / rings.step, polar.first, 1.0 / polar.step, static_cast<double>(rings.count),
          static_cast<double>(polar.count), static_cast<double>(around.count), f.grid->kerr_schild() ? 1.0 : 0.0,
          around.first / (2.0 * M_PI), scale, std::sqrt(scale), f.grid->horizon()})
        values.push_back(value);
    return values;
}

}  // namespace

const MediumModel kFileModel{
    .word = "grid",
    .what = "values of a file at the nodes of a grid",
    .effect = {medium_effect(MediumKind::kGrid),
               "medium-grid",
               "EFFECT_MEDIUM_GRID",
               "Matter given at the nodes of a grid emits and absorbs light along rays.",
               "there is a [medium] of kind \"grid\"",
               "a march along each ray, in samples of 16 fetches",
               {Slot::kMedium, "medium/grid.glsl"}},
    .shares = kOuter | kSphere | kDensityScale | kLaws,
    .traits = {.turn = true, .any_density = true},
    .keys = grid_keys,
    .words = [](const MediumSpec& m) { return fmt::format("of file \"{}\"", m.grid.file.filename().string()); },
    .farthest = [](const MediumSpec& m) { return m.outer; },
    .least_step = nullptr,
    .spans = sphere_spans,
    .moves = nullptr,
    .faults = grid_faults,
    .numbers =
        "SPHERE_RADIUS SPHERE_HEIGHT SPHERE_STEP GRID_RING GRID_RINGS GRID_POLAR GRID_POLARS GRID_RING_COUNT "
        "GRID_POLAR_COUNT GRID_AROUND_COUNT GRID_KERR_SCHILD GRID_AROUND GRID_DENSITY GRID_FIELD GRID_HORIZON",
    .values = grid_values,
    .before =
        [](Scene& s) {
            massive_hole(s);
            s.spacetime = {"kerr", {{"spin", kShippedGridSpin}}};
        },
    .with =
        [](Scene& s) {
            MediumSpec& medium = s.medium.emplace();
            medium.kind = MediumKind::kGrid, medium.outer = 8;
            medium.grid.file = assets_directory() / "medium" / "torus.grid";
        },
};

}  // namespace nullscope
