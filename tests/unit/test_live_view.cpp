// What the panels of telescopes show: curve, plane, closure phases, beams, and the scale of a scene's picture.
#include <doctest/doctest.h>

#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "scenefile/scene_file.h"
#include "support/folders.h"
#include "telescope/beam.h"
#include "telescope/closure.h"
#include "telescope/live_telescope.h"
#include "telescope/stations.h"

namespace {

using namespace nullscope;

constexpr double kMicroarcsecond = M_PI / 180 / 3600e6, kWidth = 2 * 1.1774100225154747;  // sqrt(2 ln 2)

// A thin ring, its light shared between the pixels about each place; shifted to the east by `east` px.
SkyPicture ring_of(double diameter_px, double pixel, double east = 0) {
    constexpr int kSide = 128, kPlaces = 4096;
    SkyPicture picture{Image<double>(kSide, kSide, 1), pixel};
    for (int i = 0; i < kPlaces; ++i) {
        const double angle = 2 * M_PI * i / kPlaces;
        const double x = 0.5 * (kSide - 1) - east + 0.5 * diameter_px * std::cos(angle),
                     y = 0.5 * (kSide - 1) + 0.5 * diameter_px * std::sin(angle);
        const int column = static_cast<int>(x), row = static_cast<int>(y);
        for (int k = 0; k < 4; ++k) {
            const double right = k % 2 == 0 ? 1 - (x - column) : x - column,
                         down = k / 2 == 0 ? 1 - (y - row) : y - row;
            *picture.flux.at(column + k % 2, row + k / 2) += right * down / kPlaces;
        }
    }
    return picture;
}

Scene live_scene(const std::string& text) {
    const auto scene = parse_scene(text, "test.toml", "");
    REQUIRE_MESSAGE(scene, scene.error().message());
    return *scene;
}

const std::vector<Station>& array() {
    static const auto file = test::source_folder() / "assets/telescopes/eht-2017.csv";
    static const std::vector<Station> stations = *read_stations(*read_text(file), file.string());
    return stations;
}

LiveSource source_at(double pixel) {
    LiveSource source;
    source.pixel = pixel, source.place = {187.7, 12.4};
    return source;
}

}  // namespace

TEST_CASE("live view: the curve of a ring has its null where the closed form has it, at every distance and angle") {
    for (const double pixel : {0.8 * kMicroarcsecond, 1.6 * kMicroarcsecond})
        for (const double angle : {0.0, 1.0}) {
            const double diameter = 50 * pixel, null = 0.76547 / diameter;  // the first zero of J0, over pi
            const auto view = live_view(ring_of(50, pixel), {}, {.angle = angle, .longest = 3 * null});
            REQUIRE(view.minimum);
            const Baseline at = view.minimum->baseline;
            CHECK(std::hypot(at.u, at.v) == doctest::Approx(null).epsilon(1e-3));
            CHECK(std::atan2(at.u, at.v) == doctest::Approx(angle));
            CHECK(view.amplitudes.front() == doctest::Approx(1));
            CHECK(view.phases.empty());
        }
}

TEST_CASE("live view: the plane has |V| of its baselines, east and north first") {
    SkyPicture picture = ring_of(50, kMicroarcsecond);
    *picture.flux.at(20, 30) += 0.7, *picture.flux.at(90, 101) += 0.4;  // no symmetry
    constexpr int kSide = 17;
    const double longest = 9e9;
    const Image<float> plane = visibility_plane(picture, longest, kSide);
    const PictureVisibility exact(picture, PixelShape::kPoint);
    for (const int x : {0, 3, 8, 16})
        for (const int y : {0, 5, 8, 9, 16}) {
            const Baseline at{longest * (1 - 2.0 * x / 16), longest * (1 - 2.0 * y / 16)};
            CHECK(*plane.at(x, y) == doctest::Approx(std::abs(exact.at(at)[0])).epsilon(1e-5));
        }
}

TEST_CASE("live view: closure phases are those of the whole array's scans") {
    const SkyPicture picture = [] {
        SkyPicture made = ring_of(40, kMicroarcsecond, 3);
        *made.flux.at(40, 80) += 0.5;
        return made;
    }();
    const Observation day = live_day(array(), source_at(kMicroarcsecond));
    const auto triangles = triangles_of(day);
    REQUIRE(triangles.size() > 10);
    const PictureVisibility visibility(picture, PixelShape::kPoint);
    std::vector<std::complex<double>> seen;
    for (const Visibility& each : visibility.at(day.baselines)) seen.push_back(each[0]);
    const auto all = closure_phases(day, seen);
    for (const Triangle& triangle : {triangles.front(), triangles[7], triangles.back()}) {
        const auto view = live_view(picture, day, {.longest = 9e9, .triangle = triangle});
        std::size_t next = 0;
        for (const ClosurePhase& each : all) {
            if (each.stations != triangle) continue;
            REQUIRE(next < view.phases.size());
            CHECK(view.phases[next].hour == each.hour);
            CHECK(view.phases[next++].phase == doctest::Approx(each.phase).epsilon(1e-9));
        }
        CHECK(next == view.phases.size());
        const auto middle = live_view(picture, day, {.longest = 9e9, .triangle = triangle, .whole_day = false});
        REQUIRE(middle.phases.size() == 1);
        CHECK(middle.phases[0].phase == view.phases[view.phases.size() / 2].phase);
    }
}

TEST_CASE("beam: a point becomes an ellipse of its widths and angle, and keeps its light") {
    constexpr int kSide = 101, kMiddle = 50;
    Image<float> light(kSide, kSide, 3);
    light.at(kMiddle, kMiddle)[1] = 2;
    const double pixel = kMicroarcsecond;
    for (const double angle : {0.0, 0.6, 1.2, M_PI / 2, 2.3}) {
        const Beam beam{20 * pixel, 8 * pixel, angle};
        const Image<float> seen = convolved(light, pixel, beam);
        double sum = 0, along = 0, across = 0, mixed = 0, worst = 0;
        const double major = 20 / kWidth, minor = 8 / kWidth;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const double value = seen.at(x, y)[1], east = kMiddle - x, north = kMiddle - y;
                const double a = north * std::cos(angle) + east * std::sin(angle),
                             b = east * std::cos(angle) - north * std::sin(angle);
                sum += value, along += value * a * a, across += value * b * b, mixed += value * a * b;
                const double exact = 2 / (2 * M_PI * major * minor) *
                                     std::exp(-0.5 * (a * a / (major * major) + b * b / (minor * minor)));
                worst = std::max(worst, std::fabs(value - exact) * M_PI * major * minor);
                CHECK(seen.at(x, y)[0] == 0);
            }
        CHECK(sum == doctest::Approx(2).epsilon(2e-3));
        CHECK(kWidth * std::sqrt(along / sum) == doctest::Approx(20).epsilon(2e-3));
        CHECK(kWidth * std::sqrt(across / sum) == doctest::Approx(8).epsilon(2e-3));
        CHECK(std::fabs(mixed / sum) < 0.02 * major * minor);
        CHECK(worst < 0.01);
    }
}

TEST_CASE("beam: that of a longest baseline keeps what is said at half of it and at its end") {
    SkyPicture picture = ring_of(40, kMicroarcsecond);
    const double longest = 9e9;
    Image<float> light(128, 128, 1);
    for (std::size_t i = 0; i < light.data.size(); ++i) light.data[i] = static_cast<float>(picture.flux.data[i]);
    const Image<float> seen = convolved(light, picture.pixel, beam_of_baseline(longest));
    SkyPicture blurred = picture;
    blurred.flux.data.assign(seen.data.begin(), seen.data.end());
    const PictureVisibility before(picture, PixelShape::kPoint), after(blurred, PixelShape::kPoint);
    const auto kept = [&](Baseline b) { return std::abs(after.at(b)[0]) / std::abs(before.at(b)[0]); };
    CHECK(kept({0.5 * longest, 0}) == doctest::Approx(0.4105).epsilon(5e-3));
    CHECK(kept({0, -longest}) == doctest::Approx(0.0284).epsilon(5e-2));
    CHECK(convolved(light, picture.pixel, {0, 0, 0}).data == light.data);
}

TEST_CASE("live source: a pixel is as large as the object's mass and distance make it, however far the camera is") {
    const auto at = [](double r, const char* object) {
        return live_scene("[camera]\nr = " + std::to_string(r) + "\nfov = 2.0\nsize = [128, 128]\n" + object);
    };
    const char* known = "[object]\nname = \"sgr-a\"\n";
    const auto near = live_source(at(500, known)), far = live_source(at(1000, known));
    REQUIRE((near && far));
    CHECK(near->object == "Sgr A*");
    CHECK_FALSE((near->assumed_object || near->assumed_place || near->rough));
    CHECK(near->pixel == *pixel_on_sky(at(500, known)));
    CHECK(far->pixel / near->pixel == doctest::Approx(2).epsilon(2e-3));
    const auto twice = live_source(at(500, "[object]\nmass_suns = 4.297e6\ndistance_pc = 16554.0\n"));
    REQUIRE(twice);
    CHECK(near->pixel / twice->pixel == doctest::Approx(2));
    CHECK((twice->assumed_place && !twice->assumed_object));
    const auto none = live_source(at(10, ""));
    REQUIRE(none);
    CHECK((none->assumed_object && none->rough && none->object == "M87*"));
    CHECK(none->hours(1) == doctest::Approx(17.787).epsilon(1e-3));  // 2 G M/c^3 of 6.5e9 suns
    CHECK_FALSE(live_source(live_scene("[spacetime]\nmetric = \"ellis\"\n[camera]\nr = 10.0\n")));
}

TEST_CASE("live source: light is in Jy where the scene's is, and else adds up to 1") {
    Image<float> linear(2, 2, 3);
    for (float& value : linear.data) value = 0.25F;
    const SkyPicture relative = live_picture(linear, source_at(kMicroarcsecond));
    CHECK(total_flux(relative) == doctest::Approx(1));
    LiveSource source = source_at(kMicroarcsecond);
    source.unit = FluxUnit{3.0, 1, 230, 3.0};
    CHECK(total_flux(live_picture(linear, source)) == doctest::Approx(3));
    CHECK(total_flux(live_picture(Image<float>(2, 2, 3), source_at(1e-9))) == 0);
}

TEST_CASE("live telescope: a day of a view at rest, then the scene's time as it goes on") {
    LiveTelescope telescope(array());
    CHECK_FALSE(telescope.has_light());
    Scene scene = live_scene("[camera]\nr = 1e5\nfov = 0.0135\nsize = [64, 64]\n[object]\nname = \"m87\"\n");
    Image<float> light(64, 64, 3);
    light.at(20, 30)[1] = 1, light.at(40, 41)[1] = 0.6F, light.at(33, 12)[1] = 0.4F;
    REQUIRE(telescope.look(scene, light, false));
    REQUIRE(telescope.has_light());
    CHECK(telescope.triangle_words(telescope.wish().triangle) == "ALMA-LMT-SMA");
    CHECK(telescope.view().phases.size() > 20);
    CHECK(telescope.by_time().empty());
    const double first = telescope.view().phases[telescope.view().phases.size() / 2].phase;
    scene.time = 2;
    light.at(20, 30)[1] = 0.2F;
    REQUIRE(telescope.look(scene, light, true));
    REQUIRE(telescope.by_time().size() == 2);
    CHECK(telescope.by_time()[0].phase == doctest::Approx(first));
    CHECK(telescope.by_time()[1].phase != doctest::Approx(first));
    CHECK(telescope.by_time()[1].hours == doctest::Approx(2 * 17.787).epsilon(1e-3));
    TelescopeWish wish = telescope.wish();
    wish.triangle = 0;
    telescope.want(wish);
    CHECK(telescope.by_time().empty());
    scene.time = 1;
    REQUIRE(telescope.look(scene, light, false));
    CHECK(telescope.by_time().empty());  // it went back
    REQUIRE(telescope.look(scene, Image<float>(64, 64, 3), false));
    CHECK_FALSE(telescope.has_light());
    scene.camera.r = 0.5;
    CHECK_FALSE(telescope.look(scene, light, false));
    CHECK_FALSE(telescope.has_light());
}

TEST_CASE("live telescope: the picture is wished through a beam, or as the longest baseline resolves it") {
    LiveTelescope telescope(array());
    const Scene scene = live_scene("[camera]\nr = 1e5\nfov = 0.0135\nsize = [64, 64]\n[object]\nname = \"m87\"\n");
    Image<float> light(64, 64, 3);
    light.at(32, 32)[2] = 1;
    REQUIRE(telescope.look(scene, light, false));
    CHECK_FALSE(telescope.beam());
    TelescopeWish wish = telescope.wish();
    wish.through = SeenThrough::kBeam, wish.beam_uas = 30, wish.beam_ratio = 0.5;
    const int before = telescope.changes();
    telescope.want(wish);
    CHECK(telescope.changes() > before);
    CHECK(telescope.beam()->minor == doctest::Approx(15 * kMicroarcsecond));
    CHECK(telescope.through(*telescope.beam()).at(32, 32)[2] < 0.1F);
    wish.through = SeenThrough::kBaselines, wish.longest_glambda = 10;
    telescope.want(wish);
    CHECK(telescope.beam()->major == doctest::Approx(1e-10));
}

// Processor time of all threads: 30 pictures a second on two cores leave 67 core-ms for each, the picture itself included.
TEST_CASE("live telescope: what is found in a picture of 128 px takes less than 30 core-ms, its beam less than 15") {
    const SkyPicture ring = ring_of(50, kMicroarcsecond);
    Image<float> light(128, 128, 3);
    for (std::size_t i = 0; i < light.data.size(); ++i) light.data[i] = static_cast<float>(ring.flux.data[i / 3]);
    const Observation day = live_day(array(), source_at(kMicroarcsecond));
    const Triangle triangle = triangles_of(day).front();
    const auto cost_ms = [](const auto& work) {
        constexpr int kTimes = 10;
        const std::clock_t begun = std::clock();
        for (int i = 0; i < kTimes; ++i) work();
        return 1e3 * static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC / kTimes;
    };
    const auto view_of = [&](bool whole_day) {
        return cost_ms([&] { live_view(ring, day, {.longest = 12e9, .triangle = triangle, .whole_day = whole_day}); });
    };
    const double moving = view_of(false), rests = view_of(true),
                 plane = cost_ms([&] { visibility_plane(ring, 12e9, 64); }),
                 beam = cost_ms([&] {
                     convolved(light, ring.pixel, {20 * ring.pixel, 20 * ring.pixel, 0});
                 });
    MESSAGE("all ", rests, ", without the day ", moving, ", the plane ", plane, ", the beam ", beam, " core-ms");
#ifndef NULLSCOPE_SANITIZED  // of code as it ships
    CHECK(rests < 30);
    CHECK(beam < 15);
#endif
}
