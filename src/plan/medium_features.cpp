// Features of matter along rays: one for each model (plan/medium_model.h), and those of what several have.
#include <fmt/format.h>

#include <algorithm>

#include "plan/feature.h"
#include "plan/medium.h"
#include "plan/medium_electrons.h"
#include "plan/medium_model.h"
#include "scene/medium_bands.h"
#include "scene/medium_dumps.h"

namespace nullscope {

std::string_view kinds_with(unsigned share) {
    std::vector<std::string> words;
    for (const MediumModel* model : medium_models())
        if ((model->shares & share) != 0) words.push_back(fmt::format("\"{}\"", model->word));
    const std::string last = words.back();
    words.pop_back();
    return kept(words.empty() ? "kind = " + last : fmt::format("kind = {} or {}", fmt::join(words, ", "), last));
}

namespace {

bool is_black_body(const Scene& s) { return has_share(s, kLaws) && s.medium->emission == MediumEmission::kBlackBody; }
bool is_synchrotron(const Scene& s) { return s.medium->law() == MediumEmission::kSynchrotron; }
bool has_power(const Scene& s) { return s.medium->law() == MediumEmission::kPowerLaw; }
bool by_frequency(const Scene& s) { return s.medium->by_frequency(); }
constexpr std::string_view kPower = "emission = \"power-law\"", kSynchrotron = "emission = \"synchrotron\"",
                           kBlackBody = "emission = \"black-body\"",
                           kDirected = "emission = \"synchrotron\" and a field_direction other than isotropic";

SceneKey frequency_key(const std::string& kinds) {
    constexpr auto kRead = [](const Scene& s) {
        const MediumSpec& m = *s.medium;
        KeyValue value;
        value.numbers = m.bands_GHz.empty() ? std::vector{m.frequency_GHz} : m.bands_GHz;
        return value;
    };
    constexpr auto kWrite = [](Scene& s, const KeyValue& value) {
        MediumSpec& m = *s.medium;
        const bool several = value.numbers.size() > 1;
        m.bands_GHz = several ? value.numbers : std::vector<double>();
        if (!value.numbers.empty()) m.frequency_GHz = value.numbers.front();
        settle_bands(m);
    };
    return {"medium",
            "frequency",
            KeyType::kNumbers,
            "GHz",
            "230",
            closed(1e-3, 1e12),
            "",
            kept(fmt::format("Frequency at which the camera sees the matter, or several at once: bands. Needs {}, with "
                             "another emission than \"black-body\".",
                             kinds)),
            {kRead, kWrite},
            by_frequency,
            "matter that is seen at one frequency"};
}

std::vector<SceneKey> power_law_keys() {
    const std::string kinds(kinds_with(kLaws));
    const auto help = [&](const char* what) {
        return kept(fmt::format("{} Needs {}, with emission = \"power-law\".", what, kinds));
    };
    return {
        {"medium", "spectral_index", KeyType::kNumber, "", "0", closed(-10.0, 10.0), "",
         help("alpha of the emissivity nu^-alpha and of the absorptivity nu^-(2.5 + alpha)."),
         [](auto& s) { return &s.medium->spectral_index; }, has_power, kPower},
        {"medium", "emissivity", KeyType::kNumber, "erg/(s cm^3 Hz sr)", "3e-18", closed(0.0, 1e30), "",
         help("Emissivity at 230 GHz where the density is 1, in the frame of the matter."),
         [](auto& s) { return &s.medium->emissivity; }, has_power, kPower},
        {"medium", "absorption", KeyType::kNumber, "", "0", closed(0.0, 1e30), "",
         help("Absorptivity over emissivity at 230 GHz, both in cgs units; 0 is transparent matter."),
         [](auto& s) { return &s.medium->absorption; }, has_power, kPower},
        frequency_key(kinds),
    };
}

// "gas flow formula grid", and "gas, a soft thick disc; flow, ...".
template <class Rows, class Word, class What>
std::array<std::string_view, 2> choices_of(const Rows& rows, const Word& word, const What& what) {
    std::vector<std::string> words, each;
    for (const auto& row : rows) {
        words.emplace_back(word(row));
        each.push_back(fmt::format("{}, {}", word(row), what(row)));
    }
    return {kept(fmt::format("{}", fmt::join(words, " "))), kept(fmt::format("{}", fmt::join(each, "; ")))};
}

std::vector<SceneKey> common_keys() {
    const auto [kinds, each] = choices_of(
        medium_models(), [](auto* model) { return model->word; }, [](auto* model) { return model->what; });
    return {
        {"medium", "kind", KeyType::kChoice, "", "gas", kNoRange, kinds,
         kept(fmt::format("What the matter is: {}.", each)), [](auto& s) { return &s.medium->kind; }},
        {"medium", "colour", KeyType::kColour, "", "[1, 1, 1]", closed(0.0, 1e6), "",
         "Linear colour that multiplies its light. Where light is of one frequency, 1 is a brightness temperature of "
         "1e9 K.",
         [](auto& s) { return &s.medium->colour; }},
        {"medium", "brightness", KeyType::kNumber, "", "1", kBrightness, "",
         "Multiplies its light; 1 is, for gas and black bodies, a black body of `temperature`.",
         [](auto& s) { return &s.medium->brightness; }},
        {"medium", "step", KeyType::kNumber, "", "1", closed(0.05, 4.0), "",
         "Step length along rays over the default one: smaller is more accurate and slower; 0.25 to measure clumpy "
         "gas.",
         [](auto& s) { return &s.medium->step; }},
    };
}

SceneKey emission_key() {
    const auto [laws, each] = choices_of(
        kEmissionLaws, [](auto& law) { return law.word; }, [](auto& law) { return law.what; });
    const std::string_view with = kinds_with(kLaws);
    return {"medium",
            "emission",
            KeyType::kChoice,
            "",
            "power-law",
            kNoRange,
            laws,
            kept(fmt::format("How the matter shines: {}. Needs {}.", each, with)),
            [](auto& s) { return &s.medium->emission; },
            shared<kLaws>,
            with};
}

std::vector<SceneKey> extent_keys() {
    const std::string_view with = kinds_with(kSphere);
    return {
        {"medium", "field_direction", KeyType::kChoice, "", "isotropic", kNoRange,
         "isotropic out south east file vector",
         "Direction of the magnetic field in the frame of the matter; isotropic: the mean over all directions; file: "
         "that of kind "
         "= \"grid\"; vector: medium.field_vector. Needs emission = \"synchrotron\".",
         [](auto& s) { return &s.medium->field_direction; }, is_synchrotron, kSynchrotron},
        {"medium", "height", KeyType::kNumber, "r_s", "1e6", kPositive, "",
         kept(fmt::format("Largest distance of the matter from the equatorial plane. Needs {}.", with)),
         [](auto& s) { return &s.medium->height; }, shared<kSphere>, with},
        {"medium", "opacity", KeyType::kNumber, "1/r_s", "1", closed(0.0, 1e6), "",
         "Optical depth for each r_s where the density is 1. Needs emission = \"black-body\".",
         [](auto& s) { return &s.medium->opacity; }, is_black_body, kBlackBody},
        {"medium", "steps", KeyType::kWhole, "", "64", closed(16.0, 1024.0), "",
         kept(fmt::format("Samples across the sphere of radius outer; thinner structures may be missed. Needs {}.",
                          with)),
         [](auto& s) { return &s.medium->steps; }, shared<kSphere>, with},
    };
}

// In the order in which files are written: a new model's come last.
std::vector<SceneKey> medium_keys() {
    std::vector<SceneKey> keys;
    const auto add = [&](const std::vector<SceneKey>& more) { keys.insert(keys.end(), more.begin(), more.end()); };
    add(kFlowModel.keys()), add(power_law_keys()), add(common_keys()), add(kGasModel.keys());
    add({emission_key()}), add(kFormulaModel.keys()), add(extent_keys());
    for (const MediumModel* model : medium_models())
        if (model != &kFlowModel && model != &kGasModel && model != &kFormulaModel) add(model->keys());
    return keys;
}

void medium_by_formula(Scene& s) {
    massive_hole(s);
    s.medium.emplace().kind = MediumKind::kFormula;
}

template <std::size_t kind>
Feature model_feature() {
    const MediumModel& model = *medium_models()[kind];
    return {model.effect,
            [](const FrameFacts& f) -> Reason {
                if (!f.scene.medium || f.scene.medium->kind != static_cast<MediumKind>(kind)) return kNot;
                return fmt::format("[medium] {}", medium_models()[kind]->words(*f.scene.medium));
            },
            [](Scene& s) { s.medium.reset(); },
            model.before,
            model.with,
            nullptr,
            kind == 0 ? medium_keys() : std::vector<SceneKey>{}};
}

bool can_be_polarised_here(const Scene& s) { return can_be_polarised(*s.medium); }
bool has_faraday(const Scene& s) { return is_polarised(*s.medium); }

Feature polarised_feature() {
    return {
        {Effect::kMediumPolarisation, "medium-polarisation", "EFFECT_MEDIUM_POLARISATION",
         "I, Q, U and V of the light of matter are transferred.", "medium.polarisation is \"on\"",
         "two dozen exponentials and roots a sample, and its Stokes parameters"},
        [](const FrameFacts& f) { return reason_if(has_polarised_medium(f.scene), "medium.polarisation = \"on\""); },
        [](Scene& s) {
            if (s.medium) s.medium->polarisation = false;
        },
        [](Scene& s) {
            medium_by_formula(s);
            s.medium->emission = MediumEmission::kSynchrotron;
            s.medium->field_direction = FieldDirection::kEast;
        },
        [](Scene& s) { s.medium->polarisation = true; },
        nullptr,
        {{"medium", "field_vector", KeyType::kPoint, "", "[0, 0, 1]", closed(-1.0, 1.0), "",
          "Direction of the field: its radial, azimuthal (with growing phi) and vertical (north) component. Needs "
          "field_direction = \"vector\".",
          [](auto& s) { return &s.medium->field_vector; },
          [](const Scene& s) { return is_synchrotron(s) && s.medium->field_direction == FieldDirection::kVector; },
          "field_direction = \"vector\""},
         on_off_key(
             "medium", "polarisation", "off",
             "Whether Stokes parameters I, Q, U and V of synchrotron light are transferred, with polarised "
             "absorption. Needs emission = \"synchrotron\" and a field_direction other than isotropic.",
             [](auto& s) { return &s.medium->polarisation; }, can_be_polarised_here, kDirected),
         on_off_key(
             "medium", "faraday", "on",
             "Faraday rotation and conversion by the same electrons. Needs polarisation = \"on\".",
             [](auto& s) { return &s.medium->faraday; }, has_faraday, "polarisation = \"on\"")}};
}

Feature bands_feature() {
    return {
        {Effect::kMediumBands, "medium-bands", "EFFECT_MEDIUM_BANDS",
         "Matter along rays is seen at two or three frequencies at once, as colours.",
         "medium.frequency has several, all are shown, and its light is not polarised",
         "of each frequency the emission law once more a sample"},
        [](const FrameFacts& f) -> Reason {
            if (!shows_bands(f.scene)) return kNot;
            return fmt::format("medium.frequency = {}", frequency_words(*f.scene.medium));
        },
        [](Scene& s) {
            if (s.medium) s.medium->bands_GHz.clear();
        },
        [](Scene& s) {
            massive_hole(s);
            s.medium.emplace().kind = MediumKind::kFlow;
        },
        [](Scene& s) {
            s.medium->bands_GHz = {86.0, 230.0, 345.0};
        },
        nullptr,
        {{"medium",
          "shown_band",
          KeyType::kWhole,
          "",
          "0",
          closed(0.0, kMostNumbers),
          "",
          "Which of several frequencies pictures show, from 1; 0: all as colours, the lowest red, the highest blue, of "
          "polarised light the first. Needs a frequency of several.",
          {[](const Scene& s) { return KeyValue{.width = s.medium->shown_band}; },
           [](Scene& s, const KeyValue& value) {
               s.medium->shown_band = value.width;
               settle_bands(*s.medium);
           }},
          has_bands,
          "several frequencies, as frequency = [86, 230]"}}};
}

std::vector<Feature> all_features() {
    std::vector<Feature> features = [&]<std::size_t... kind>(std::index_sequence<kind...>) {
        return std::vector<Feature>{model_feature<kind>()...};
    }
    (std::make_index_sequence<kMediumKinds>{});
    features.push_back({{Effect::kMediumMotion, "medium-motion", "EFFECT_MEDIUM_MOTION", "The medium depends on time.",
                         "medium.flow is \"kepler\", medium.light \"slow\", or a formula of matter asks for t",
                         "of gas two exponentials and roots an octave of each sample"},
                        [](const FrameFacts& f) -> Reason {
                            const char* key = f.scene.medium ? medium_moves(*f.scene.medium) : nullptr;
                            if (key == nullptr) return kNot;
                            if (f.gas()) return "medium.flow = \"kepler\"";
                            return has_slow_light(f.scene) ? "medium.light = \"slow\""
                                                           : fmt::format("{} asks for t", key);
                        },
                        [](Scene& s) {
                            if (!s.medium) return;
                            s.medium->gas.flow = DiscFlowKind::kStill;
                            if (medium_moves(*s.medium) != nullptr) s.medium.reset();
                        },
                        [](Scene& s) {
                            s.spacetime.metric = "schwarzschild";
                            s.light.shift = s.light.beaming = s.light.delay = false;
                            s.medium.emplace();
                        },
                        [](Scene& s) { s.medium->gas.flow = DiscFlowKind::kKepler; }});
    features.push_back({{Effect::kMediumBlackBody, "medium-black-body", "EFFECT_MEDIUM_BLACK_BODY",
                         "Matter along rays is a black body of its temperature.", "medium.emission is \"black-body\"",
                         "one fetch a sample"},
                        [](const FrameFacts& f) {
                            return reason_if(f.has_emission(MediumEmission::kBlackBody),
                                             "medium.emission = \"black-body\"");
                        },
                        [](Scene& s) {
                            if (s.medium) s.medium->emission = MediumEmission::kPowerLaw;
                        },
                        [](Scene& s) {
                            medium_by_formula(s);
                            s.light.shift = s.light.beaming = false;
                        },
                        [](Scene& s) { s.medium->emission = MediumEmission::kBlackBody; }});
    features.push_back({{Effect::kMediumSynchrotron, "medium-synchrotron", "EFFECT_MEDIUM_SYNCHROTRON",
                         "Matter along rays shines by synchrotron radiation.", "medium.emission is \"synchrotron\"",
                         "a dozen exponentials and roots a sample"},
                        [](const FrameFacts& f) {
                            return reason_if(f.has_emission(MediumEmission::kSynchrotron),
                                             fmt::format("medium.emission = \"synchrotron\" at {}",
                                                         f.scene.medium ? frequency_words(*f.scene.medium) : ""));
                        },
                        [](Scene& s) {
                            if (s.medium) s.medium->emission = MediumEmission::kPowerLaw;
                        },
                        medium_by_formula,
                        [](Scene& s) { s.medium->emission = MediumEmission::kSynchrotron; }});
    features.push_back(polarised_feature());
    features.push_back(bands_feature());
    features.push_back(electrons_feature());
    return features;
}

}  // namespace

std::span<const Feature> medium_features() {
    static const std::vector<Feature> features = all_features();
    return features;
}

}  // namespace nullscope
