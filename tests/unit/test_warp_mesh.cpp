// Warp meshes: what is read and what is refused, places in them, and a camera that looks through one.
#include <doctest/doctest.h>

#include <cmath>

#include "scene/projection.h"
#include "support/warp_files.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

WarpMesh mesh_of(const std::string& text) {
    auto mesh = WarpMesh::parse(text, "mesh.data");
    const std::string message = mesh ? "" : mesh.error().message();
    REQUIRE_MESSAGE(mesh, message);
    return *mesh;
}

// Numbers in [0, 1), the same in every run.
struct Numbers {
    std::uint64_t state = 1;
    double next() {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state >> 11) * 0x1p-53;
    }
};

TEST_CASE("warp mesh: files that are none are refused with their line") {
    struct Bad {
        std::string text;
        int line;
        const char *what, *allowed;
    };
    const std::string head = "2\n2 2\n", node = "0 0 0 0 1\n";
    const Bad kBad[] = {
        {"", 1, "ends here", "1 (polar) or 2 (rectangular)"},
        {"3\n2 2\n", 1, "3 is no kind of mesh", "1 (polar) or 2 (rectangular)"},
        {"two\n", 1, "\"two\" is not a finite number", "1 (polar)"},
        {"2\n2\n", 2, "1 numbers instead of 2", "nx ny"},
        {"2\n1 2\n", 2, "1 nodes along a side", "2 to 4096"},
        {"2\n2.5 2\n", 2, "2.5 nodes", "2 to 4096"},
        {"2\n4000000000 4000000000\n", 2, "nodes along a side", "2 to 4096"},
        {"2\n4096 4096\n", 2, "16777216 nodes", "at most 1000000"},
        {head + node + node, 4, "ends here", "x y u v i of node 3 of 4"},
        {head + node + "0 0 0 0\n", 4, "4 numbers instead of 5", "x y u v i of node 2 of 4"},
        {head + node + "0 0 nan 0 1\n", 4, "\"nan\" is not a finite number", "node 2 of 4"},
        {head + node + "0 0 1e999 0 1\n", 4, "is not a finite number", "node 2 of 4"},
        {head + node + "0 -101 0 0 1\n", 4, "y = -101 is out of range", "[-100, 100]"},
        {head + node + "0 0 0 0 1001\n", 4, "i = 1001 is out of range", "[-1000, 1000]"},
        {head + node + node + node + node + node, 7, "after the last node", "4 nodes"},
        {std::string("\x00\xff\x1b[2J\n", 7), 1, "is not a finite number", "1 (polar)"},
        {"2\n" + std::string(1000, '7') + "\n", 2, "a line of 1000 bytes", "nx ny"},
        {warp_text(300, 300, 1.0, [](WarpNode& n) { n.x *= 1e-9, n.y *= 1e-9; }), 0, "cells overlap",
         "4096 at one place"},
    };
    for (const Bad& bad : kBad) {
        const auto mesh = WarpMesh::parse(bad.text, "mesh.data");
        REQUIRE_FALSE(mesh);
        const std::string message = mesh.error().message();
        CAPTURE(message);
        CHECK(mesh.error().kind == ErrorKind::kBadInput);
        CHECK(mesh.error().line == bad.line);
        CHECK(message.starts_with("mesh.data"));
        CHECK(message.find(bad.what) != std::string::npos);
        CHECK(message.find(bad.allowed) != std::string::npos);
        for (const char c : message) CHECK(static_cast<unsigned char>(c) >= 0x20);
    }
    CHECK(mesh_of("# a comment\r\n2\r\n2\t2\r\n\r\n 0 0 0 0 1\n1 0 1 0 1\n0 1 0 1 1\n+1 1 1 1 .5").nodes().size() == 4);
}

TEST_CASE("warp mesh: linear maps are exact, wherever the nodes are, and their inverses") {
    const WarpMesh mesh = mesh_of(warp_text(9, 7, 1.5, [](WarpNode& n) {
        n.x += 0.05 * std::sin(5 * n.y), n.y += 0.08 * std::sin(4 * n.x);  // the cells are no rectangles
        n.u = 0.5 + 0.2 * n.x - 0.1 * n.y, n.v = 0.4 + 0.05 * n.x + 0.3 * n.y, n.light = 1 + 0.5 * n.x;
    }));
    Numbers numbers;
    int found = 0;
    for (int i = 0; i < 20000; ++i) {
        const double x = 4 * numbers.next() - 2, y = 3 * numbers.next() - 1.5;
        const auto place = mesh.at(x, y);
        if (!place) {
            CHECK((std::fabs(x) > 1.4 || std::fabs(y) > 0.9));
            continue;
        }
        ++found;
        CHECK(std::fabs(x) < 1.6);
        CHECK(place->u == doctest::Approx(0.5 + 0.2 * x - 0.1 * y).epsilon(1e-12));
        CHECK(place->v == doctest::Approx(0.4 + 0.05 * x + 0.3 * y).epsilon(1e-12));
        CHECK(place->light == doctest::Approx(1 + 0.5 * x).epsilon(1e-12));
        CHECK(place->slopes[1] == doctest::Approx(-0.1).epsilon(1e-9));
        CHECK(place->slopes[2] == doctest::Approx(0.05).epsilon(1e-9));
        const auto back = mesh.place_of(place->u, place->v);
        REQUIRE(back);
        CHECK(std::hypot((*back)[0] - x, (*back)[1] - y) < 1e-12);
    }
    CHECK(found > 9000);
    CHECK(mesh.least_area() == doctest::Approx(0.2 * 0.3 + 0.1 * 0.05).epsilon(1e-9));
}

TEST_CASE(
    "warp mesh: cells of negative nodes are not drawn; of several at a place the last is seen; a polar mesh is "
    "closed") {
    const WarpMesh holed = mesh_of(warp_text(5, 5, 1.0, [](WarpNode& n) {
        if (n.x == 0.0 && n.y == 0.0) n.light = -1.0;
    }));
    CHECK(holed.cells().size() == 12);
    CHECK_FALSE(holed.at(0.4, -0.3));
    CHECK(holed.at(0.6, -0.3));
    const WarpMesh folded = mesh_of(warp_text(3, 2, 1.0, [](WarpNode& n) {
        if (n.x > 0.0) n.x = -1.0;  // the right half lies on the left one
    }));
    REQUIRE(folded.at(-0.75, 0.1));
    CHECK(folded.at(-0.75, 0.1)->u == doctest::Approx(0.875));
    CHECK_FALSE(folded.at(0.1, 0.1));
    const auto ring = [](WarpNode& n) {
        const double angle = 2 * M_PI * n.u * 11 / 12,
                     radius = 0.2 + 0.7 * n.v;  // 12 columns: the last cell is left open
        n.x = radius * std::cos(angle), n.y = radius * std::sin(angle);
        n.u = 0.5 + 0.5 * n.x, n.v = 0.5 + 0.5 * n.y;
    };
    const WarpMesh open = mesh_of(warp_text(12, 3, 1.0, ring, 2)), closed = mesh_of(warp_text(12, 3, 1.0, ring, 1));
    const double gap = -M_PI / 12;
    CHECK_FALSE(open.at(0.5 * std::cos(gap), 0.5 * std::sin(gap)));
    REQUIRE(closed.at(0.5 * std::cos(gap), 0.5 * std::sin(gap)));
    CHECK(closed.at(0.5 * std::cos(gap), 0.5 * std::sin(gap))->u == doctest::Approx(0.5 + 0.25 * std::cos(gap)));
    CHECK_FALSE(closed.at(0.0, 0.0));
    CHECK_FALSE(closed.at(0.95, 0.0));
}

TEST_CASE("warp mesh: a mesh of identity leaves every camera as it is") {
    const TemporaryFolder folder("warp");
    std::vector<std::tuple<Projection, int, int, double>> cameras = {{Projection::kPinhole, 320, 200, 1.2},
                                                                     {Projection::kFisheye, 200, 200, M_PI},
                                                                     {Projection::kEquirectangular, 400, 200, 2 * M_PI},
                                                                     {Projection::kCylindrical, 300, 200, 4.0}};
    for (int i = static_cast<int>(Projection::kCube) + 1; i < kProjections; ++i)
        cameras.emplace_back(static_cast<Projection>(i), 300, 200, 2.5);
    for (const auto& [projection, width, height, wide] : cameras) {
        CameraSpec plain;
        plain.projection = projection, plain.width = width, plain.height = height;
        set_field_of_view(plain, wide);
        plain.shift_x = 0.1, plain.shift_y = -0.2;
        CameraSpec warped = plain;
        warped.warp = folder.path / fmt::format("{}.data", projection_name(projection));
        write_warp(warped.warp, warp_text(17, 9, static_cast<double>(width) / height, [](WarpNode&) {}));
        double off = 0.0, again = 0.0, size = 0.0;
        for (double y = 0.5; y < height; y += 7.0)
            for (double x = 0.5; x < width; x += 7.0) {
                const Vec3 direction = pixel_direction(plain, x, y);
                off = std::fmax(off, length(pixel_direction(warped, x, y) - direction));
                CHECK(shows(plain, x, y) == shows(warped, x, y));
                if (!shows(plain, x, y)) continue;
                const auto back = pixel_of(warped, direction);
                REQUIRE(back);
                again = std::fmax(again, std::hypot((*back)[0] - x, (*back)[1] - y));
                size = std::fmax(size, std::fabs(pixel_solid_angle(warped, x, y) / pixel_solid_angle(plain, x, y) - 1));
            }
        CHECK(off < 1e-13);
        CHECK(again < 1e-9);
        CHECK(size < 1e-9);
        CHECK(smallest_pixel_angle(warped) == doctest::Approx(smallest_pixel_angle(plain)));
    }
}

TEST_CASE(
    "warp mesh: pixels are as large as their corners are apart, parts are those of the whole, beside the mesh nothing "
    "is shown") {
    const TemporaryFolder folder("warp");
    CameraSpec camera;
    camera.projection = Projection::kFisheye, camera.width = 320, camera.height = 180;
    set_field_of_view(camera, M_PI);
    camera.warp = folder.path / "bent.data";
    write_warp(camera.warp, warp_text(65, 33, 1.5, [](WarpNode& n) {
                   const double x = n.x, y = n.y;
                   n.u = 0.5 + 0.25 * x + 0.05 * y * y, n.v = 0.5 + 0.3 * y - 0.06 * x * y, n.light = 0.5;
               }));
    CameraSpec part = camera;
    part.part = PicturePart{64, 32, 320, 180}, part.width = 100, part.height = 60;
    double most = 0.0;
    for (double y = 40.37; y < 90; y += 3.1)
        for (double x = 70.3; x < 160; x += 3.3) {
            const auto unit = [&](double dx, double dy) {
                const Vec3 d = pixel_direction(camera, x + dx, y + dy);
                return d / length(d);
            };
            constexpr double kSide = 1e-4;
            const Vec3 along = (unit(kSide, 0) - unit(-kSide, 0)) / (2 * kSide),
                       across = (unit(0, kSide) - unit(0, -kSide)) / (2 * kSide);
            most = std::fmax(most, std::fabs(length(cross(along, across)) / pixel_solid_angle(camera, x, y) - 1));
            CHECK(length(pixel_direction(part, x - 64, y - 32) - pixel_direction(camera, x, y)) < 1e-14);
            CHECK(warp_light(camera, x, y) == doctest::Approx(0.5));
            const auto back = pixel_of(part, pixel_direction(camera, x, y));
            REQUIRE(back);
            CHECK(std::hypot((*back)[0] - (x - 64), (*back)[1] - (y - 32)) < 1e-9);
        }
    CHECK(most < 1e-6);
    CHECK_FALSE(shows(camera, 10.0, 90.0));
    CHECK(warp_light(camera, 10.0, 90.0) == 0.0);
}

TEST_CASE("warp mesh: a file that has changed is read again") {
    const TemporaryFolder folder("warp");
    CameraSpec camera;
    camera.width = 200, camera.height = 200;
    camera.warp = folder.path / "mesh.data";
    write_warp(camera.warp, warp_text(2, 2, 1.0, [](WarpNode&) {}));
    CHECK(warp_light(camera, 100.0, 100.0) == 1.0);
    write_warp(camera.warp, warp_text(2, 2, 1.0, [](WarpNode& n) { n.light = 0.25; }));
    REQUIRE(load_warp_mesh(camera.warp));
    CHECK(warp_light(camera, 100.0, 100.0) == 0.25);
    CHECK_FALSE(load_warp_mesh(folder.path / "none.data"));
}

}  // namespace
