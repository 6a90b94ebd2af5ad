// A sphere about the centre, which may pulsate.
#include <fmt/format.h>

#include "plan/body_kind.h"

namespace nullscope {
namespace {

const SphereSpec& sphere_of(const Body& body) { return std::get<SphereSpec>(body.shape); }

std::vector<SceneKey> sphere_keys() {
    return {
        {"sphere", "radius", KeyType::kNumber, "r_s", "3", kPositive, "",
         "Radius, outside the horizon; below camera.r.", [](auto& s) { return &last_body<SphereSpec>(s).radius; }},
        {"sphere", "amplitude", KeyType::kNumber, "", "0", closed(0.0, 0.5), "",
         "Amplitude of pulsation: the radius is multiplied by 1 + amplitude sin(2 pi t/period).",
         [](auto& s) { return &last_body<SphereSpec>(s).amplitude; }},
        {"sphere", "period", KeyType::kNumber, "r_s/c", "40", kPositive, "",
         "Period of the pulsation; needs amplitude.", [](auto& s) { return &last_body<SphereSpec>(s).period; },
         [](const Scene& s) { return last_body<SphereSpec>(s).amplitude > 0.0; }, "amplitude above 0"},
        {"sphere", "spin_rate", KeyType::kNumber, "c/r_s", "0", closed(-10.0, 10.0), "",
         "Angular velocity about the polar axis, in rad per r_s/c as seen from infinity: texture and caps turn with "
         "it. "
         "Below 0: towards falling phi.",
         [](auto& s) { return &last_body<SphereSpec>(s).spin_rate; }},
    };
}

BodyExtent extent(const Body& body) {
    const SphereSpec& s = sphere_of(body);
    const double least = s.radius * (1.0 - s.amplitude);
    return {least, s.radius * (1.0 + s.amplitude), least};
}

void check_sphere(const Body& body, const BodyCheck& at) {
    const auto [least, most, thinnest, height] = extent(body);
    if (!(least > at.horizon))
        at.report({"radius", fmt::format("{} is not outside the horizon", least), fmt::format("r > {}", at.horizon)});
    else if (!(most < at.scene.camera.r))
        at.report({"radius", fmt::format("the camera at r = {} is not outside of it", at.scene.camera.r),
                   "radius < camera.r"});
}

}  // namespace

const BodyKind kSphereKind{
    .key = SphereSpec::kName,
    .effect = {Effect::kSphere, "sphere", "EFFECT_SPHERE", "A solid sphere about the centre ends rays.",
               "there is a [sphere]", "some four steps along the ray where it is seen"},
    .make = [] { return Body{SphereSpec{}}; },
    .keys = sphere_keys,
    .check = check_sphere,
    .words = [](const Body& body) { return fmt::format("of radius {}", sphere_of(body).radius); },
    .extent = extent,
    .size = [](const Body& body) { return sphere_of(body).radius; },
    .moves = [](const Body& body) -> const char* {
        if (sphere_of(body).amplitude > 0.0) return "amplitude";
        return sphere_of(body).spin_rate != 0.0 ? "spin_rate" : nullptr;
    },
    .has_side = false,
};

}  // namespace nullscope
