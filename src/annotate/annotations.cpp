#include "annotate/annotations.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>

#include "annotate/metric_words.h"
#include "observer/picture_scale.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

constexpr double kMostOfWhole = 0.25, kMostOfHalf = 1.0 / 3.0;  // of the width: the longest bar

struct LightWords {
    bool LightSpec::*member;
    std::string_view off, on;
};
constexpr std::array kLight = {
    LightWords{&LightSpec::delay, "light delay off", "light delay on"},
    LightWords{&LightSpec::lensing, "lensing off", "lensing on"},
    LightWords{&LightSpec::aberration, "aberration off", "aberration on"},
    LightWords{&LightSpec::doppler, "Doppler shift off", "Doppler shift on"},
    LightWords{&LightSpec::gravity, "gravitational redshift off", "gravitational redshift on"},
    LightWords{&LightSpec::shift, "colour shift off", "colour shift on"},
    LightWords{&LightSpec::beaming, "beaming off", "beaming on"},
    LightWords{&LightSpec::bolometric, "visible light", "all wavelengths"},
};

using Labels = std::pair<std::string, std::string>;

void add(Labels& labels, std::string_view left, std::string_view right) {
    const char* comma = labels.first.empty() ? "" : ", ";
    labels.first.append(comma).append(left);
    labels.second.append(comma).append(right);
}

std::string capitalised(std::string words) {
    if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

Labels what_differs(const Scene& left, const Scene& right) {
    Labels labels;
    if (left.spacetime != right.spacetime)
        add(labels, metric_words(left.spacetime, right.spacetime), metric_words(right.spacetime, left.spacetime));
    for (const LightWords& part : kLight) {
        const bool here = left.light.*part.member, there = right.light.*part.member;
        if (here != there) add(labels, here ? part.on : part.off, there ? part.on : part.off);
    }
    if (labels.first.empty() && left.name != right.name) return {left.name, right.name};
    return {capitalised(labels.first), capitalised(labels.second)};
}

// What the bar counts: one of it in r_s, and how a number of it is written.
struct BarUnit {
    double length;
    std::string (*words)(double number);
};

std::string angle_words(double microarcseconds) {
    if (microarcseconds >= 1e6) return fmt::format("{:g}″", 1e-6 * microarcseconds);
    if (microarcseconds >= 1e3) return fmt::format("{:g} mas", 1e-3 * microarcseconds);
    return fmt::format("{:g} µas", microarcseconds);
}

std::optional<BarUnit> bar_unit(const Scene& scene) {
    switch (scene.picture.scale_bar) {
        case ScaleBar::kOff: break;
        case ScaleBar::kMass: return BarUnit{0.5, [](double n) { return fmt::format("{:g} M", n); }};
        case ScaleBar::kRadius: return BarUnit{1.0, [](double n) { return fmt::format("{:g} rₛ", n); }};
        case ScaleBar::kAngle:
            if (const auto length = length_of_microarcsecond(scene.object)) return BarUnit{*length, angle_words};
            break;
    }
    return std::nullopt;
}

std::optional<ScaleBarMark> bar_of(const Scene& scene, double most_px) {
    constexpr int kLeastPower = -12, kMostPower = 18;
    const auto unit = bar_unit(scene);
    if (!unit) return std::nullopt;
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    const auto scale = spacetime ? picture_scale(**spacetime, scene.camera) : std::nullopt;
    if (!scale) return std::nullopt;
    for (int power = kMostPower; power >= kLeastPower; --power)
        for (const double digit : {5.0, 2.0, 1.0}) {
            const double number = digit * std::pow(10.0, power), length = number * unit->length;
            if (0.5 * length * scale->sine >= 1.0) continue;
            if (const double px = scale->px(length); px <= most_px) return ScaleBarMark{px, unit->words(number)};
        }
    return std::nullopt;
}

}  // namespace

double length_of_microarcsecond(double mass_suns, double distance_pc) {
    constexpr double kMicroarcsecond = 3.14159265358979323846 / 180.0 / 3600.0 * 1e-6;  // rad
    constexpr double kParsec = 3.0856775814913673e16;                                   // m
    return kMicroarcsecond * distance_pc * kParsec / schwarzschild_radius_m(mass_suns);
}

std::optional<double> length_of_microarcsecond(const ObjectSpec& object) {
    const auto mass = object.mass(), distance = object.distance();
    if (!mass || !distance) return std::nullopt;
    return length_of_microarcsecond(*mass, *distance);
}

Annotations annotations_of(const Scene& scene, const std::optional<Halves>& halves) {
    Annotations all;
    const Scene& first = halves ? halves->left : scene;
    all.bar = bar_of(first, (halves ? kMostOfHalf : kMostOfWhole) * first.camera.width);
    if (!halves) return all;
    all.divided = true;
    if (!scene.split_labels.shown) return all;
    std::tie(all.left, all.right) = what_differs(halves->left, halves->right);
    if (!scene.split_labels.left.empty()) all.left = scene.split_labels.left;
    if (!scene.split_labels.right.empty()) all.right = scene.split_labels.right;
    return all;
}

}  // namespace nullscope
