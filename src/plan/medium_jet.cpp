// A jet: two cones of matter that flows out along the spin axis.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plan/medium.h"
#include "plan/medium_model.h"

namespace nullscope {
namespace {

bool is_jet(const Scene& s) { return s.medium->kind == MediumKind::kJet; }
constexpr double kLeastConeStep = 1e-2;  // of the cone's radius where it begins
constexpr std::string_view kJet = "kind = \"jet\"";

std::vector<SceneKey> jet_keys() {
    return {
        {"medium", "opening", KeyType::kNumber, "deg", "10", closed(0.5, 80.0), "",
         "Half the opening angle of a jet's cones. Needs kind = \"jet\".",
         [](auto& s) { return &s.medium->jet.opening; }, is_jet, kJet},
        {"medium", "falloff", KeyType::kNumber, "", "2", closed(-10.0, 10.0), "",
         "Exponent p of a jet's density (r/inner)^-p on the axis. Needs kind = \"jet\".",
         [](auto& s) { return &s.medium->jet.falloff; }, is_jet, kJet},
        {"medium", "lorentz", KeyType::kNumber, "", "3", closed(1.0, 1000.0), "",
         "Lorentz factor of a jet's radial outflow, relative to the local zero-angular-momentum observer. "
         "Needs kind = \"jet\".",
         [](auto& s) { return &s.medium->jet.lorentz; }, is_jet, kJet},
    };
}

// Between the rims in ln r; the width of one; how long a sample may be, over r: across a cone, along it.
struct ConeSteps {
    double length, rim, across, along;
};
ConeSteps cone_steps(const MediumSpec& m) {
    constexpr double kAcross = 0.15, kAlong = 0.03;  // of the cone's radius and of a rim; of r
    const double length = std::log(m.outer / m.inner), rim = std::min(m.edge, 0.5 * length);
    return {length, rim, kAcross * std::sin(m.jet.opening), std::min(kAlong, kAcross * rim)};
}

double jet_spans(const MediumSpec& m, double) {
    const ConeSteps steps = cone_steps(m);
    return 0.25 * steps.length / std::min(steps.across, steps.along);
}

void jet_faults(const Spacetime& spacetime, const Scene& scene, std::vector<SceneFault>& faults) {
    const auto hole = medium_hole(spacetime);
    if (hole && scene.medium->inner <= hole->outer)
        faults.push_back({"medium.inner", fmt::format("{} is not outside the horizon", scene.medium->inner),
                          fmt::format("above {:.9g}", hole->outer)});
    const MediumSpec& m = *scene.medium;
    if (m.density_scale * std::pow(m.outer / m.inner, -m.jet.falloff) > MediumGrid::kDensest)
        faults.push_back({"medium.falloff", fmt::format("{} makes the far end too dense", m.jet.falloff),
                          fmt::format("densities of at most {:g} at medium.outer", MediumGrid::kDensest)});
    constexpr double kMostSpans = 900;
    if (jet_spans(m, 0.0) > kMostSpans * m.step)
        faults.push_back(
            {"medium.opening",
             fmt::format("light along so long and narrow a jet takes {:.0f} spans", jet_spans(m, 0.0) / m.step),
             fmt::format("at most {}: by a wider or shorter jet, a wider edge or a larger step", kMostSpans)});
}

std::vector<double> jet_values(const MediumFrame& f) {
    const MediumSpec& m = f.medium();
    const ConeSteps steps = cone_steps(m);
    return {m.inner,
            m.outer,
            std::log(m.inner),
            steps.length,
            steps.rim,
            std::sin(m.jet.opening),
            std::cos(m.jet.opening),
            m.jet.falloff,
            std::sqrt((m.jet.lorentz - 1.0) * (m.jet.lorentz + 1.0)),
            m.density_scale,
            steps.across,
            steps.along};
}

}  // namespace

const MediumModel kJetModel{
    .word = "jet",
    .what = "two cones of matter that flows out along the axis",
    .effect = {medium_effect(MediumKind::kJet),
               "medium-jet",
               "EFFECT_MEDIUM_JET",
               "A jet emits and absorbs light along rays.",
               "there is a [medium] of kind \"jet\"",
               "a march along each ray, in samples of two exponentials",
               {Slot::kMedium, "medium/jet.glsl"}},
    .shares = kInner | kOuter | kEdge | kDensityScale | kLaws | kWarmth,
    .traits = {.any_density = true},
    .keys = jet_keys,
    .words = [](const MediumSpec& m) { return fmt::format("from {} to {}, a jet", m.inner, m.outer); },
    .farthest = [](const MediumSpec& m) { return m.outer; },
    .least_step = [](const MediumSpec& m) { return kLeastConeStep * std::sin(m.jet.opening) * m.inner; },
    .spans = jet_spans,
    .moves = nullptr,
    .faults = jet_faults,
    .numbers =
        "JET_INNER JET_OUTER JET_BEGIN JET_LENGTH JET_RIM JET_SINE JET_COSINE JET_FALLOFF JET_SPEED JET_DENSITY "
        "JET_ACROSS JET_ALONG",
    .values = jet_values,
    .before = massive_hole,
    .with = [](Scene& s) { s.medium.emplace().kind = MediumKind::kJet; },
};

}  // namespace nullscope
