// Warp meshes of every kind and order: one smooth map, written as each program writes it, is found again to 0.1 px.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "scene/projection.h"
#include "support/warp_files.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr int kWide = 1920, kHigh = 1080;  // px

struct Pair {
    double s, t, u, v;  // of the screen, and of the picture; from the lower left corner, 0 to 1
};
// In closed form both ways: two shears, a curve and a stretch.
Pair of_screen(double s, double t) {
    const double u = 0.1 + 0.8 * s + 0.05 * std::sin(3 * t);
    return {s, t, u, 0.08 + 0.85 * t + 0.06 * u * u};
}
Pair of_picture(double u, double v) {
    const double t = (v - 0.08 - 0.06 * u * u) / 0.85;
    return {(u - 0.1 - 0.05 * std::sin(3 * t)) / 0.8, t, u, v};
}

void add(std::string& bytes, std::uint32_t number, bool little = true) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> 8 * (little ? i : 3 - i) & 0xff);
}
void add(std::string& bytes, double number, bool little = true) {
    add(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(number)), little);
}

std::string bourke(int columns, int rows, bool by_columns, bool polar = false) {
    std::string text = fmt::format("{}\n{} {}\n", polar ? 1 : 2, columns, rows);
    for (int i = 0; i < columns * rows; ++i) {
        const double column = by_columns ? i / rows : i % columns, row = by_columns ? i % rows : i / columns;
        Pair p = of_screen(column / (columns - 1), row / (rows - 1));
        if (polar) {
            const double angle = 2 * M_PI * column / columns, radius = 0.02 + 0.48 * row / (rows - 1);
            p = of_screen(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle));
        }
        text += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} 1\n", (2 * p.s - 1) * kWide / kHigh, 2 * p.t - 1, p.u, p.v);
    }
    return text;
}

std::string stellarium(int last_x, int last_y, const char* light = "0.5 0.5 0.5") {
    std::string text = fmt::format("{} {}\n", last_x, last_y);
    for (int j = 0; j <= last_y; ++j)
        for (int i = 0; i <= last_x; ++i) {
            const double s = i == 0 ? 0.0 : i == last_x ? 1.0 : (i - 0.5 * (j % 2)) / (last_x - 0.5);
            const Pair p = of_screen(s, static_cast<double>(j) / last_y);
            text += fmt::format("{:.9g} {:.9g} {}\n", 0.5 * kWide + (p.u - 0.5) * kHigh, p.v * kHigh, light);
        }
    return text;
}

std::string sgc(std::uint32_t columns, std::uint32_t rows, char version = 1) {
    std::string bytes = "SGC";
    bytes += version;
    add(bytes, 0u);
    for (int i = 0; i < 11; ++i) add(bytes, 20.0);
    add(bytes, columns), add(bytes, rows);
    for (std::uint32_t i = 0; i < columns * rows; ++i) {
        const Pair p = of_screen(static_cast<double>(i % columns) / (columns - 1),
                                 1 - static_cast<double>(i / columns) / (rows - 1));
        for (const double number : {p.s, 1 - p.t, 0.0, p.u, p.v, 0.0}) add(bytes, number);
    }
    add(bytes, 0u);
    return bytes;
}

enum class Rows { kUpperFirst, kLowerFirst };
std::string pfm(int width, int height, bool absolute, Rows rows, bool little, double hole = -1.0) {
    std::string bytes = fmt::format("PF\n{} {}\n{}\n", width, height, little ? "-1.0" : "1.0");
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const double rim = absolute ? 0.5 : 0.0, a = (column + rim) / (width - 1 + 2 * rim),
                         down = (row + rim) / (height - 1 + 2 * rim), b = rows == Rows::kUpperFirst ? 1 - down : down;
            const Pair p = absolute ? of_screen(a, b) : of_picture(a, b);
            const bool none = absolute && std::hypot(a - 0.5, b - 0.5) < hole;
            const double nan = std::numeric_limits<double>::quiet_NaN();
            add(bytes, none ? nan : absolute ? p.u : p.s - a, little);
            add(bytes, none ? nan : absolute ? p.v : p.t - b, little);
            add(bytes, 0.0, little);
        }
    return bytes;
}

// The largest error of places of the picture, px; every place within is to be found.
double worst_of(const CameraSpec& camera) {
    double worst = 0.0;
    int found = 0;
    for (double t = 0.03; t < 0.98; t += 0.0171)
        for (double s = 0.03; s < 0.98; s += 0.0173) {
            const Pair p = of_screen(s, t);
            const auto place = warped_place(camera, s * kWide, (1 - t) * kHigh);
            REQUIRE(place);
            worst = std::max(worst, std::hypot(place->at[0] - (2 * p.u - 1) * 0.5 * kHigh,
                                               place->at[1] - (2 * p.v - 1) * 0.5 * kHigh));
            ++found;
        }
    CHECK(found > 1000);
    return worst;
}

CameraSpec camera_of(const TemporaryFolder& folder, const std::string& file) {
    CameraSpec camera;
    camera.projection = Projection::kFisheye, camera.width = kWide, camera.height = kHigh;
    set_field_of_view(camera, M_PI);
    static int files = 0;  // a mesh is looked at again only when it is asked for anew
    camera.warp = folder.path / fmt::format("mesh-{}", ++files);
    write_warp(camera.warp, file);
    return camera;
}

TEST_CASE("warp kinds: the same map in every kind of file and both orders, to 0.1 px") {
    constexpr double kMost_px = 0.1;
    const TemporaryFolder folder("kinds");
    struct Kind {
        const char* name;
        std::string file;
    };
    const Kind kinds[] = {
        {"Bourke, row by row", bourke(100, 60, false)},
        {"Bourke, column by column", bourke(100, 60, true)},
        {"Stellarium", stellarium(80, 60)},
        {"SGC", sgc(100, 60)},
        {"PFM, absolute, upper row first", pfm(240, 135, true, Rows::kUpperFirst, true)},
        {"PFM, absolute, lower row first, large end first", pfm(240, 135, true, Rows::kLowerFirst, false)},
        {"PFM, absolute, of more pixels than nodes", pfm(1600, 900, true, Rows::kUpperFirst, true)},
        {"PFM, moves of an even grid", pfm(120, 80, false, Rows::kUpperFirst, true)},
    };
    for (const Kind& kind : kinds) {
        CAPTURE(kind.name);
        const CameraSpec camera = camera_of(folder, kind.file);
        const double worst = worst_of(camera);
        CAPTURE(worst);
        CHECK(worst < kMost_px);
    }
}

TEST_CASE("warp kinds: polar meshes of both orders, to 0.1 px") {
    constexpr double kMost_px = 0.1;
    const TemporaryFolder folder("polar");
    for (const bool by_columns : {false, true})
        for (const auto& [across, up] : {std::pair{360, 60}, std::pair{240, 240}}) {
            const int columns = across;
            const CameraSpec camera = camera_of(folder, bourke(columns, up, by_columns, true));
            double worst = 0.0;
            for (double angle = 0.0; angle < 2 * M_PI; angle += 0.013)  // also across the seam
                for (double radius = 0.05; radius < 0.47; radius += 0.03) {
                    const Pair p = of_screen(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle));
                    CAPTURE(by_columns);
                    CAPTURE(columns);
                    CAPTURE(angle);
                    CAPTURE(radius);
                    const auto place = warped_place(camera, p.s * kWide, (1 - p.t) * kHigh);
                    REQUIRE(place);
                    worst = std::max(worst, std::hypot(place->at[0] - (2 * p.u - 1) * 0.5 * kHigh,
                                                       place->at[1] - (2 * p.v - 1) * 0.5 * kHigh));
                }
            CAPTURE(worst);
            CHECK(worst < kMost_px);
        }
}

TEST_CASE("warp kinds: a mesh of shares follows the screen, holes stay dark, the rim is reached, intensity by kind") {
    const TemporaryFolder folder("kinds");
    CameraSpec camera = camera_of(folder, stellarium(80, 60));
    CHECK(warp_light(camera, 700, 500) == doctest::Approx(0.5));
    camera.warp_intensity = WarpIntensity::kDisplay;
    CHECK(warp_light(camera, 700, 500) == doctest::Approx(std::pow(0.5, 2.2)));
    camera = camera_of(folder, sgc(100, 60));
    const auto at = warped_place(camera, 0.25 * kWide, 0.25 * kHigh);
    camera.width = kHigh, camera.height = kHigh;
    const auto square = warped_place(camera, 0.25 * kHigh, 0.25 * kHigh);
    REQUIRE(at);
    REQUIRE(square);
    CHECK(square->at[0] == doctest::Approx(at->at[0]));
    CHECK(square->at[1] == doctest::Approx(at->at[1]));
    camera = camera_of(folder, pfm(240, 135, true, Rows::kUpperFirst, true, 0.2));
    CHECK_FALSE(warped_place(camera, 0.5 * kWide, 0.5 * kHigh));
    CHECK(warped_place(camera, 0.02, 0.02));
    CHECK(warped_place(camera, kWide - 0.02, kHigh - 0.02));
}

TEST_CASE("warp kinds: files that are none are refused with the reason") {
    struct Bad {
        std::string file;
        const char* words;
    };
    std::string cube = sgc(4, 4), grey = pfm(4, 4, true, Rows::kUpperFirst, true), wild = sgc(4, 4);
    cube[4] = 1, grey[1] = 'f', wild.replace(60, 4, "\xff\xff\xff\x7f", 4);
    const Bad kBad[] = {
        {sgc(4, 4, 2), "version 2"},
        {cube, "a cube"},
        {wild, "out of range"},
        {sgc(4, 4).substr(0, 100), "cut off"},
        {sgc(5000, 2).substr(0, 70), "5000 x 2 nodes"},
        {grey, "grey"},
        {"PF\n", "cut off"},
        {"PF\nx\n1\n", "damaged"},
        {"PF\n99999999 4\n-1\n", "99999999 x 4"},
        {pfm(4, 4, true, Rows::kUpperFirst, true).substr(0, 90), "cut off"},
        {stellarium(3, 3, "1 0.5 0"), "colour"},
        {stellarium(3, 3) + "1 2 1 1 1\n", "after the last node"},
        {"4 5000\n", "5001 nodes"},
    };
    for (const Bad& bad : kBad) {
        const auto mesh = WarpMesh::parse(bad.file, "mesh");
        CAPTURE(bad.words);
        REQUIRE_FALSE(mesh);
        const std::string message = mesh.error().message();
        CAPTURE(message);
        CHECK(message.find(bad.words) != std::string::npos);
        CHECK(message.find("mesh") != std::string::npos);
    }
}

}  // namespace
