#include "plan/medium.h"

#include <fmt/format.h>

#include <cmath>

#include "base/text.h"
#include "expr/formula.h"
#include "scene/medium_grid.h"
#include "spacetime/axial_metric.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/spherical_metric.h"

namespace nullscope {

std::optional<MediumHole> medium_hole(const Spacetime& spacetime) {
    if (const AxialMetric* axial = spacetime.axial())
        return MediumHole{axial->a(), axial->outer_horizon(), axial->inner_horizon()};
    const SphericalMetric* spherical = spacetime.spherical();
    if (spherical == nullptr) return std::nullopt;
    if (!spacetime.bends_light()) return MediumHole{0, 0, 0};
    const auto roots = spherical->lapse_roots();
    if (!roots) return std::nullopt;
    return MediumHole{0, roots->outer, roots->inner};
}

namespace {

// Of a file: what is wrong with it, another hole's spin (flat space takes any), an end of the matter beyond its last nodes.
std::optional<SceneFault> grid_fault(const Spacetime& spacetime, const MediumSpec& medium) {
    constexpr double kSame = 1e-6;  // of spins and radii
    const auto grid = load_medium_grid(medium.file);
    if (!grid) return file_fault("medium.file", medium.file, grid.error(), "a grid of matter");
    const auto hole = medium_hole(spacetime);
    const double spin = (*grid)->spin(), a = hole ? 2.0 * hole->a : 0.0, farthest = (*grid)->farthest();
    if (spacetime.bends_light() && std::abs(spin - a) > kSame)
        return SceneFault{"medium.file",
                          fmt::format("its matter is about a hole of spin {}, the scene's has {}", spin, a),
                          fmt::format("a file with spin {}", a)};
    if (medium.outer > (1.0 + kSame) * farthest)
        return SceneFault{"medium.outer", fmt::format("{} is beyond the last node of medium.file", medium.outer),
                          fmt::format("at most {:.9g}", farthest), "medium.file"};
    if (spacetime.bends_light() && hole && (*grid)->nearest() <= hole->outer)
        return SceneFault{"medium.file",
                          fmt::format("its first node, r = {:.9g}, is not outside the horizon", (*grid)->nearest()),
                          fmt::format("a file whose first r is above {:.9g}", hole->outer)};
    return std::nullopt;
}

}  // namespace

std::vector<SceneFault> medium_faults(const Spacetime& spacetime, const Scene& scene) {
    std::vector<SceneFault> faults;
    if (!scene.medium) return faults;
    if (!medium_hole(spacetime))
        faults.push_back({"medium", fmt::format("metric \"{}\" has no matter along rays", spacetime.name()),
                          "minkowski, schwarzschild, reissner-nordstrom, kerr or kerr-newman"});
    if (scene.camera.zoom)
        faults.push_back({"zoom", "a zoom leaves out a part of the rays' way through matter", "no [zoom]"});
    for (const auto& [key, on] : {std::pair{"light.lensing", scene.light.lensing},
                                  {"light.doppler", scene.light.doppler},
                                  {"light.gravity", scene.light.gravity},
                                  {"light.aberration", scene.light.aberration}})
        if (!on) faults.push_back({key, "off, which matter along rays does not have", "on with a [medium]"});
    const MediumSpec& medium = *scene.medium;
    if (medium.kind == MediumKind::kGas && !(medium.inner < medium.outer))
        faults.push_back(
            {"medium.outer", fmt::format("{} is not above inner = {}", medium.outer, medium.inner), "inner < outer"});
    if (medium.kind == MediumKind::kGas && spacetime.bends_light() && !circular_orbit(spacetime, medium.inner))
        faults.push_back({"medium.inner", fmt::format("no circular orbit at {}", medium.inner),
                          "a radius outside the photon sphere"});
    if (medium.kind != MediumKind::kGrid && medium.field_direction == FieldDirection::kFile)
        faults.push_back({"medium.field_direction", "no file has this field", "file where kind = \"grid\""});
    if (medium.kind == MediumKind::kGrid && !medium.file.empty())
        if (auto fault = grid_fault(spacetime, medium)) faults.push_back(std::move(*fault));
    if (medium.by_frequency() && !scene.object.mass())
        faults.push_back({"object.mass_suns", "missing, but there is a [medium] that shines at one frequency",
                          "the mass that gives lengths their centimetres, or object.name", "medium.kind"});
    return faults;
}

std::string medium_note(const Spacetime& spacetime, const Scene& scene) {
    constexpr double kNoCharge = 1e-12;  // of outer inner - a^2, which is Q^2
    if (!scene.medium || scene.medium->kind != MediumKind::kGrid) return "";
    const auto grid = load_medium_grid(scene.medium->file);
    if (!grid) return "";
    const auto hole = medium_hole(spacetime);
    const bool flat = !spacetime.bends_light(),
               charged = hole && std::abs(hole->outer * hole->inner - hole->a * hole->a) > kNoCharge;
    if (!flat && !charged) return "";
    return without_controls(fmt::format("medium.file: the matter of {} is about a hole of spin {}{}; {}",
                                        in_quotes(scene.medium->file.filename().string()), (*grid)->spin(),
                                        flat ? "" : " without charge",
                                        flat ? "the scene's space is flat" : "the scene's hole has one"));
}

Status check_medium(const Spacetime& spacetime, const Scene& scene) {
    const std::vector<SceneFault> faults = medium_faults(spacetime, scene);
    if (faults.empty()) return Done{};
    return bad_key(faults.front().key, faults.front().what, faults.front().allowed);
}

namespace {

constexpr double kLight_cm_s = 100.0 * kLight_m_s;
constexpr double kBoltzmann = 1.380649e-16;  // erg/K
constexpr double kReference_GHz = 230.0;     // at which emissivities are given (Gold et al. 2020)

}  // namespace

const std::vector<std::string>& medium_variables() {
    static const std::vector<std::string> names = {"x", "y", "z", "r", "t"};
    return names;
}

const char* medium_moves(const MediumSpec& medium) {
    if (medium.kind == MediumKind::kGas) return medium.flow != DiscFlowKind::kStill ? "medium.flow" : nullptr;
    if (medium.kind != MediumKind::kFormula) return nullptr;
    const MediumFormulas& f = medium.formulas;
    const auto asks = [](const std::string& text) {
        constexpr std::size_t kTime = 4;
        const auto formula = expr::Formula::parse(text, medium_variables());
        return formula && formula->uses(kTime);
    };
    const bool thermal = medium.emission != MediumEmission::kPowerLaw;
    if (asks(f.density)) return "medium.density";
    if (thermal && asks(f.temperature)) return "medium.local_temperature";
    if (medium.emission == MediumEmission::kSynchrotron && asks(f.field)) return "medium.field";
    if (asks(f.outward)) return "medium.velocity_out";
    if (asks(f.south)) return "medium.velocity_south";
    return asks(f.east) ? "medium.velocity_east" : nullptr;
}

double medium_farthest(const MediumSpec& medium) {
    if (medium.by_place()) return medium.outer;
    return medium.kind == MediumKind::kFlow ? kFlowScales * medium.radius
                                            : medium.outer * std::hypot(1.0, kGasHeights * medium.thickness);
}

double medium_light_cgs(double frequency_ghz) {
    const double by_c = 1e9 * frequency_ghz / kLight_cm_s;
    return 2.0 * kBoltzmann * by_c * by_c * kMediumLight_K;
}

FlowNumbers flow_numbers(const MediumSpec& medium, double mass_suns) {
    const double r_s_cm = 100.0 * schwarzschild_radius_m(mass_suns);
    const double x = medium.frequency_GHz / kReference_GHz, along = medium.emissivity * r_s_cm;
    return {along * std::pow(x, -medium.spectral_index) / medium_light_cgs(medium.frequency_GHz),
            medium.absorption * along * std::pow(x, -2.5 - medium.spectral_index)};
}

}  // namespace nullscope
