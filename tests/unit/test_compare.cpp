// The measures themselves, on frames whose answer is known.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "base/atomic_file.h"
#include "compare/heat_map.h"
#include "compare/image_metrics.h"
#include "compare/ray_channels.h"
#include "compare/ray_metrics.h"
#include "compare/remembered_trace.h"
#include "support/report.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;

constexpr double kFloat = 1e-6;            // measures are kept as float
constexpr double kCompareRounding = 1e-6;  // px; rounding of unit vectors over the smallest motion per pixel used here
constexpr float kInf = std::numeric_limits<float>::infinity();

Vec3 direction(double azimuth, double latitude) {
    return {std::cos(latitude) * std::cos(azimuth), std::cos(latitude) * std::sin(azimuth), std::sin(latitude)};
}

RayPixel escaped(Vec3 sky) {
    RayPixel p;
    p.fate = Fate::kEscaped;
    p.sky = sky;
    p.g = 1;
    return p;
}

RayPixel captured(double angle) {
    RayPixel p;
    p.fate = Fate::kCaptured;
    p.angle = angle;
    return p;
}

// The sky turns by by_x rad a px to the right and by by_y rad a px down, at the equator.
ExactPixel moving(double by_x, double by_y, double pixel) {
    ExactPixel exact;
    exact.here = escaped(direction(0, 0));
    exact.right = escaped(direction(by_x * 1e-4, 0));
    exact.down = escaped(direction(0, by_y * 1e-4));
    exact.right_px = exact.down_px = 1e-4;
    exact.pixel_angle = pixel;
    return exact;
}

TEST_CASE("compare: forward error is the angle, small and straight") {
    const ExactPixel exact = moving(0, 0, 1);
    for (const double angle : {1e-9, 1e-4, 1.0, M_PI / 2, 3.1}) {
        const PixelErrors errors = pixel_errors(escaped(direction(angle, 0)), exact);
        CHECK(errors.forward_rad == doctest::Approx(angle).epsilon(kFloat));
        CHECK(errors.end == RayEnd::kSame);
    }
    CHECK(pixel_errors(escaped(-direction(0, 0)), exact).forward_rad == doctest::Approx(M_PI).epsilon(kFloat));
    CHECK(pixel_errors(escaped(direction(0, 0)), exact).forward_rad == 0);
    CHECK(pixel_errors(escaped({kNotANumber, 0, 0}), exact).forward_rad == kInf);
    CHECK(pixel_errors(escaped({kNotANumber, 0, 0}), exact).sky_px == kInf);
}

TEST_CASE("compare: screen error divides by the motion per pixel, at least what a pixel spans") {
    constexpr double kPixel = 1e-3, kError = 1e-5;
    // No stretch: error over the pixel's angle, also where the sky is squeezed.
    CHECK(pixel_errors(escaped(direction(kError, 0)), moving(kPixel, kPixel, kPixel)).sky_px ==
          doctest::Approx(0.01).epsilon(kFloat));
    CHECK(pixel_errors(escaped(direction(kError, 0)), moving(1e-9, 0, kPixel)).sky_px ==
          doctest::Approx(0.01).epsilon(kFloat));
    // Stretched a hundredfold along the error; then across it, which does not excuse it.
    CHECK(pixel_errors(escaped(direction(kError, 0)), moving(0.1, kPixel, kPixel)).sky_px ==
          doctest::Approx(1e-4).epsilon(1e-4));
    CHECK(pixel_errors(escaped(direction(0, kError)), moving(0.1, kPixel, kPixel)).sky_px ==
          doctest::Approx(0.01).epsilon(1e-4));
    // Both ways at once: parts add as lengths.
    const float both = pixel_errors(escaped(direction(100 * kError, kError)), moving(0.1, kPixel, kPixel)).sky_px;
    CHECK(both == doctest::Approx(0.01 * std::sqrt(2)).epsilon(1e-3));
    // Motion turned by 45 degrees: x and y pixels move along the same diagonal.
    ExactPixel diagonal = moving(0, 0, kPixel);
    diagonal.right = diagonal.down = escaped(direction(1e-5, 1e-5));
    const double along = std::sqrt(2) * std::sqrt(2) * 0.1;  // length of the diagonal, two columns of it
    CHECK(pixel_errors(escaped(direction(kError, kError)), diagonal).sky_px ==
          doctest::Approx(std::sqrt(2) * kError / along).epsilon(1e-3));
    CHECK(pixel_errors(escaped(direction(kError, -kError)), diagonal).sky_px ==
          doctest::Approx(std::sqrt(2) * kError / kPixel).epsilon(1e-3));
}

TEST_CASE("compare: place on the disc, swept angle and frequency in pixels") {
    ExactPixel exact;
    exact.here.fate = Fate::kHit;
    exact.here.hit = 1;
    exact.here.u = 6;
    exact.pixel_angle = 1e-3;
    exact.camera = {6, 0, 8};  // 8 from the hit: a pixel spans 8e-3
    RayPixel tested = exact.here;
    tested.v = 8e-5;
    tested.angle = 1e-5;
    CHECK(pixel_errors(tested, exact).place_px == doctest::Approx(0.01).epsilon(kFloat));
    CHECK(pixel_errors(tested, exact).angle_px == doctest::Approx(0.01).epsilon(kFloat));
    exact.down = exact.here;
    exact.down.v = 8e-4;      // 0.8 a px
    exact.down.angle = 1e-4;  // 0.1 a px
    exact.down_px = 1e-3;
    CHECK(pixel_errors(tested, exact).place_px == doctest::Approx(1e-4).epsilon(kFloat));
    CHECK(pixel_errors(tested, exact).angle_px == doctest::Approx(1e-4).epsilon(kFloat));
    ExactPixel sky = moving(0, 0, 1e-3);
    RayPixel bluer = sky.here;
    bluer.g = std::exp(1e-5);
    CHECK(pixel_errors(bluer, sky).g_px == doctest::Approx(0.01).epsilon(kFloat));
    bluer.g = -1;
    CHECK(pixel_errors(bluer, sky).g_px == kInf);
    CHECK(pixel_errors(captured(1), sky).end == RayEnd::kDiffers);
    CHECK(pixel_errors(captured(1), sky).worst_px() == kInf);
}

TEST_CASE("compare: percentiles of known sets, NaN as infinite") {
    std::vector<float> values(1000);
    for (int i = 0; i < 1000; ++i)
        values[static_cast<std::size_t>(i)] = static_cast<float>((i * 7919) % 1000 + 1);  // 1 ... 1000 mixed
    const Spread spread = spread_of(values);
    CHECK(spread.max == 1000);
    CHECK(spread.p999 == 999);
    CHECK(spread.median == 500);
    CHECK(spread.count == 1000);
    CHECK(spread_of({}).count == 0);
    CHECK(spread_of({2}).median == 2);
    CHECK(spread_of({1, 2, std::numeric_limits<float>::quiet_NaN()}).max == kInf);
    CHECK(spread_of({1, 2, std::numeric_limits<float>::quiet_NaN()}).median == 2);
}

// A stand-in for the reference: a flat sky, captured left of edge_px.
struct FlatSky {
    double edge_px, pixel;
    std::vector<RayPixel> operator()(const std::vector<std::array<double, 2>>& positions) const {
        std::vector<RayPixel> pixels;
        for (const auto& p : positions)
            pixels.push_back(p[0] < edge_px ? captured(0) : escaped(direction(p[0] * pixel, p[1] * pixel)));
        return pixels;
    }
};

CameraSpec small_camera() {
    CameraSpec camera;
    camera.width = 16;
    camera.height = 12;
    camera.plane_width = 16e-3;
    return camera;
}

RayFrame flat_frame(const CameraSpec& camera, const FlatSky& sky) {
    RayFrame frame{camera.width, camera.height, {}};
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) frame.pixels.push_back(sky({{x + 0.5, y + 0.5}})[0]);
    return frame;
}

TEST_CASE("compare: a fate is forgiven within the band around the exact edge and not beyond") {
    const CameraSpec camera = small_camera();
    for (const double off : {0.005, 0.0095, 0.011, 0.4}) {
        const RayFrame tested = flat_frame(camera, {8.5 - off, 1e-3});  // column 8 escapes
        const RayMeasures m = measure_rays(tested, camera, FlatSky{8.5 + off, 1e-3});
        CHECK(m.fate_errors == (off < kFateBand_px ? 0 : camera.height));
        CHECK(m.forgiven == (off < kFateBand_px ? camera.height : 0));
        CHECK(m.sky_px.max < kCompareRounding);
        CHECK(m.not_finite == 0);
    }
}

TEST_CASE("compare: a frame's errors land where they were put") {
    const CameraSpec camera = small_camera();
    const FlatSky sky{0, 1e-3};
    RayFrame tested = flat_frame(camera, sky);
    tested.pixels[5 * 16 + 3].sky = direction((3 + 0.5 + 0.25) * 1e-3, 5.5e-3);  // a quarter of a pixel to the right
    tested.pixels[7].delay = kNotANumber;
    const RayMeasures m = measure_rays(tested, camera, sky);
    CHECK(m.sky_px.max == doctest::Approx(0.25).epsilon(1e-3));
    CHECK(m.sky_px.median < kCompareRounding);
    CHECK(m.sky_px.count == 16 * 12);
    CHECK(m.not_finite == 1);
    const auto worst = worst_pixels(m, 2);
    REQUIRE(worst.size() == 2);
    CHECK(worst[0].x == 3);
    CHECK(worst[0].y == 5);
    // Rows can be left out.
    const RayMeasures even = measure_rays(tested, camera, sky, 2);
    CHECK(even.sky_px.max < kCompareRounding);
    CHECK(even.sky_px.count == 16 * 6);
    CHECK(even.at(3, 5).end == RayEnd::kNotCompared);
    // Without a trace: the same from the neighbours.
    const RayMeasures frames = measure_ray_frames(tested, flat_frame(camera, sky), [](int, int) { return 1e-3; }, {});
    CHECK(frames.sky_px.max == doctest::Approx(0.25).epsilon(1e-3));
    CHECK(estimated_pixel_angle(flat_frame(camera, sky)) == doctest::Approx(1e-3).epsilon(1e-3));
}

TEST_CASE("compare: where neighbours say too little, displaced rays are traced, but not of another camera") {
    const CameraSpec camera = small_camera();
    // The sky runs through 1.9 turns from pixel to pixel, which between neighbours look like 0.1 turns backward.
    constexpr double kTurns = 1.9 * 2 * M_PI, kError_px = 0.02;
    const ExactTrace fast = [](const std::vector<std::array<double, 2>>& positions) {
        std::vector<RayPixel> pixels;
        for (const auto& p : positions) pixels.push_back(escaped(direction(p[0] * kTurns, (p[1] - 5.5) * 1e-3)));
        return pixels;
    };
    RayFrame exact{camera.width, camera.height, {}};
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) exact.pixels.push_back(fast({{x + 0.5, y + 0.5}})[0]);
    RayFrame tested = exact;
    tested.pixels[5 * 16 + 3].sky = direction((3.5 + kError_px) * kTurns, 0);
    const RayMeasures traced = measure_ray_frames(tested, exact, camera, fast);
    CHECK(traced.sky_px.max == doctest::Approx(kError_px).epsilon(0.02));
    CHECK(traced.sky_px.count == 16 * 12);
    // A frame from a file has its floats, which in a narrow view may be off by more than the limit.
    RayFrame stored = exact;
    for (RayPixel& pixel : stored.pixels)
        for (double* part : {&pixel.sky.x, &pixel.sky.y, &pixel.sky.z}) *part = static_cast<float>(*part);
    CHECK(measure_ray_frames(tested, stored, camera, fast, 1e-10).sky_px.max ==
          doctest::Approx(kError_px).epsilon(0.02));
    const RayMeasures other = measure_ray_frames(tested, exact, camera, FlatSky{0, 1e-3});
    const RayMeasures neighbours = measure_ray_frames(tested, exact, [](int, int) { return 1e-3; }, {});
    CHECK(other.sky_px.max == doctest::Approx(neighbours.sky_px.max));
    CHECK(neighbours.sky_px.max > 10 * kError_px);
}

TEST_CASE("compare: a frame's exact rays are traced once, and its errors stay what they were") {
    const CameraSpec camera = small_camera();
    // An edge through the middle of a pixel, and a sky that moves differently in every pixel.
    const ExactTrace sky = [](const std::vector<std::array<double, 2>>& positions) {
        std::vector<RayPixel> pixels;
        for (const auto& p : positions) {
            pixels.push_back(escaped(direction(p[0] * (1.0 + 0.3 * std::sin(p[1])), 1e-3 * p[1] * p[0])));
            if (p[0] + 0.2 * p[1] > 9.50004) pixels.back() = RayPixel{.fate = Fate::kCaptured};
        }
        return pixels;
    };
    std::size_t rays = 0;
    const ExactTrace counted = [&](const std::vector<std::array<double, 2>>& positions) {
        rays += positions.size();
        return sky(positions);
    };
    const ExactTrace kept = remembered(counted, camera.width, camera.height);
    for (const double error : {1e-3, 2e-2, 1e-3}) {
        RayFrame tested{camera.width, camera.height, {}};
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) tested.pixels.push_back(sky({{x + 0.5 + error, y + 0.5}})[0]);
        const RayMeasures one = measure_rays(tested, camera, sky), other = measure_rays(tested, camera, kept);
        CHECK(one.fate_errors == other.fate_errors);
        CHECK(one.forgiven == other.forgiven);
        CHECK(one.sky_px.count == other.sky_px.count);
        CHECK(other.sky_px.max == doctest::Approx(one.sky_px.max).epsilon(1e-6));
        CHECK(other.sky_px.median == doctest::Approx(one.sky_px.median).epsilon(1e-6));
        CHECK(one.sky_px.median == doctest::Approx(error).epsilon(0.02));
    }
    const std::size_t before = rays;
    RayFrame wrong{camera.width, camera.height, std::vector<RayPixel>(16 * 12)};
    for (RayPixel& pixel : wrong.pixels) pixel = escaped({0, 0, 1});
    measure_rays(wrong, camera, kept);
    CHECK(rays <= before + 16 * 16 * 12);  // but for rays round the pixels that end elsewhere
    const std::size_t after = rays;
    measure_rays(wrong, camera, kept);
    CHECK(rays == after);
}

TEST_CASE("compare: where neighbours say too little of very many pixels, the worst are traced") {
    CameraSpec camera = small_camera();
    camera.width = 200, camera.height = 150, camera.plane_width = 0.2;
    const FlatSky sky{0, 1e-3};
    const RayFrame exact = flat_frame(camera, sky);
    RayFrame tested = exact;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            tested.pixels[static_cast<std::size_t>(y) * 200 + x].sky =
                direction((x + 0.5 + (y == 7 ? 0.5 : 0.1)) * 1e-3, (y + 0.5) * 1e-3);
    std::size_t rays = 0, of_the_worst = 0;
    const RayMeasures m =
        measure_ray_frames(tested, exact, camera, [&](const std::vector<std::array<double, 2>>& positions) {
            rays += positions.size();
            of_the_worst += static_cast<std::size_t>(std::ranges::count_if(
                positions, [](const auto& p) { return p[0] == std::floor(p[0]) + 0.5 && p[1] == 7.5; }));
            return sky(positions);
        });
    CHECK(rays == 5 * kMostDisplaced);
    CHECK(of_the_worst == 200);
    CHECK(m.sky_px.max == doctest::Approx(0.5).epsilon(0.02));
    CHECK(m.sky_px.median == doctest::Approx(0.1).epsilon(0.02));
}

TEST_CASE("compare: the angle of a pixel is the root of its solid angle") {
    CameraSpec camera;
    camera.width = 40;
    camera.height = 40;
    camera.plane_width = 2;
    double sum = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) sum += std::pow(pixel_angle(camera, x + 0.5, y + 0.5), 2);
    CHECK(sum == doctest::Approx(4 * M_PI / 6).epsilon(1e-3));  // a face of the cube
}

TEST_CASE("compare: every channel of the ray data holds what its name says, and is read back, by older names too") {
    RayPixel pixel;
    pixel.fate = Fate::kHit;
    pixel.sky = {0.125, 0.25, 0.5};
    pixel.g = 2, pixel.delay = 3, pixel.angle = 5, pixel.order = 1, pixel.hit = 7, pixel.u = 8, pixel.v = 9,
    pixel.w = 10;
    using Values = std::map<std::string, float>;
    const Values same = {{"fate", 4.0f}, {"delay", 3.0f}, {"angle", 5.0f}, {"order", 1.0f}, {"hit", 7.0f}};
    Values alone = {{"sky.x", 0.125f},   {"sky.y", 0.25f},    {"sky.z", 0.5f},     {"ray.shift", 2.0f},
                    {"ray.hit_u", 8.0f}, {"ray.hit_v", 9.0f}, {"ray.hit_w", 10.0f}},
           beside = {{"direction.x", 0.125f}, {"direction.y", 0.25f}, {"direction.z", 0.5f}, {"ray.shift", 2.0f},
                     {"place.x", 8.0f},       {"place.y", 9.0f},      {"place.z", 10.0f}},
           old = {{"sky.x", 0.125f}, {"sky.y", 0.25f}, {"sky.z", 0.5f}, {"g", 2.0f},
                  {"u", 8.0f},       {"v", 9.0f},      {"w", 10.0f}};
    for (Values* names : {&alone, &beside, &old}) names->insert(same.begin(), same.end());
    ChannelImage image;
    image.width = image.height = 1;
    Values expected;
    SUBCASE("alone") { add_ray_channels({1, 1, {pixel}}, RayNames::kAlone, image), expected = alone; }
    SUBCASE("beside layers") { add_ray_channels({1, 1, {pixel}}, RayNames::kBesideLayers, image), expected = beside; }
    SUBCASE("old") {
        for (const auto& [name, value] : old) image.channels[name] = {value};
        expected = old;
    }
    CHECK(image.channels.size() == expected.size());
    for (const auto& [key, value] : expected) {
        const std::string name = key;  // clang 14 captures no structured binding
        CAPTURE(name);
        REQUIRE(image.channels.count(name) == 1);
        CHECK(image.channels.at(name) == std::vector<float>{value});
    }
    const auto frame = ray_frame_from(image);
    REQUIRE(frame);
    const RayPixel& back = frame->pixels.at(0);
    CHECK(back.fate == pixel.fate);
    CHECK(back.w == pixel.w);
    CHECK(length(back.sky - pixel.sky) == 0);
    CHECK(back.g == 2);
    CHECK(back.delay == 3);
    CHECK(back.angle == 5);
    CHECK(back.order == 1);
    CHECK(back.hit == 7);
    CHECK(back.u == 8);
    CHECK(back.v == 9);
    image.channels.erase(expected.contains("g") ? "g" : "ray.shift");
    const auto cut = ray_frame_from(image);
    REQUIRE_FALSE(cut);
    CHECK(cut.error().what == "no ray data: channel \"ray.shift\" is missing");
}

TEST_CASE("compare: pictures") {
    Image<float> a(4, 2, 3), b(4, 2, 3);
    b.at(1, 1)[2] = 0.5f;
    auto m = measure_images(a, b, 0.1);
    REQUIRE(m);
    CHECK(m->max == 0.5);
    CHECK(m->mean == doctest::Approx(0.5 / 24));
    CHECK(m->fraction_above == doctest::Approx(1.0 / 8));
    CHECK(m->psnr_db == doctest::Approx(10 * std::log10(24 / 0.25)));
    CHECK(*m->difference.at(1, 1) == 0.5f);
    CHECK(measure_images(a, a, 0.1)->psnr_db == kInf);
    b.at(0, 0)[0] = std::numeric_limits<float>::quiet_NaN();
    CHECK(measure_images(a, b, 0.1)->max == kInf);
    CHECK(!measure_images(a, Image<float>(2, 4, 3), 0.1));
    CHECK(!measure_images(a, Image<float>(4, 2, 1), 0.1));
}

TEST_CASE("compare: heat map colours and legend") {
    Image<float> values(3, 1, 1);
    values.data = {0, 100, kInf};
    const Image<unsigned char> map = heat_map(values, {1e-2, 1});
    CHECK(map.width == kHeatMapWidth);
    CHECK(map.height == 1 + kLegendHeight);
    CHECK(map.at(0, 0)[0] == 0);
    CHECK(map.at(1, 0)[1] == 255);
    CHECK(map.at(2, 0)[0] == 255);
    CHECK(map.at(2, 0)[1] == 0);
}

TEST_CASE("compare: the report names the culprit and holds its pictures") {
    CHECK(base64("") == "");
    CHECK(base64("M") == "TQ==");
    CHECK(base64("Ma") == "TWE=");
    CHECK(base64("Man") == "TWFu");
    CHECK(html_text("a<b & \"c\"") == "a&lt;b &amp; &quot;c&quot;");
    const ExactPixel exact = moving(1e-3, 1e-3, 1e-3);
    Witnesses w{exact.here, exact.here, exact.here, escaped(direction(1e-4, 0))};
    CHECK(verdict_of(w, exact).driver_px == doctest::Approx(0.1).epsilon(1e-3));
    CHECK(std::string(verdict_of(w, exact).culprit()) == "driver");
    w.core32 = w.gl;
    CHECK(std::string(verdict_of(w, exact).culprit()) == "float");
    w.core64 = w.gl;
    CHECK(std::string(verdict_of(w, exact).culprit()) == "table");
    w.core64 = w.core32 = captured(0);
    CHECK(verdict_of(w, exact).driver_px == kInf);

    const TemporaryFolder folder("report");
    FailureReport report{"first <light>", {"too far"}, {{"the picture", Image<unsigned char>(2, 2, 3)}}, {}};
    report.pixels.push_back({1, 2, pixel_errors(w.gl, exact), w, verdict_of(w, exact)});
    const auto path = folder.path / "deep" / "report.html";
    REQUIRE(save_report(path, report));
    const auto html = read_text(path);
    REQUIRE(html);
    CHECK(html->find("first &lt;light&gt;") != std::string::npos);
    CHECK(html->find("data:image/png;base64,iVBORw0KGgo") != std::string::npos);
    CHECK(html->find("core64") != std::string::npos);
    CHECK(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}) ==
          1);  // nothing is left beside it
}

}  // namespace
