// Properties of the CPU parts on random cameras: the shader's own text in double and in float, with the real tables, against the
// reference. A failure is shrunk to a small scene file in reports/found of the build folder, which names the pixel.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "proof/view_judge.h"
#include "scenefile/scene_file.h"
#include "support/costly.h"
#include "support/folders.h"

namespace {

using namespace nullscope;
using namespace nullscope::proof;

constexpr int kViews = 300, kPixels = 334;
constexpr std::size_t kMostFiles = 4;  // one a kind of failure, and not more: shrinking takes a second or two

// Where a view's pixels are does not change when the view is simplified.
std::vector<PixelPlace> pixels_of(const View& view, unsigned from) {
    Random random(from);
    std::vector<PixelPlace> places;
    for (int i = 0; i < kPixels; ++i) places.push_back({random.below(view.width), random.below(view.height)});
    return places;
}

// The largest error over bound of one kind in a view.
Finding worst_of(FrameTables& tables, const View& view, const Core& core, const std::string& what, unsigned pixels) {
    const ViewJudge judge(tables, view.scene());
    Finding worst{core.name, what, {}, 0};
    for (const PixelPlace pixel : pixels_of(view, pixels))
        judge.judge(core, pixel, [&](const Finding& f) {
            if (f.what == what && !(f.ratio <= worst.ratio)) worst = f;
        });
    return worst;
}

struct Reproduction {
    View view;
    Finding finding;
    std::filesystem::path file;
};
Reproduction reproduce(FrameTables& tables, const View& view, const Core& core, const std::string& what,
                       unsigned pixels, const std::string& name) {
    Reproduction result;
    result.view = shrunk(view, [&](const View& v) { return worst_of(tables, v, core, what, pixels).ratio > 1; });
    result.finding = worst_of(tables, result.view, core, what, pixels);
    const std::filesystem::path folder = test::reports_folder() / "found";
    std::filesystem::create_directories(folder);
    result.file = folder / (name + ".toml");
    std::ofstream(result.file) << result.view.toml(
        fmt::format("# {}, {}: {:.3g} times its bound (found with NULLSCOPE_SEED={})\n# pixel {} {}\n", core.name, what,
                    result.finding.ratio, seed(), result.finding.pixel.x, result.finding.pixel.y));
    return result;
}

TEST_CASE("random views: the shader's text in double and in float agrees with the reference" * test::costly()) {
    Random random(seed());
    FrameTables tables;
    std::map<std::string, double> largest;
    std::set<std::string> written;
    long long rays = 0, failures = 0;
    for (int i = 0; i < tries(kViews); ++i) {
        const View view = random_view(random);
        const unsigned pixels = seed() + 1000u + static_cast<unsigned>(i);
        const ViewJudge judge(tables, view.scene());
        std::map<std::string, std::pair<const Core*, Finding>> failed;
        for (const PixelPlace pixel : pixels_of(view, pixels)) {
            ++rays;
            for (const Core& core : cores())
                judge.judge(core, pixel, [&](const Finding& f) {
                    const std::string kind = f.core + " " + f.what;
                    double& most = largest[kind];
                    if (!(f.ratio <= most)) most = f.ratio;
                    if (!(f.ratio <= 1)) failed.try_emplace(kind, &core, f), ++failures;
                });
        }
        for (const auto& [kind, failure] : failed) {
            const auto& [core, finding] = failure;
            std::string file = "(not shrunk: there is a file of this kind already)";
            if (written.size() < kMostFiles && written.insert(kind).second) {
                std::string name = fmt::format("seed-{}-view-{}-{}", seed(), i, kind);
                std::replace(name.begin(), name.end(), ' ', '-');
                file = reproduce(tables, view, *core, finding.what, pixels, name).file.string();
            }
            FAIL_CHECK("seed ", seed(), ", view ", i, ", ", kind, " at pixel (", finding.pixel.x, ", ", finding.pixel.y,
                       "): ", finding.ratio, " times its bound: ", file);
        }
    }
    fmt::print("{} rays, {} failures; largest error over bound:\n", rays, failures);
    for (const auto& [kind, ratio] : largest) fmt::print("  {}: {:.2f}\n", kind, ratio);
}

struct FoundScene {
    std::filesystem::path path;
    Scene scene;
    PixelPlace pixel{};
    bool open = false;
};
// Lines "# pixel COLUMN ROW" and, as long as the failure is known and not mended, "# open".
FoundScene read_found(const std::filesystem::path& path) {
    FoundScene found;
    found.path = path;
    const auto scene = load_scene(path.string());
    REQUIRE_MESSAGE(scene, path.string());
    found.scene = *scene;
    bool named = false;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        found.open = found.open || line == "# open";
        named = named || std::sscanf(line.c_str(), "# pixel %d %d", &found.pixel.x, &found.pixel.y) == 2;
    }
    REQUIRE_MESSAGE(named, path.string());
    return found;
}

TEST_CASE("random views: scenes that were found, each at the pixel that it names") {
    FrameTables tables;
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::data_folder() / "hard/found")) {
        if (entry.path().extension() != ".toml") continue;
        const FoundScene found = read_found(entry.path());
        ++scenes;
        double most = 0;
        const ViewJudge judge(tables, found.scene);
        for (const Core& core : cores())
            judge.judge(core, found.pixel, [&](const Finding& f) { most = std::max(most, f.ratio); });
        const std::string name = entry.path().filename().string();
        if (found.open) {
            fmt::print("{}: open, {:.3g} times its bound\n", name, most);
            CHECK_MESSAGE(most > 1, name, " is mended: take its line \"# open\" away");
        } else {
            CHECK_MESSAGE(most <= 1, name);
        }
    }
    CHECK(scenes > 0);
}

// The checks above can fail: a core that is wrong in one corner is found, and the scene that says so is small.
TEST_CASE("random views: a planted error is found and shrunk") {
    FrameTables tables;
    View view;
    view.r = 7.123456789, view.yaw = 12.3, view.roll = 77, view.velocity = {0.1, -0.2, 0.3}, view.has_disc = true,
    view.fov = 50;
    Core planted = cores()[0];
    const auto true_trace = planted.trace;
    planted.trace = [&](const CoreInput& input, double x, double y) {
        RayPixel pixel = true_trace(input, x, y);
        if (x > 0 && pixel.fate == Fate::kEscaped) pixel.sky = normalized(pixel.sky + Vec3{1e-4, 0, 2e-4});
        return pixel;
    };
    CHECK(worst_of(tables, view, cores()[0], "sky", 1).ratio <= 1);
    CHECK(worst_of(tables, view, planted, "sky", 1).ratio > 1);
    const Reproduction found = reproduce(tables, view, planted, "sky", 1, "planted");
    CHECK_FALSE(found.view.has_disc);
    CHECK(found.view.velocity == std::array<double, 3>{});
    CHECK(found.view.roll == 0);
    CHECK(found.view.r == 7);
    CHECK(found.finding.pixel.x >= found.view.width / 2);
    const auto loaded = load_scene(found.file.string());
    REQUIRE(loaded);
    CHECK(loaded->camera.r == 7);
    for (const double broken : {std::nan(""), static_cast<double>(INFINITY)}) {
        planted.trace = [&](const CoreInput& input, double x, double y) {
            RayPixel pixel = true_trace(input, x, y);
            pixel.v = broken;
            return pixel;
        };
        CHECK(worst_of(tables, view, planted, "not finite", 1).ratio > 1);
    }
    planted.trace = [&](const CoreInput& input, double x, double y) {
        RayPixel pixel = true_trace(input, x, y);
        pixel.fate = pixel.fate == Fate::kCaptured ? Fate::kEscaped : pixel.fate;
        return pixel;
    };
    CHECK(worst_of(tables, view, planted, "end", 1).ratio > 1);
}

}  // namespace
