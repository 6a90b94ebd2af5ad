// Matter of dumps: pictures at their times are those of the files, bit for bit, and between them those of a file of the means; of both tracers.
#include <fmt/format.h>

#include <cmath>

#include "support/costly.h"
#include "support/medium_dumps.h"
#include "support/medium_pictures.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

Scene spot_scene() {
    Scene scene = bare_scene("schwarzschild", 0);
    scene.object.mass_suns = 4.3e6;
    scene.camera.r = 30, scene.camera.theta = 1.1, scene.camera.plane_width = 0.45;
    scene.camera.width = scene.camera.height = by_depth(12, 20, 40);
    MediumSpec& medium = scene.medium.emplace();
    medium.kind = MediumKind::kGrid, medium.outer = 8, medium.steps = 64;
    medium.emissivity = 1e-18;
    return scene;
}

Scene with_file(Scene scene, const std::filesystem::path& file) {
    scene.medium->grid = {.file = file};
    return scene;
}

// Not remembered: the files of another run may differ.
Image<float> traced(const Scene& scene) {
    auto light = reference::render_frame(scene, SkyCube(), reference::Pictures(), 1);
    REQUIRE(light);
    Image<float> picture(scene.camera.width, scene.camera.height, 3);
    picture.data = std::move(light->data);
    return picture;
}

}  // namespace

TEST_CASE(
    "medium dumps: at its own time a dump's picture is that of its file, bit for bit, and between two that of their "
    "mean") {
    const TemporaryFolder folder("dumps-pictures");
    write_spot_dumps(folder.path);
    Scene film = spot_scene();
    film.medium->grid = spot_dumps(folder.path);
    const auto mean_file = [&](int dump, double part) {
        const auto file = folder.path / fmt::format("mean-{}-{}.grid", dump, part);
        REQUIRE(write_text_atomically(file, grid_bytes(spot_form(), [&](double r, double theta, double phi) {
                                          return mean_node(spot_node(dump, r, theta, phi),
                                                           spot_node(dump + 1, r, theta, phi), part);
                                      })));
        return file;
    };
    const auto at = [&](double dump) {
        Scene scene = film;
        scene.time = kSpotStart + dump * kSpotCadence;
        return scene;
    };
    const double kBetween[] = {0.5, 5.25, 10.75};
    on_every_context([&](GpuSession& session) {
        Image<float> last;
        for (int dump = 0; dump < kSpotDumps; ++dump) {
            CAPTURE(dump);
            const Image<float> picture = picture_of(session, at(dump));
            CHECK(picture.data == picture_of(session, with_file(at(dump), spot_file(folder.path, dump))).data);
            CHECK(sum_of(picture) > 0);
            CHECK(picture.data != last.data);
            last = picture;
        }
        for (const double between : kBetween) {
            const int dump = static_cast<int>(between);
            const Image<float> mean = picture_of(session, with_file(at(0), mean_file(dump, between - dump)));
            const Difference off = difference(picture_of(session, at(between)), mean, 1e-6);
            fmt::print("medium dumps, between {} and {}: flux {:+.1e}, pixels {:.1e}\n", dump, dump + 1, off.flux,
                       off.largest);
            CHECK(off.largest < 1e-6);
        }
    });
    for (const int dump : {0, 5, kSpotDumps - 1}) {
        CAPTURE(dump);
        CHECK(traced(at(dump)).data == traced(with_file(at(dump), spot_file(folder.path, dump))).data);
    }
    for (const double between : kBetween) {
        const int dump = static_cast<int>(between);
        const Difference off =
            difference(traced(at(between)), traced(with_file(at(0), mean_file(dump, between - dump))), 1e-6);
        fmt::print("medium dumps, reference, between {} and {}: flux {:+.1e}, pixels {:.1e}\n", dump, dump + 1,
                   off.flux, off.largest);
        CHECK(off.largest < 1e-6);
    }
}

TEST_CASE("medium dumps: a time outside of them is refused by both tracers") {
    const TemporaryFolder folder("dumps-time");
    write_spot_dumps(folder.path);
    Scene film = spot_scene();
    film.medium->grid = spot_dumps(folder.path);
    film.time = kSpotStart - 0.01;
    const auto light = reference::render_frame(film, SkyCube(), reference::Pictures(), 1);
    REQUIRE_FALSE(light);
    CHECK(light.error().message() ==
          "time: 9.99 is not between the dumps of medium.file; allowed: [10, 37.5] r_s/c, of dumps 3 to 14");
    on_every_context([&](GpuSession& session) {
        const Status ready = session.renderer->prepare(film);
        REQUIRE_FALSE(ready);
        CHECK(ready.error().message() == light.error().message());
    });
}
