// Random cameras as scene files, and smaller ones that still fail. A view is text first: what is written to a file is what was
// traced, to the last digit.
#pragma once
#include <array>
#include <functional>
#include <string>

#include "proof/settings.h"
#include "scene/scene.h"

namespace nullscope::proof {

// In the units of scene files: degrees, r_s, c.
struct View {
    std::string metric = "schwarzschild";
    std::map<std::string, double> parameters;
    double r = 10, theta = 60, phi = 0, yaw = 0, pitch = 0, roll = 0, fov = 60;
    std::array<double, 3> velocity{};
    bool has_disc = false;
    double inner = 3, outer = 12, opacity = 1;
    int width = 1280, height = 720;

    std::string toml(const std::string& comment) const;
    Scene scene() const;  // by way of the text
    bool possible() const;
};

// Any metric of the registry; r - 1 from 1e-4 to 1e9 and fov from 0.01 to 179 degrees log-uniform, speeds to 0.999999; half of
// the cameras aimed at the edge of the hole's shadow.
View random_view(Random& random);

// Applies one simplification after another as long as the view still fails.
View shrunk(View view, const std::function<bool(const View&)>& fails);

}  // namespace nullscope::proof
