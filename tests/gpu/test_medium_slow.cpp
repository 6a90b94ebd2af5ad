// Slow light through dumps: each place is seen at the time when its light left. Against the formula that the dumps are samples of, and against
// the speed at which what moves toward the camera seems to move.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "plan/dump_window.h"
#include "spacetime/registry.h"
#include "spacetime/tortoise.h"
#include "support/costly.h"
#include "support/medium_dumps.h"
#include "support/medium_pictures.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// A spot that goes round, ln of its density; t by the clock of Boyer and Lindquist.
constexpr double kOrbit = 4, kRate = 0.088, kNarrow = 0.05;
double orbiting(double x, double y, double z, double t) {
    const double dx = x - kOrbit * std::cos(kRate * t), dy = y - kOrbit * std::sin(kRate * t);
    return -kNarrow * (dx * dx + dy * dy + z * z);
}
const std::string kOrbiting =
    fmt::format("exp(-{0}*((x - {1}*cos({2}*t))^2 + (y - {1}*sin({2}*t))^2 + z^2))", kNarrow, kOrbit, kRate);

// phi_BL - phi_KS at r, of a hole of spin a (r_s = 1).
double turned(double spin, double r) {
    if (spin == 0) return 0;
    const double a = 0.5 * spin, outer = 0.5 + std::sqrt(0.25 - a * a), inner = 1 - outer;
    return -a / (outer - inner) * std::log((r - outer) / (r - inner));
}

struct Series {
    const char* metric;
    double spin;
    const char* coordinates;
};

Scene base_scene(const Series& series) {
    Scene scene = bare_scene(series.metric, series.spin);
    scene.object.mass_suns = 4.3e6;
    scene.camera.r = 30, scene.camera.theta = 1.1, scene.camera.plane_width = 0.6;
    scene.camera.width = scene.camera.height = by_depth(10, 16, 32);
    MediumSpec& medium = scene.medium.emplace();
    medium.outer = 8, medium.steps = 128, medium.emissivity = 1e-18;
    return scene;
}

Scene by_formula(const Series& series) {
    Scene scene = base_scene(series);
    scene.medium->kind = MediumKind::kFormula, scene.medium->formulas.density = kOrbiting;
    return scene;
}

constexpr int kSlowDumps = 55;
constexpr double kSlowCadence = 1.1;

Scene by_dumps(const Series& series, const std::filesystem::path& folder) {
    Scene scene = base_scene(series);
    scene.medium->kind = MediumKind::kGrid;
    GridForm form;
    form.coordinates = series.coordinates, form.spin = series.spin;
    form.nearest = 1.05, form.farthest = 8.5, form.rings = 34, form.polar = 32, form.around = 64;
    const bool kerr_schild = std::string(series.coordinates) == "kerr-schild";
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    REQUIRE(spacetime);
    for (int dump = 0; dump < kSlowDumps; ++dump)
        REQUIRE(write_text_atomically(
            folder / fmt::format("slow-{:03d}.grid", dump), grid_bytes(form, [&](double r, double theta, double phi) {
                const double t = dump * kSlowCadence - (kerr_schild ? time_ahead(**spacetime, r) : 0),
                             azimuth = phi + (kerr_schild ? turned(series.spin, r) : 0), off = r * std::sin(theta);
                return GridNode{
                    std::exp(orbiting(off * std::cos(azimuth), off * std::sin(azimuth), r * std::cos(theta), t)),
                    1,
                    0,
                    0,
                    0,
                    0,
                    0,
                    0};
            })));
    scene.medium->grid = {folder / "slow-%03d.grid", 0, kSlowDumps - 1, kSlowCadence, 0, DumpLight::kSlow};
    return scene;
}

Image<float> slow_traced(const Scene& scene) {  // not remembered: the files of another run may differ
    auto light = reference::render_frame(scene, SkyCube(), reference::Pictures(), 1);
    REQUIRE(light);
    Image<float> picture(scene.camera.width, scene.camera.height, 3);
    picture.data = std::move(light->data);
    return picture;
}

// Where the light's middle is, r_s of the plane through the centre.
double middle_of(const Scene& scene, const Image<float>& picture) {
    double sum = 0, moment = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double light = picture.at(x, y)[0];
            sum += light, moment += light * (x + 0.5 - 0.5 * picture.width);
        }
    return moment / sum * scene.camera.plane_width / picture.width * scene.camera.r;
}

}  // namespace

TEST_CASE("medium slow: a spot that goes round is that of its formula in each frame, by both tracers") {
    constexpr double kSame = 0.01;  // of the brightest: between nodes and dumps ln of the density is 0.5 % less
    for (const Series& series : {Series{"schwarzschild", 0, "boyer-lindquist"},
                                 Series{"schwarzschild", 0, "kerr-schild"}, Series{"kerr", 0.9, "kerr-schild"}}) {
        CAPTURE(series.metric);
        CAPTURE(series.coordinates);
        const TemporaryFolder folder("slow-orbit");
        Scene film = by_dumps(series, folder.path), exact = by_formula(series);
        const DumpTimes times = medium_times(film);
        fmt::print("medium slow, {} {}: times {:.4g} to {:.4g}\n", series.metric, series.coordinates, times.from,
                   times.to);
        REQUIRE(times.to - times.from > 4);
        on_every_context([&](GpuSession& session) {
            for (int frame = 0; frame < 4; ++frame) {
                CAPTURE(frame);
                film.time = exact.time = times.from + frame / 3.0 * (times.to - times.from);
                const Image<float> drawn = picture_of(session, film);
                const Difference off = difference(drawn, picture_of(session, exact), kSame);
                Scene fast = film;
                fast.medium->grid.light = DumpLight::kFast, fast.time = std::min(fast.time, kSlowCadence * 54);
                const Difference other = difference(picture_of(session, fast), drawn, kSame);
                fmt::print("  frame {}: flux {:+.1e}, pixels {:.1e}; fast light {:.1e}\n", frame, off.flux, off.largest,
                           other.largest);
                CHECK(off.largest < kSame);
                CHECK(other.largest > 10 * kSame);
                if (frame != 1) continue;
                const Difference by_reference = difference(drawn, slow_traced(film), 1.5e-3);
                fmt::print("  over the reference's: flux {:+.1e}, pixels {:.1e}\n", by_reference.flux,
                           by_reference.largest);
                CHECK(std::abs(by_reference.flux) < 6e-4);
                CHECK(by_reference.largest < 1.5e-3);
            }
        });
    }
}

TEST_CASE("medium slow: what moves toward the camera seems to move faster by 1/(1 - v), with fast light it does not") {
    constexpr double kToward = 0.5, kAside = 0.4, kCamera = 300, kOff = 1.5, kThin = 1.2;  // c; r_s
    constexpr double kExact = 0.01;  // of the speed: ln of the density between nodes is less, and the more so far out
    constexpr double kCadence = 0.5;
    constexpr int kDumps = 50;
    const TemporaryFolder folder("slow-flat");
    GridForm form;
    form.nearest = 0.5, form.farthest = 8.5, form.rings = 44, form.polar = 48, form.around = 64;
    for (int dump = 0; dump < kDumps; ++dump)  // at t = 14 abreast of the centre, seen from theta = 90, phi = 0
        REQUIRE(write_text_atomically(
            folder.path / fmt::format("flat-{:02d}.grid", dump),
            grid_bytes(form, [&](double r, double theta, double phi) {
                const double t = dump * kCadence - 14, x = r * std::sin(theta) * std::cos(phi) - kToward * t,
                             y = r * std::sin(theta) * std::sin(phi) - kAside * t, z = r * std::cos(theta) - kOff;
                return GridNode{std::exp(-kThin * (x * x + y * y + z * z)), 1, 0, 0, 0, 0, 0, 0};
            })));
    Scene film = bare_scene("minkowski", 0);
    film.object.mass_suns = 4.3e6;
    film.camera.r = kCamera, film.camera.theta = M_PI / 2, film.camera.phi = 0;
    film.camera.plane_width = 16 / kCamera, film.camera.width = film.camera.height = 48;
    MediumSpec& medium = film.medium.emplace();
    medium.kind = MediumKind::kGrid, medium.outer = 8, medium.steps = 128, medium.emissivity = 1e-18;
    medium.grid = {folder.path / "flat-%02d.grid", 0, kDumps - 1, kCadence, 0, DumpLight::kSlow};
    Scene fast = film;
    fast.medium->grid.light = DumpLight::kFast;
    constexpr double kBetween = 3;  // from frame to frame, r_s/c
    const auto speed = [&](const auto& picture_at, Scene scene, double middle) {
        scene.time = middle - kBetween / 2;
        const double from = middle_of(scene, picture_at(scene));
        scene.time = middle + kBetween / 2;
        return std::abs(middle_of(scene, picture_at(scene)) - from) / kBetween;
    };
    const auto judge = [&](const char* who, const auto& picture_at) {
        const double slow = speed(picture_at, film, kCamera + 14), at_once = speed(picture_at, fast, 14);
        fmt::print("medium slow, {}: seen to move at {:.4f} c, at {:.4f} with fast light\n", who, slow, at_once);
        CHECK(slow == doctest::Approx(kAside / (1 - kToward)).epsilon(kExact));
        CHECK(at_once == doctest::Approx(kAside).epsilon(kExact));
    };
    on_every_context(
        [&](GpuSession& session) { judge("shader", [&](const Scene& s) { return picture_of(session, s); }); });
    judge("reference", slow_traced);
}

TEST_CASE("medium slow: a time whose light left outside of the dumps is refused, by both tracers") {
    const TemporaryFolder folder("slow-refused");
    write_spot_dumps(folder.path);
    Scene film = bare_scene("minkowski", 0);
    film.object.mass_suns = 4.3e6, film.camera.r = 30;
    film.camera.width = film.camera.height = 16;  // what is refused does not depend on the picture
    film.medium.emplace().kind = MediumKind::kGrid, film.medium->outer = 8;
    film.medium->grid = spot_dumps(folder.path), film.medium->grid.light = DumpLight::kSlow;
    const auto said = [&](double time) {  // dumps at 10 to 37.5, light from 22 to 38 before
        film.time = time;
        const auto light = reference::render_frame(film, SkyCube(), reference::Pictures(), 1);
        const std::string message = light ? "good" : light.error().message();
        on_every_context([&](GpuSession& session) {
            const Status ready = session.renderer->prepare(film);
            CHECK((ready ? std::string("good") : ready.error().message()) == message);
        });
        return message;
    };
    const std::string allowed =
        ": the light of then left outside of the times of the dumps of medium.file; allowed: [48, 59.5] r_s/c, of "
        "dumps "
        "3 to 14 seen 22 to 38 r_s/c later";
    CHECK(said(48) == "good");
    CHECK(said(59.5) == "good");
    CHECK(said(47.9) == "time: 47.9" + allowed);
    CHECK(said(59.6) == "time: 59.6" + allowed);
    film.medium->grid.last = 8;
    CHECK(said(48) ==
          "medium.light: the light that a picture shows left within 16 r_s/c, all dumps of medium.file within 12.5; "
          "allowed: more dumps, a smaller outer, or fast");
}
