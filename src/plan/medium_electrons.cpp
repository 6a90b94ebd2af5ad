#include "plan/medium_electrons.h"

#include <fmt/format.h>

#include "plan/medium_model.h"

namespace nullscope {
namespace {

constexpr std::string_view kOfElectrons = "emission = \"synchrotron\"", kPowerLaw = "electrons = \"power-law\"",
                           kKappa = "electrons = \"kappa\"";

bool has_law_of_electrons(const Scene& s) { return s.medium->law() == MediumEmission::kSynchrotron; }
bool has_power_law(const Scene& s) {
    return s.medium->has_electrons() && s.medium->electrons.kind == ElectronKind::kPowerLaw;
}
bool has_kappa(const Scene& s) { return s.medium->has_electrons() && s.medium->electrons.kind == ElectronKind::kKappa; }

std::vector<SceneKey> electron_keys() {
    return {
        {"medium", "electrons", KeyType::kChoice, "", "thermal", kNoRange, "thermal power-law kappa",
         "Energies of the electrons of synchrotron light: a thermal distribution of local_temperature; a power law, "
         "the "
         "density's electrons without any others; or a kappa distribution of width w = k T/(m c^2), T the "
         "local_temperature. Needs emission = \"synchrotron\".",
         [](auto& s) { return &s.medium->electrons.kind; }, has_law_of_electrons, kOfElectrons},
        {"medium", "electron_index", KeyType::kNumber, "", "3", closed(1.05, 8.0), "",
         "p of electrons of energies gamma^-p. Needs electrons = \"power-law\".",
         [](auto& s) { return &s.medium->electrons.index; }, has_power_law, kPowerLaw},
        {"medium", "electron_gamma_min", KeyType::kNumber, "", "30", closed(1.0, 1e7), "",
         "Least energy of a power law's electrons over m c^2. Needs electrons = \"power-law\".",
         [](auto& s) { return &s.medium->electrons.gamma_min; }, has_power_law, kPowerLaw},
        {"medium", "electron_gamma_max", KeyType::kNumber, "", "100000", closed(1.0, 1e8), "",
         "Largest energy of a power law's electrons over m c^2, above electron_gamma_min. Needs electrons = "
         "\"power-law\".",
         [](auto& s) { return &s.medium->electrons.gamma_max; }, has_power_law, kPowerLaw},
        {"medium", "electron_kappa", KeyType::kNumber, "", "3.5", closed(2.5, 50.0), "",
         "kappa of the electrons: at high energies gamma^(1 - kappa); thermal if it is large. Needs electrons = "
         "\"kappa\".",
         [](auto& s) { return &s.medium->electrons.kappa; }, has_kappa, kKappa},
    };
}

}  // namespace

Feature electrons_feature() {
    return {{Effect::kMediumElectrons, "medium-electrons", "EFFECT_MEDIUM_ELECTRONS",
             "The electrons of synchrotron light are not thermal.", "medium.electrons is \"power-law\" or \"kappa\"",
             "fetches from the table of electrons in place of the thermal formula, and building it, some 50 ms"},
            [](const FrameFacts& f) -> Reason {
                if (!f.scene.medium || !f.scene.medium->has_electrons()) return kNot;
                const ElectronSpec& e = f.scene.medium->electrons;
                return e.kind == ElectronKind::kKappa
                           ? fmt::format("medium.electrons = \"kappa\", kappa {}", e.kappa)
                           : fmt::format("medium.electrons = \"power-law\", gamma^-{} from {} to {}", e.index,
                                         e.gamma_min, e.gamma_max);
            },
            [](Scene& s) {
                if (s.medium) s.medium->electrons.kind = ElectronKind::kThermal;
            },
            [](Scene& s) {
                massive_hole(s);
                s.medium.emplace().kind = MediumKind::kFormula;
                s.medium->emission = MediumEmission::kSynchrotron;
            },
            [](Scene& s) { s.medium->electrons.kind = ElectronKind::kKappa; },
            nullptr,
            electron_keys()};
}

}  // namespace nullscope
