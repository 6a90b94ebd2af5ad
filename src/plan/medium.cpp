#include "plan/medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "expr/formula.h"
#include "light/black_body.h"
#include "plan/medium_model.h"
#include "scene/medium_bands.h"
#include "scene/medium_dumps.h"
#include "scene/medium_grid.h"
#include "spacetime/axial_metric.h"
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

double spans_to_horizon() {
    constexpr double kSamples = 0.1;  // of the distance to the horizon, which begins to count at that radius
    return 0.25 * std::log(1.0 / kMediumAboveHorizon) / kSamples;
}

double medium_spans(const Spacetime& spacetime, const MediumSpec& medium) {
    const auto hole = medium_hole(spacetime);
    const auto spans = model_of(medium).spans;
    return spans != nullptr ? spans(medium, hole ? hole->outer : 0.0) / medium.step : 0.0;
}

namespace {

// Light of other things has no frequency.
void add_band_faults(const Scene& scene, std::vector<SceneFault>& faults) {
    const std::size_t count = scene.medium->bands_GHz.size();
    if (scene.medium->shown_band > static_cast<int>(count))
        faults.push_back({"medium.shown_band",
                          fmt::format("{}: there are {} frequencies", scene.medium->shown_band, count),
                          fmt::format("an integer from 0 to {}", count)});
    const char* other = scene.sky.kind != SkyKind::kBlack ? "a sky"
                        : scene.disc                      ? "a disc"
                        : !scene.bodies.empty()           ? "a body"
                                                          : "";
    if (*other != '\0')
        faults.push_back({"medium.frequency",
                          fmt::format("{} at once, but there is {} beside the matter", count, other),
                          "one frequency, or a scene without disc and bodies, with sky.kind = \"black\""});
}

}  // namespace

std::vector<SceneFault> medium_faults(const Spacetime& spacetime, const Scene& scene) {
    std::vector<SceneFault> faults;
    if (!scene.medium) return faults;
    if (!medium_hole(spacetime))
        faults.push_back({"medium", fmt::format("metric \"{}\" has no matter along rays", spacetime.name()),
                          "minkowski, schwarzschild, reissner-nordstrom, kerr or kerr-newman"});
    if (scene.camera.zoom)
        faults.push_back({"zoom", "a zoom leaves out part of the rays' path through matter", "no [zoom]"});
    for (const auto& [key, on] : {std::pair{"light.lensing", scene.light.lensing},
                                  {"light.doppler", scene.light.doppler},
                                  {"light.gravity", scene.light.gravity},
                                  {"light.aberration", scene.light.aberration}})
        if (!on) faults.push_back({key, "off, which a [medium] does not support", "on with a [medium]"});
    const MediumSpec& medium = *scene.medium;
    const MediumModel& model = model_of(medium);
    if ((model.shares & kInner) != 0 && !(medium.inner < medium.outer))
        faults.push_back(
            {"medium.outer", fmt::format("{} is not above inner = {}", medium.outer, medium.inner), "inner < outer"});
    if (medium.kind != MediumKind::kGrid && medium.field_direction == FieldDirection::kFile)
        faults.push_back({"medium.field_direction", "no file gives this field", "file where kind = \"grid\""});
    if (medium.field_direction == FieldDirection::kVector && length(medium.field_vector) == 0.0)
        faults.push_back({"medium.field_vector", "[0, 0, 0] has no direction", "three numbers, one of them not 0"});
    if (const ElectronSpec& e = medium.electrons;
        medium.has_electrons() && e.kind == ElectronKind::kPowerLaw && !(e.gamma_min < e.gamma_max))
        faults.push_back({"medium.electron_gamma_max",
                          fmt::format("{} is not above electron_gamma_min = {}", e.gamma_max, e.gamma_min),
                          "electron_gamma_min < electron_gamma_max"});
    if (is_polarised(medium) && has_polarised_disc(scene))
        faults.push_back(
            {"medium.polarisation", "on, beside a disc that is polarised too", "off, or disc.polarisation = \"off\""});
    if (has_bands(scene)) add_band_faults(scene, faults);
    if (model.faults != nullptr) model.faults(spacetime, scene, faults);
    // The march takes 8192 (shaders/medium/march.glsl), some of them on its way to the matter.
    constexpr double kMostSpans = 8000;
    if (const double spans = medium_spans(spacetime, medium); faults.empty() && spans > kMostSpans)
        faults.push_back({"medium.step", fmt::format("{}: a ray takes {:.0f} spans of samples", medium.step, spans),
                          fmt::format("at least {:.2g}, here", 1.05 * medium.step * spans / kMostSpans)});
    if (medium.by_frequency() && !scene.object.mass())
        faults.push_back({"object.mass_suns", "missing, but there is a [medium] seen at one frequency",
                          "the mass, which sets lengths in centimetres, or object.name", "medium.kind"});
    return faults;
}

std::string medium_note(const Spacetime& spacetime, const Scene& scene) {
    constexpr double kNoCharge = 1e-12;  // of outer inner - a^2, which is Q^2
    if (!scene.medium || scene.medium->kind != MediumKind::kGrid) return "";
    const auto grid = medium_form(scene);
    if (!grid) return "";
    const auto hole = medium_hole(spacetime);
    const bool flat = !spacetime.bends_light(),
               charged = hole && std::abs(hole->outer * hole->inner - hole->a * hole->a) > kNoCharge;
    if (!flat && !charged) return "";
    return without_controls(fmt::format("medium.file: the matter of {} is about a hole of spin {}{}; {}",
                                        in_quotes(scene.medium->grid.file.filename().string()), grid->spin(),
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
    const MediumModel& model = model_of(medium);
    if (model.moves != nullptr) return model.moves(medium);
    return (model.shares & kWarmth) != 0 ? warmth_moves(medium) : nullptr;
}

double medium_farthest(const MediumSpec& medium) { return model_of(medium).farthest(medium); }

bool asks_for_time(const std::string& text) {
    constexpr std::size_t kTime = 4;
    const auto formula = expr::Formula::parse(text, medium_variables());
    return formula && formula->uses(kTime);
}

const char* warmth_moves(const MediumSpec& medium) {
    if (medium.warm() && asks_for_time(medium.formulas.temperature)) return "medium.local_temperature";
    return medium.law_row().field && asks_for_time(medium.formulas.field) ? "medium.field" : nullptr;
}

ElectronEnergies electron_energies(const MediumSpec& medium) {
    const ElectronSpec& electrons = medium.electrons;
    const bool kappa = electrons.kind == ElectronKind::kKappa;
    return {kappa, kappa ? electrons.kappa : electrons.index, electrons.gamma_min, electrons.gamma_max,
            medium.field_direction == FieldDirection::kIsotropic};
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

namespace {

constexpr double kMostLight = 1e30;

// Of what may be 0: far below all that counts.
double logarithm(double number) { return std::log2(std::max(number, 1e-300)); }

// Of matter that is seen at one frequency, that of `medium`.
LawNumbers numbers_of_law(const FramePlan& plan, const MediumSpec& medium) {
    const MediumModel& model = model_of(medium);
    const bool bands = shows_bands(plan.scene), any_density = model.traits.any_density || bands;
    const double mass = plan.scene.object.mass().value_or(0.0);
    // Powers of the frequency by which light that is seen with its frequency times g differs, and by which its intensity does.
    const double shift = plan.scene.light.shift ? 1.0 : 0.0, beaming = plan.scene.light.beaming ? 3.0 : 0.0;
    LawNumbers law{
        {shift, beaming, medium.frequency_GHz, model.opacity != nullptr ? model.opacity(medium) : medium.opacity,
         logarithm(1e-20 * 100.0 * schwarzschild_radius_m(mass) / medium_light_cgs(medium.frequency_GHz)),
         -std::log2(kMediumLight_K), log2_brightness(medium.temperature_K, plan.scene.light.bolometric),
         late_time(plan)},
        medium.brightness};
    if (medium.has_electrons()) {
        const ElectronEnergies energies = electron_energies(medium);
        const ElectronCells cells = electron_cells(energies);
        for (const double value : {cells.first, cells.per_octave, energies.index}) law.values.push_back(value);
    }
    if (medium.law() != MediumEmission::kPowerLaw) return law;
    FlowNumbers flow = flow_numbers(medium, mass);
    if (any_density) {
        const double scale = model.traits.any_density ? 1.0 : medium.density_scale;
        flow = {logarithm(scale * flow.emission), logarithm(scale * flow.absorption)};
    } else {  // densities are 1 at most; where it is opaque beyond what has room in a float it is as bright
        flow.emission *= medium.density_scale, flow.absorption *= medium.density_scale;
        const double most = std::max({flow.absorption, flow.emission * medium.brightness, kMostLight}) / kMostLight;
        law.light = medium.brightness * flow.emission / most;
        flow.absorption /= most;
    }
    // In g^3 j(nu/g) dlambda/g and alpha(nu/g) dlambda/g.
    for (const double value : {beaming + shift * medium.spectral_index - 1.0,
                               shift * (2.5 + medium.spectral_index) - 1.0, flow.absorption, flow.emission})
        law.values.push_back(value);
    return law;
}

}  // namespace

LawNumbers law_numbers(const FramePlan& plan) {
    const MediumSpec& medium = *plan.scene.medium;
    LawNumbers law = numbers_of_law(plan, medium);
    if (!shows_bands(plan.scene)) return law;
    for (const std::size_t band : bands_as_colours(medium)) {
        const Scene one = at_band(plan.scene, band);
        std::vector<double> values = numbers_of_law(plan, *one.medium).values;
        values.resize(kLawValues);
        law.bands.push_back({values[2], values[4], values[10], values[11]});
    }
    return law;
}

}  // namespace nullscope
