// Matter at the nodes of a file's grid (scene/medium_grid.h).
#include <fmt/format.h>

#include <cmath>

#include "base/assets.h"
#include "plan/dump_window.h"
#include "plan/medium.h"
#include "plan/medium_model.h"
#include "scene/medium_dumps.h"
#include "spacetime/spacetime.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

bool is_grid(const Scene& s) { return s.medium->kind == MediumKind::kGrid; }
bool is_of_dumps(const Scene& s) { return is_grid(s) && has_dumps(s.medium->grid); }
constexpr std::string_view kGrid = "kind = \"grid\"", kDumps = "file = \"NAME%05d.grid\"";
constexpr KeyRange kNumbers = closed(0, 999999999);
constexpr double kShippedGridSpin = 0.9;  // of assets/medium/torus.grid

std::vector<SceneKey> grid_keys() {
    const std::string_view scaled = kinds_with(kDensityScale);
    return {
        {"medium", "file", KeyType::kFile, "", "", kNoRange, "grid of matter",
         "File with the matter; docs/matter.md has its format. With a placeholder for a number (%05d, %d or #####) "
         "in its name, the dumps of a simulation at equal steps of time. Needs kind = \"grid\".",
         [](auto& s) { return &s.medium->grid.file; }, is_grid, kGrid, true, true},
        {"medium", "first", KeyType::kWhole, "", "", kNumbers, "",
         "Number of the first dump; without it the least in the folder. Needs a file with a placeholder.",
         [](auto& s) { return &s.medium->grid.first; }, is_of_dumps, kDumps},
        {"medium", "last", KeyType::kWhole, "", "", kNumbers, "",
         "Number of the last dump; without it the greatest in the folder. None between may be missing. "
         "Needs a file with a placeholder.",
         [](auto& s) { return &s.medium->grid.last; }, is_of_dumps, kDumps},
        {"medium", "cadence", KeyType::kNumber, "r_s/c", "", kPositive, "",
         "Time from dump to dump; 1 GM/c^3 is 0.5 r_s/c. Needs a file with a placeholder.",
         [](auto& s) { return &s.medium->grid.cadence; }, is_of_dumps, kDumps, true},
        {"medium", "start", KeyType::kNumber, "r_s/c", "0", closed(-1e9, 1e9), "",
         "Scene time of the first dump. Needs a file with a placeholder.",
         [](auto& s) { return &s.medium->grid.start; }, is_of_dumps, kDumps},
        {"medium", "light", KeyType::kChoice, "", "fast", kNoRange, "fast slow",
         "Which dumps a picture shows: fast, all of it those about the scene's time; slow, each place those about the "
         "time when its light left. Needs a file with a placeholder.",
         [](auto& s) { return &s.medium->grid.light; }, is_of_dumps, kDumps},
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
    if (has_dumps(medium.grid)) {
        auto fault = dump_fault(medium.grid);
        if (!fault && !(medium.grid.cadence > 0.0))
            fault = {"medium.cadence", "missing, but medium.file is of dumps", "the time from dump to dump, r_s/c",
                     "medium.file"};
        if (!fault) fault = medium_time_fault(spacetime, scene, scene.time);
        if (fault) return faults.push_back(*fault);
    }
    const auto grid = medium_form(scene);
    if (!grid) {
        const auto& at = grid.error().file;
        faults.push_back(file_fault("medium.file", at.empty() ? file : fs::path(at), grid.error(), "a grid of matter"));
        return;
    }
    const auto hole = medium_hole(spacetime);
    const double spin = grid->spin(), a = hole ? 2.0 * hole->a : 0.0, farthest = grid->farthest();
    if (spacetime.bends_light() && std::abs(spin - a) > kSame)
        faults.push_back({"medium.file",
                          fmt::format("its matter is about a hole of spin {}, the scene's has {}", spin, a),
                          fmt::format("a file with spin {}", a)});
    else if (medium.outer > (1.0 + kSame) * farthest)
        faults.push_back({"medium.outer", fmt::format("{} is beyond the last node of medium.file", medium.outer),
                          fmt::format("at most {:.9g}", farthest), "medium.file"});
    else if (spacetime.bends_light() && hole && grid->nearest() <= hole->outer)
        faults.push_back({"medium.file",
                          fmt::format("its first node, r = {:.9g}, is not outside the horizon", grid->nearest()),
                          fmt::format("a file whose first r is above {:.9g}", hole->outer)});
}

// Of dumps with slow light: the time, in dumps, counted from the window's first; where that one is in the texture. And by how much the dumps'
// clock is ahead of t, log(r - GRID_INNER) + GRID_AHEAD_LOG log((r - horizon)/(r - GRID_INNER)), times GRID_AHEAD (spacetime/tortoise.h).
void add_dump_values(const MediumFrame& f, std::vector<double>& values) {
    constexpr double kLeastApart = 1e-3;  // of the horizons: floats have no digits left for log1p(-apart/r)/apart
    const GridMatter& matter = f.medium().grid;
    const DumpWindow window = dump_window(*f.plan.matter, f.plan.scene, *f.grid);
    const auto hole = medium_hole(*f.plan.matter);
    const bool ahead = f.plan.effects.contains(Effect::kDelay) && f.grid->kerr_schild() && hole && hole->outer > 0.0;
    const double outer = ahead ? hole->outer : 0.0, charge2 = ahead ? outer * hole->inner - hole->a * hole->a : 0.0,
                 inner = ahead ? std::min(hole->inner, outer - kLeastApart) : 0.0;
    for (const double value : {(late_time(f.plan) - matter.start) / matter.cadence - window.first, 1.0 / matter.cadence,
                               static_cast<double>(window.last - window.first),
                               static_cast<double>(window.first % window.slots), static_cast<double>(window.slots),
                               ahead ? 1.0 : 0.0, ahead ? (outer - charge2) / (outer - inner) : 0.0, inner})
        values.push_back(value);
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
    if (has_slow_light(f.plan.scene)) add_dump_values(f, values);
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
    .words =
        [](const MediumSpec& m) {
            return fmt::format("of file \"{}\"{}", m.grid.file.filename().string(),
                               has_dumps(m.grid) ? ": " + dump_words(m.grid) : "");
        },
    .farthest = [](const MediumSpec& m) { return m.outer; },
    .least_step = nullptr,
    .spans = sphere_spans,
    .moves = [](const MediumSpec& m) -> const char* {
        return has_dumps(m.grid) && m.grid.light == DumpLight::kSlow ? "medium.light" : nullptr;
    },
    .faults = grid_faults,
    .numbers =
        "SPHERE_RADIUS SPHERE_HEIGHT SPHERE_STEP GRID_RING GRID_RINGS GRID_POLAR GRID_POLARS GRID_RING_COUNT "
        "GRID_POLAR_COUNT GRID_AROUND_COUNT GRID_KERR_SCHILD GRID_AROUND GRID_DENSITY GRID_FIELD GRID_HORIZON "
        "GRID_TIME GRID_RATE GRID_LAST GRID_SLOT GRID_SLOTS GRID_AHEAD GRID_AHEAD_LOG GRID_INNER",
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
