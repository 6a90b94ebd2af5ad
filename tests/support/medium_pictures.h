// Pictures of matter along rays, drawn and by the reference, one ray a pixel; and how they differ.
#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "support/gpu_session.h"

namespace nullscope::test {

// One ray a pixel, at whose middle the reference looks too.
inline Scene bare_scene(const char* metric, double spin) {
    Scene scene;
    scene.picture.refine = false;
    scene.sky.kind = SkyKind::kPlain, scene.sky.material.colour = {0, 0, 0};
    scene.spacetime = {metric, {}};
    if (spin != 0) scene.spacetime.parameters["spin"] = spin;
    return scene;
}

inline Image<float> reference_picture(const Scene& scene) {
    static std::map<std::string, Image<float>> known;  // every context asks for the same
    const std::string question = question_of("render_frame", scene);
    if (const auto found = known.find(question); found != known.end()) return found->second;
    Image<float> picture(scene.camera.width, scene.camera.height, 3);
    picture.data = ReferenceMemory::of_this_run().answer<float>(question, [&] {
        auto light = reference::render_frame(scene, SkyCube(), reference::Pictures(), 1);
        REQUIRE(light);
        return std::move(light->data);
    });
    return known[question] = std::move(picture);
}

// Over the brightest of the reference's colours: the largest difference, and how many pixels differ by more than a part.
struct Difference {
    double flux, largest;
    int above;
};
inline Difference difference(const Image<float>& a, const Image<float>& reference, double part) {
    double brightest = 0, largest = 0;
    int above = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c) brightest = std::max<double>(brightest, reference.at(x, y)[c]);
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            double off = 0;
            for (int c = 0; c < 3; ++c) {
                const double one = std::abs(a.at(x, y)[c] - reference.at(x, y)[c]) / brightest;
                off = std::isfinite(one) ? std::max(off, one) : INFINITY;
            }
            largest = std::max(largest, off);
            above += off > part;
        }
    return {sum_of(a) / sum_of(reference) - 1, largest, above};
}

// What is promised of a picture: its flux and its pixels, all of them or, where `share` says so, but for this part.
struct PictureBound {
    double flux, pixel = INFINITY, share = 0;
};
// Draws a scene, prints how far it is from the reference's picture (of another scene where there is one), and checks it.
inline Difference held(GpuSession& session, const std::string& what, const Scene& scene, const PictureBound& most,
                       const Scene* exact = nullptr) {
    CAPTURE(what);
    const Image<float> reference = reference_picture(exact != nullptr ? *exact : scene);
    const Difference off = difference(picture_of(session, scene), reference, most.pixel);
    fmt::print("{}: flux {:.3e}, over the reference's {:+.1e}, pixels {:.1e}, {} above {}\n", what, sum_of(reference),
               off.flux, off.largest, off.above, most.pixel);
    CHECK(std::abs(off.flux) < most.flux);
    if (most.share > 0) CHECK(off.above <= most.share * scene.camera.width * scene.camera.height);
    if (most.share == 0) CHECK((off.largest < most.pixel || std::isinf(most.pixel)));
    return off;
}

}  // namespace nullscope::test
