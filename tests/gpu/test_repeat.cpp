// The same frame is the same bits: from draw to draw, from renderer to renderer, and between contexts to a rounding.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// Between drivers' builds: one rounding of a number of order one.
constexpr double kFloatRounding = 1.2e-7;

struct Drawn {
    Image<float> linear;
    Image<unsigned char> display;
    RayFrame rays;
};

Drawn draw(GpuSession& session, const Scene& scene) {
    RayFrame rays = gl_ray_data(session, scene);
    return {session.renderer->picture(), session.renderer->picture8(), std::move(rays)};
}

Scene small(const std::string& name) {
    auto scene = load_scene(name);
    REQUIRE(scene);
    scene->camera.width = 240;
    scene->camera.height = 135;
    return *scene;
}

double largest_difference(const RayFrame& a, const RayFrame& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const RayPixel &p = a.pixels[i], &q = b.pixels[i];
        if (!same_end(p, q)) return INFINITY;
        const double scale = std::max({1.0, std::abs(p.angle), std::abs(p.g), std::hypot(p.u, p.v)});
        for (const double d :
             {length(p.sky - q.sky), p.g - q.g, p.angle - q.angle, p.u - q.u, p.v - q.v, p.delay - q.delay})
            largest = std::max(largest, std::abs(d) / scale);
    }
    return largest;
}

bool same_bits(const Image<float>& a, const Image<float>& b) {
    return a.data.size() == b.data.size() &&
           std::memcmp(a.data.data(), b.data.data(), a.data.size() * sizeof(float)) == 0;
}

const std::string kScenes[] = {"first-light", "sky-only", "flat", "fast-flyby", "translucent-disc", "kerr-planet"};

void check_same(const Drawn& a, const Drawn& b) {
    CHECK(same_bits(a.linear, b.linear));
    CHECK(a.display.data == b.display.data);
    CHECK(largest_difference(a.rays, b.rays) == 0);
}

void check_close(const Drawn& a, const Drawn& b) {
    CHECK(largest_difference(a.rays, b.rays) <= kFloatRounding);
    float largest = 0;
    for (std::size_t i = 0; i < a.linear.data.size(); ++i) {
        const float difference = std::abs(a.linear.data[i] - b.linear.data[i]);
        largest = std::max(largest, difference / std::max(1.0f, b.linear.data[i]));
    }
    CHECK(largest <= kFloatRounding);
}

// A new renderer a frame: one that has drawn other scenes may keep a finer sky than this one calls for.
TEST_CASE("repeat: the same bits from draw to draw and renderer to renderer, EGL and OSMesa to one float rounding" *
          test::costly()) {
    Selection selection(2);
    for (const std::string& name : kScenes) {
        if (!selection.takes_next()) continue;
        CAPTURE(name);
        const Scene scene = small(name);
        std::optional<Drawn> first;
        on_all_contexts([&](GpuSession& session) {
            Drawn drawn = draw(session, scene);
            check_same(drawn, draw(session, scene));
            if (first) {
                check_close(*first, drawn);
                return;
            }
            session.renderer = std::make_unique<Renderer>();
            check_same(drawn, draw(session, scene));
            first = std::move(drawn);
        });
    }
}

TEST_CASE("repeat: a picture does not depend on what was drawn before it" * test::costly()) {
    on_all_contexts([](GpuSession& session) {
        const Scene scene = small("sky-only");
        Scene large = scene;
        large.camera.width = 1920;
        large.camera.height = 1080;
        const Drawn before = draw(session, scene);
        draw(session, large);  // calls for a finer sky
        check_same(before, draw(session, scene));
    });
}

}  // namespace
