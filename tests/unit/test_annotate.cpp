// Labels of split screens and scale bars: what they say, how long they are, and where they are drawn.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "annotate/annotations.h"
#include "annotate/marks.h"
#include "annotate/metric_words.h"
#include "annotate/ticks.h"
#include "observer/picture_scale.h"
#include "observer/pose.h"
#include "reference/reference.h"
#include "scene/projection.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_keys.h"
#include "scenefile/scene_writer.h"
#include "spacetime/registry.h"

using namespace nullscope;

namespace {

constexpr double kPi = 3.14159265358979323846;

std::pair<std::string, std::string> labels(const Scene& scene) {
    const Annotations all = annotations_of(scene, halves(scene));
    return {all.left, all.right};
}

Scene split(const std::string& metric, const MetricParameters& parameters, const std::string& other,
            const MetricParameters& others) {
    Scene scene;
    scene.spacetime = {metric, parameters};
    scene.split = SpacetimeSpec{other, others};
    return scene;
}

Scene far_scene(const std::string& metric, double r, double fov_deg) {
    Scene scene;
    scene.spacetime.metric = metric;
    scene.camera.r = r, scene.camera.theta = 0.5 * kPi;
    scene.camera.plane_width = 2.0 * std::tan(fov_deg * kPi / 360.0);
    return scene;
}

std::shared_ptr<const Spacetime> spacetime_of(const Scene& scene) {
    return *make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
}

// Column where the row through the picture's middle becomes the shadow, from `outside` towards the middle.
double shadow_edge_px(const Scene& scene, double outside) {
    double in = 0.5 * scene.camera.width, out = outside;
    while (std::abs(out - in) > 1e-3) {
        const double middle = 0.5 * (in + out);
        const auto pixel = reference::trace_pixels(scene, {{middle, 0.5 * scene.camera.height}});
        REQUIRE(pixel);
        (pixel->front().fate == Fate::kCaptured ? in : out) = middle;
    }
    return in;
}

double shadow_px(const Scene& scene) { return shadow_edge_px(scene, scene.camera.width) - shadow_edge_px(scene, 0.0); }

// What the bar's row holds of white, in px: the middle row of the mark that is not letters.
double drawn_length_px(const Mark& mark) {
    double sum = 0.0, most = 0.0;
    for (int x = 0; x < mark.rgba.width; ++x) {
        const unsigned char* pixel = mark.rgba.at(x, mark.rgba.height / 2);
        const double white = pixel[0] / 255.0 * pixel[3] / 255.0;
        sum += white, most = std::max(most, white);
    }
    return sum / most;
}

// Without a font while it lives.
class NoFont {
public:
    NoFont() { setenv("NULLSCOPE_FONT", "/no such font", 1); }
    ~NoFont() { unsetenv("NULLSCOPE_FONT"); }
    NoFont(const NoFont&) = delete;
    NoFont& operator=(const NoFont&) = delete;
};

}  // namespace

TEST_CASE("annotations: labels say what differs between the halves") {
    using Pair = std::pair<std::string, std::string>;
    CHECK(labels(split("schwarzschild", {}, "kerr", {})) == Pair("Schwarzschild", "Kerr, a = 0.9 M"));
    CHECK(labels(split("kerr", {{"spin", 0.5}}, "kerr", {{"spin", 0.998}})) ==
          Pair("Kerr, a = 0.5 M", "Kerr, a = 0.998 M"));
    CHECK(labels(split("kerr-newman", {}, "kerr-newman", {{"charge", 0.1}})) ==
          Pair("Kerr–Newman, Q = 0.6 M", "Kerr–Newman, Q = 0.1 M"));
    CHECK(labels(split("ellis", {{"throat", 2.0}}, "minkowski", {})) == Pair("Ellis wormhole", "Flat spacetime"));
    CHECK(labels(split("ellis", {{"throat", 2.0}}, "ellis", {})) ==
          Pair("Ellis wormhole, throat 2", "Ellis wormhole, throat 1"));
    Scene formula = split("formula", {}, "schwarzschild", {});
    formula.spacetime.parameters.formulas["A"] = "1 - 1/r";
    CHECK(labels(formula) == Pair("A = 1 - 1/r", "Schwarzschild"));

    Scene late = split("schwarzschild", {}, "schwarzschild", {});
    CHECK(labels(late) == Pair("", ""));
    late.split_delay = false;
    CHECK(labels(late) == Pair("Light delay on", "Light delay off"));
    late.split->metric = "minkowski";
    CHECK(labels(late) == Pair("Schwarzschild, light delay on", "Flat spacetime, light delay off"));
    late.split_labels.right = "Newton";
    CHECK(labels(late) == Pair("Schwarzschild, light delay on", "Newton"));
    late.split_labels.shown = false;
    CHECK(labels(late) == Pair("", ""));
    CHECK(annotations_of(late, halves(late)).divided);

    Scene one, other;
    one.name = "One", other.name = "Other", other.sky.kind = SkyKind::kGrid;
    const Annotations names = annotations_of(one, halves(one, other));
    CHECK((names.left == "One" && names.right == "Other"));
    CHECK(annotations_of(one, std::nullopt).empty());
}

TEST_CASE("annotations: a metric that is not known goes by its key") {
    CHECK(metric_words({"dilaton-hole", {}}, {"kerr", {}}) == "Dilaton hole");
}

TEST_CASE("annotations: microarcseconds of M87* and Sgr A*") {
    // GM/(c^2 D), computed apart with G M_sun = 1.3271244e20 m^3/s^2.
    CHECK(0.5 / length_of_microarcsecond(6.5e9, 16.8e6) == doctest::Approx(3.8190).epsilon(1e-5));
    CHECK(0.5 / length_of_microarcsecond(4.297e6, 8277.0) == doctest::Approx(5.12433).epsilon(1e-5));
}

TEST_CASE("annotations: an object's name gives mass and distance, which the scene's own replace") {
    // GM/(c^2 D) of docs/scenes.md in microarcseconds, computed apart.
    const std::map<std::string, double> angles = {
        {"m87", 3.818993252}, {"sgr-a", 5.124331471}, {"cygnus-x-1", 9.426005799e-5}, {"gargantua", 3.290209571e-4}};
    CHECK(angles.size() == kKnownObjects.size());
    std::string words = "other";
    for (const KnownObject& known : kKnownObjects) {
        CAPTURE(known.key);
        words += fmt::format(" {}", known.key);
        const auto scene = parse_scene(
            fmt::format("[camera]\nr = 1e3\nfov = 2\n[object]\nname = \"{}\"\n[picture]\nscale_bar = \"uas\"\n",
                        known.key),
            "scene.toml", {});
        REQUIRE_MESSAGE(scene, scene.error().message());
        CHECK(known_object(scene->object.name) == &known);
        const auto length = length_of_microarcsecond(scene->object);
        REQUIRE(length);
        CHECK(0.5 / *length == doctest::Approx(angles.at(std::string(known.key))).epsilon(1e-9));
        const std::string text = scene_file_text(*scene, {});
        CHECK(text.find(fmt::format("name = \"{}\"", known.key)) != std::string::npos);
        CHECK(text.find("mass_suns") == std::string::npos);
        const auto again = parse_scene(text, "scene.toml", {});
        REQUIRE(again);
        CHECK(again->object == scene->object);
    }
    const auto key = std::ranges::find_if(scene_keys(), [](const auto& k) { return full_name(k) == "object.name"; });
    CHECK(key->choices == words);

    const ObjectSpec heavier{7e9, std::nullopt, ObjectName::kM87}, nearer{std::nullopt, 16e6, ObjectName::kM87};
    CHECK((heavier.mass() == 7e9 && heavier.distance() == 16.8e6));
    CHECK((nearer.mass() == 6.5e9 && nearer.distance() == 16e6));
    CHECK_FALSE(length_of_microarcsecond(ObjectSpec{4e6, std::nullopt}));
    CHECK_FALSE(length_of_microarcsecond(ObjectSpec{}));
}

TEST_CASE("annotations: far away the bar is length/(r times a pixel), of a round number that fits") {
    for (const double r : {1e4, 1e6, 1e9}) {
        Scene scene = far_scene("kerr", r, 2000.0 / r);
        scene.object = {6.5e9, 16.8e6};
        for (const auto& [kind, unit] : {std::pair(ScaleBar::kMass, 0.5),
                                         {ScaleBar::kRadius, 1.0},
                                         {ScaleBar::kAngle, length_of_microarcsecond(6.5e9, 16.8e6)}}) {
            scene.picture.scale_bar = kind;
            const auto bar = annotations_of(scene, std::nullopt).bar;
            REQUIRE(bar);
            const double number = std::strtod(bar->words.c_str(), nullptr);
            CAPTURE(bar->words);
            // Half of r_s/r from the lapse, and the tangent's third order.
            CHECK(bar->length_px == doctest::Approx(number * unit / (r * scene.camera.pixel())).epsilon(2.0 / r));
            CHECK(bar->length_px <= 0.25 * scene.camera.width);
            CHECK(bar->length_px > 0.25 / 2.5 * scene.camera.width);
            const double digit = number / std::pow(10.0, std::floor(std::log10(number) + 1e-9));
            CHECK((std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 || std::abs(digit - 5) < 1e-9));
        }
    }
    Scene m87 = far_scene("kerr", 1000.0, 2.0);
    m87.object = {6.5e9, 16.8e6}, m87.picture.scale_bar = ScaleBar::kAngle;
    CHECK(annotations_of(m87, std::nullopt).bar->words == "50 µas");
    m87.picture.scale_bar = ScaleBar::kMass;
    CHECK(annotations_of(m87, std::nullopt).bar->words == "10 M");
    m87.picture.scale_bar = ScaleBar::kRadius;
    CHECK(annotations_of(m87, std::nullopt).bar->words == "5 rₛ");
    m87.object.distance_pc = 1.0, m87.picture.scale_bar = ScaleBar::kAngle;
    CHECK(annotations_of(m87, std::nullopt).bar->words == "1000″");
}

TEST_CASE(
    "annotations: the scale measures the shadow that the reference sees to a tenth of a pixel, rotating ones to one") {
    for (const double r : {20.0, 37.0, 1000.0}) {
        Scene scene = far_scene("schwarzschild", r, 600.0 / r);
        const auto scale = picture_scale(*spacetime_of(scene), scene.camera);
        REQUIRE(scale);
        CHECK(std::abs(scale->px(3.0 * std::sqrt(3.0)) - shadow_px(scene)) < 0.1);
        // Bardeen 1973: the equatorial photon orbits of a = 0.9 M and their impact parameters, in M.
        const double a = 0.9;
        const auto impact = [&](double sign) {
            const double x = 2.0 * (1.0 + std::cos(2.0 / 3.0 * std::acos(sign * a)));
            return std::abs((x * x * x - 3.0 * x * x + a * a * (x + 1.0)) / (a * (x - 1.0)));
        };
        scene.spacetime = {"kerr", {{"spin", a}}};
        const auto rotating = picture_scale(*spacetime_of(scene), scene.camera);
        REQUIRE(rotating);
        // Either edge by itself: the shadow is not in the middle.
        const double width_px = 0.5 * (rotating->px(impact(-1.0)) + rotating->px(impact(1.0)));
        CHECK(std::abs(width_px - shadow_px(scene)) < 1.0);
    }
}

TEST_CASE("annotations: off the centre a place's impact parameter is its ray's") {
    for (const double r : {20.0, 400.0}) {
        Scene scene = far_scene("schwarzschild", r, 600.0 / r);
        scene.camera.yaw = 0.02, scene.camera.pitch = -0.03, scene.camera.roll = 0.6;
        scene.camera.shift_x = 0.1, scene.camera.shift_y = -0.2;
        const auto spacetime = spacetime_of(scene);
        const auto scale = picture_scale(*spacetime, scene.camera);
        const auto centre = centre_px(*spacetime, scene.camera);
        REQUIRE((scale && centre));
        const Vec3 ahead =
            normalized(static_from_camera(scene.camera) * pixel_direction(scene.camera, (*centre)[0], (*centre)[1]));
        CHECK(angle_between(ahead, {-1, 0, 0}) < 1e-14);
        for (const double length : {1.0, 5.0, 10.0})
            CHECK(scale->impact(0.5 * scale->px(length)) == doctest::Approx(0.5 * length));
        CHECK(scale->length_per_px() == doctest::Approx(scale->impact(1e-3) / 1e-3).epsilon(1e-9));
        // L = b E, of a ray that is drawn: no formula of the scale's.
        scene.camera.yaw = scene.camera.pitch = 0.0;
        const auto middle = *centre_px(*spacetime, scene.camera);
        for (const double off : {40.0, 200.0}) {
            const double sine = std::sin(
                angle_between(pixel_direction(scene.camera, middle[0] + 0.6 * off, middle[1] + 0.8 * off), {0, 0, -1}));
            CHECK(scale->impact(off) == doctest::Approx(sine * r / std::sqrt(1.0 - 1.0 / r)).epsilon(1e-12));
        }
    }
}

TEST_CASE("annotations: no bar where a picture has no one scale") {
    Scene scene = far_scene("schwarzschild", 100.0, 10.0);
    scene.picture.scale_bar = ScaleBar::kMass;
    const auto has_bar = [&] { return annotations_of(scene, std::nullopt).bar.has_value(); };
    CHECK(has_bar());
    const Scene good = scene;
    scene.camera.r = 19.0;
    CHECK_FALSE(has_bar());
    scene = good, scene.camera.velocity = {0.1, 0, 0};
    CHECK_FALSE(has_bar());
    scene = good, scene.camera.observer = ObserverKind::kRain;
    CHECK_FALSE(has_bar());
    scene = good, scene.camera.yaw = 0.1;
    CHECK_FALSE(has_bar());
    scene = good, scene.spacetime.metric = "ellis";
    CHECK_FALSE(has_bar());
    scene = good, scene.picture.scale_bar = ScaleBar::kAngle;  // of nothing
    CHECK_FALSE(has_bar());
}

TEST_CASE("annotations: marks are where they should be, and as long") {
    for (const auto& size : {std::pair(320, 180), {1280, 720}, {3840, 2160}}) {
        const int width = size.first, height = size.second;
        Annotations all{true, "Left", "Right", ScaleBarMark{width * 0.2 + 0.4, "20 µas"}};
        const Marks made = make_marks(all, width, height);
        CAPTURE(height);
        CHECK(made.note == "");
        REQUIRE(made.marks.size() == 5);  // line, two labels, bar, its number
        const auto middle = [](const Mark& mark) { return mark.x + 0.5 * mark.rgba.width; };
        CHECK(std::abs(middle(made.marks[0]) - 0.5 * width) <= 1.0);
        CHECK(made.marks[1].x + made.marks[1].rgba.width < middle(made.marks[0]) + 0.02 * height + 8);
        CHECK(made.marks[2].x > middle(made.marks[0]) - 0.02 * height - 8);
        CHECK(std::abs(drawn_length_px(made.marks[3]) - all.bar->length_px) < 0.5);
        CHECK(std::abs(middle(made.marks[4]) - middle(made.marks[3])) <= 1.5);
        CHECK(made.marks[3].x + made.marks[3].rgba.width < width + 8);
    }
}

TEST_CASE("annotations: bright and dark pixels keep a contrast of letters, and other pixels their colour") {
    const Annotations all{true, "Schwarzschild", "Kerr, a = 0.9 M", std::nullopt};
    for (const auto& shade : {static_cast<unsigned char>(0), static_cast<unsigned char>(255)}) {
        Image<unsigned char> picture(640, 360, 3);
        std::fill(picture.data.begin(), picture.data.end(), shade);
        lay_over(make_marks(all, 640, 360).marks, picture);
        int white = 0, black = 0;  // of the right label's pixels
        for (int y = 0; y < 24; ++y)
            for (int x = 326; x < 416; ++x) white += *picture.at(x, y) > 180, black += *picture.at(x, y) < 120;
        CHECK(white > 80);
        CHECK(black > 50);
        for (int y = 60; y < 360; ++y) CHECK((*picture.at(300, y) == shade && *picture.at(340, y) == shade));
    }
    Image<unsigned char> small(63, 63, 3);
    const auto before = small.data;
    lay_over(make_marks(all, 63, 63).marks, small);
    CHECK(small.data == before);
}

TEST_CASE("annotations: long labels and bytes that are no text end nowhere") {
    for (const std::string& text :
         {std::string(200, 'W'), std::string("\xff\xc3\xe2\x82 \xf0\x9f"), std::string("a, b, c, d, e, f"),
          std::string(", , ,"), std::string("\xe2\x80\xa6")}) {
        const Marks made = make_marks({true, text, text, std::nullopt}, 128, 72);
        for (std::size_t i = 1; i < made.marks.size(); ++i) {
            CHECK(made.marks[i].x >= -8);
            CHECK(made.marks[i].x + made.marks[i].rgba.width <= 128 + 8);
        }
    }
}

TEST_CASE("annotations: without a font there is the line alone, and a note") {
    const NoFont none;
    const Marks made = make_marks({true, "Left", "Right", ScaleBarMark{100.0, "10 M"}}, 640, 360);
    CHECK(made.marks.size() == 1);
    CHECK(made.note.find("fonts-dejavu-core") != std::string::npos);
    CHECK(make_marks({true, "", "", std::nullopt}, 640, 360).note == "");
}

TEST_CASE("annotations: ticks lie along the electric vector, as long as the polarised fraction") {
    constexpr int kWidth = 440, kHeight = 220;
    const TickGrid grid = tick_grid(kWidth, kHeight);
    CHECK(grid.columns == 36);
    CHECK(grid.rows == 18);
    Image<float> stokes(grid.columns, grid.rows, 4);
    const auto set = [&](int x, int y, float light, double fraction, double angle) {
        float* to = stokes.at(x, y);
        to[0] = light;
        to[1] = static_cast<float>(light * fraction * std::cos(2 * angle));
        to[2] = static_cast<float>(light * fraction * std::sin(2 * angle));
    };
    set(3, 2, 1.0f, 0.5, 0.4), set(5, 2, 0.5f, 0.25, -1.2), set(7, 2, 0.001f, 0.5, 0.4), set(9, 2, 1.0f, 0.0, 0.0);
    const std::vector<Tick> ticks = ticks_of(stokes, kWidth, kHeight);
    REQUIRE(ticks.size() == 2);  // what is dark, or not polarised, has none
    CHECK(std::abs(std::atan2(ticks[0].up, ticks[0].right) - 0.4) < 1e-6);
    CHECK(std::abs(std::atan2(ticks[1].up, ticks[1].right) + 1.2) < 1e-6);
    const auto length = [](const Tick& tick) { return 2 * std::hypot(tick.right, tick.up); };
    CHECK(std::abs(length(ticks[0]) / length(ticks[1]) - 2) < 1e-5);
    CHECK(length(ticks[0]) < 12.0);
    CHECK(std::abs(ticks[0].x - 3.5 * kWidth / grid.columns) < 1e-9);
    // Drawn, it is white along its line, dark beside it, and clear away from it.
    Image<unsigned char> picture(kWidth, kHeight, 3);
    std::ranges::fill(picture.data, static_cast<unsigned char>(128));
    lay_over(tick_marks(stokes, kWidth, kHeight), picture);
    const auto at = [&](double along, double aside) {
        const double c = std::cos(0.4), sn = std::sin(0.4);
        return picture.at(static_cast<int>(ticks[0].x + along * c - aside * sn),
                          static_cast<int>(ticks[0].y - along * sn - aside * c))[0];
    };
    CHECK(at(3, 0) > 180);
    CHECK(at(-3, 0) > 180);
    CHECK(at(0, 2) < 122);
    CHECK(at(0, 12) == 128);
}
