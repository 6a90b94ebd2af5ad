// What the parts of hard_cases() share, and the parts that have files of their own.
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "compare/hard_cases.h"

namespace nullscope {

std::vector<HardCase> hard_metric_cases();    // the hard places of every metric but Schwarzschild
std::vector<HardCase> hard_rotating_cases();  // those of rotating holes, with and without charge

inline constexpr double kDegree = M_PI / 180;

inline constexpr std::pair<const char*, double> kViews[] = {{"inwards", 0.0}, {"across", M_PI / 2}, {"outwards", M_PI}};

inline double wide(double rad) { return 2 * std::tan(0.5 * rad); }  // a camera's plane_width for this field of view

// An odd width and height: the middle pixel looks exactly along the axis.
inline Scene hard_frame(SpacetimeSpec spacetime = {}, int width = 97, int height = 55) {
    Scene scene;
    scene.spacetime = std::move(spacetime);
    scene.sky.kind = scene.far_sky.kind = SkyKind::kBlack;
    scene.camera.width = width, scene.camera.height = height;
    return scene;
}

inline DiscSpec ring(double inner = 3, double outer = 12) { return {.inner = inner, .outer = outer}; }

// A camera that looks past the hole by yaw.
inline Scene hard_view(Scene scene, double r, double yaw, double fov) {
    scene.camera.r = r, scene.camera.yaw = yaw, scene.camera.plane_width = wide(fov);
    return scene;
}

inline void add_case(std::vector<HardCase>& list, const std::string& label, const std::string& what,
                     const std::string& why, Scene scene) {
    scene.name = label + ", " + what;
    list.push_back({scene.name, why, std::move(scene)});
}

// still: of a camera at rest.
inline void add_motions(std::vector<HardCase>& list, const std::string& label, const Scene& still,
                        const std::initializer_list<Vec3>& velocities) {
    for (const Vec3 v : velocities) {
        Scene scene = still;
        scene.camera.velocity = v;
        add_case(list, label, fmt::format("moving at ({}, {}, {}) c", v.x, v.y, v.z), "aberration on top", scene);
    }
}

}  // namespace nullscope
