#include "plan/emissivity_keys.h"

namespace nullscope {
namespace {

template <Emissivity by>
bool shines_by(const Scene& s) {
    return s.disc->emission == DiscEmission::kThermal && s.disc->emissivity.by == by;
}
constexpr std::string_view kByPowers = "emission = \"thermal\" and emissivity = \"power-law\"",
                           kByTable = "emission = \"thermal\" and emissivity = \"table\"",
                           kByLamp = "emission = \"thermal\" and emissivity = \"lamp\"";

constexpr KeyMember kBreaks = {[](const Scene& s) {
                                   const auto& breaks = s.disc->emissivity.breaks;
                                   return KeyValue{.numbers = breaks, .there = !breaks.empty()};
                               },
                               [](Scene& s, const KeyValue& v) { s.disc->emissivity.breaks = v.numbers; }};

}  // namespace

std::vector<SceneKey> emissivity_keys() {
    return {{"disc", "emissivity", KeyType::kChoice, "", "accretion", kNoRange, "accretion power-law table lamp",
             "What a thermal disc shines by at each radius: accretion (Page and Thorne's flux), powers of the radius, "
             "a table, or the light of a lamp on its axis. Needs emission = \"thermal\".",
             [](auto& s) { return &s.disc->emissivity.by; },
             [](const Scene& s) { return s.disc->emission == DiscEmission::kThermal; }, "emission = \"thermal\""},
            {"disc", "powers", KeyType::kPoint, "", "[3, 3, 3]", closed(-20.0, 20.0), "",
             "q of emissivities r^-q: within the first break, up to the second and beyond it; with one break the first "
             "two, "
             "without any the first. Needs emissivity = \"power-law\".",
             [](auto& s) { return &s.disc->emissivity.powers; }, shines_by<Emissivity::kPowerLaw>, kByPowers},
            {"disc", "breaks", KeyType::kNumbers, "r_s", "", closed(1e-6, 1e6), "",
             "Radius of the break, or of both, where one power meets the next. Needs emissivity = \"power-law\".",
             kBreaks, shines_by<Emissivity::kPowerLaw>, kByPowers},
            {"disc", "emissivity_file", KeyType::kFile, "", "", kNoRange, "CSV",
             "CSV of radii (r_s, growing) and emissivities (any unit); between rows powers of the radius, outside of "
             "them dark. "
             "Needs emissivity = \"table\".",
             [](auto& s) { return &s.disc->emissivity.file; }, shines_by<Emissivity::kTable>, kByTable, true},
            {"disc", "lamp_height", KeyType::kNumber, "r_s", "5", kPositive, "",
             "Height of the lamp at rest on the disc's axis. Needs emissivity = \"lamp\".",
             [](auto& s) { return &s.disc->emissivity.lamp.height; }, shines_by<Emissivity::kLamp>, kByLamp},
            {"disc", "lamp_index", KeyType::kNumber, "", "2", closed(0.0, 10.0), "",
             "Photon index of the lamp's spectrum: what a ring emits is what it gets times G^(index - 1), G the energy "
             "there "
             "over the one at the lamp; 2 is the energy that arrives. Needs emissivity = \"lamp\".",
             [](auto& s) { return &s.disc->emissivity.lamp.index; }, shines_by<Emissivity::kLamp>, kByLamp}};
}

}  // namespace nullscope
