// The loop of Q and U: its shape, how often it turns, and the sum over a picture.
#include <doctest/doctest.h>

#include <cmath>

#include "compare/stokes_loop.h"
#include "scene/projection.h"

using namespace nullscope;

namespace {

// One turn of t in `steps` steps, the last point the first again.
template <class Curve>
StokesLoop loop_of(int steps, const Curve& curve) {
    StokesLoop loop;
    for (int i = 0; i <= steps; ++i) {
        const double t = 2.0 * M_PI * i / steps;
        const auto [q, u] = curve(t);
        loop.push_back({t, 2.0, q, u});
    }
    return loop;
}

}  // namespace

TEST_CASE("loop of Q and U: its direction turns once round an oval, twice with a smaller loop within") {
    // Limacons r = a + cos(t): of a < 1 they have an inner loop.
    const auto limacon = [](double a, double way) {
        return loop_of(48, [=](double t) {
            return std::array{(a + std::cos(t)) * std::cos(t), way * (a + std::cos(t)) * std::sin(t)};
        });
    };
    CHECK(loop_turns(limacon(3.0, 1.0)) == 1);
    CHECK(loop_turns(limacon(0.5, 1.0)) == 2);
    CHECK(loop_turns(limacon(0.5, -1.0)) == -2);
    // A spot far out and face-on: the same circle twice.
    CHECK(loop_turns(loop_of(17, [](double t) { return std::array{std::cos(2 * t), std::sin(2 * t)}; })) == 2);
    CHECK(loop_turns(loop_of(48, [](double t) { return std::array{std::sin(t), std::sin(2 * t)}; })) == 0);  // an eight
}

TEST_CASE("loop of Q and U: half of one is not closed, and turns are not counted") {
    StokesLoop half = loop_of(24, [](double t) { return std::array{std::cos(0.5 * t), std::sin(0.5 * t)}; });
    CHECK_FALSE(is_closed(half));
    CHECK(loop_turns(half) == 0);
    CHECK(is_closed(loop_of(24, [](double t) { return std::array{std::cos(t), std::sin(t)}; })));
    CHECK_FALSE(is_closed({}));
    CHECK_FALSE(is_closed({{0, 1, 0, 0}, {1, 1, 1, 0}, {2, 1, 0, 0}}));
}

TEST_CASE("loop of Q and U: its shape is over the mean of I") {
    const auto shape = loop_shape({{0, 1, 0.5, -0.5}, {1, 3, 1.0, 0.0}});
    CHECK(shape == std::vector<std::array<double, 2>>{{0.25, -0.25}, {0.5, 0.0}});
    CHECK(loop_shape({{0, 0, 0, 0}}) == std::vector<std::array<double, 2>>{{0, 0}});
}

TEST_CASE("loop of Q and U: sums are over the solid angle of the pixels of a part") {
    CameraSpec camera;
    camera.width = 5, camera.height = 4;
    Image<float> stokes(5, 4, 4);
    for (std::size_t i = 0; i < stokes.data.size(); ++i) stokes.data[i] = static_cast<float>(i) - 20.0f;
    StokesPoint meant;
    for (int y = 1; y < 3; ++y)
        for (int x = 2; x < 5; ++x) {
            const double angle = pixel_solid_angle(camera, x + 0.5, y + 0.5), first = 4 * (5 * y + x) - 20;
            meant.i += angle * first, meant.q += angle * (first + 1), meant.u += angle * (first + 2);
        }
    const StokesPoint sum = stokes_sum(stokes, camera, {2, 1, 5, 3}, 7.0);
    CHECK(sum.time == 7.0);
    CHECK(sum.i == doctest::Approx(meant.i).epsilon(1e-12));
    CHECK(sum.q == doctest::Approx(meant.q).epsilon(1e-12));
    CHECK(sum.u == doctest::Approx(meant.u).epsilon(1e-12));
}
