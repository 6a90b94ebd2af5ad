// Thermal discs that shine by powers of the radius, by a table or by a lamp: the driver's pictures against the reference's.
#include <fmt/format.h>

#include <filesystem>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "reference/reference.h"
#include "support/draft.h"
#include "support/gpu_session.h"
#include "support/picture_off.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

struct Shining {
    const char* name;
    Scene scene;
};

Scene lit_by(const char* metric, double spin, Emissivity by) {
    Draft draft;
    draft.metric(metric).place(15, 1.2).size(48, 27).plane(1.2).sky(SkyKind::kBlack).disc(1.3, 9);
    if (spin != 0) draft.spin(spin).by(ObserverKind::kZamo);
    Scene scene = draft;
    scene.picture.refine = false;
    scene.light.bolometric = true;
    scene.disc->emission = DiscEmission::kThermal, scene.disc->material.texture = TextureKind::kImage;
    scene.disc->emissivity.by = by;
    return scene;
}

std::vector<Shining> shining_scenes(const std::filesystem::path& table) {
    Scene powers = lit_by("schwarzschild", 0, Emissivity::kPowerLaw), rows = lit_by("kerr", 0.9, Emissivity::kTable),
          lamp = lit_by("kerr", 0.9, Emissivity::kLamp), still = lit_by("schwarzschild", 0, Emissivity::kLamp),
          flat = lit_by("minkowski", 0, Emissivity::kLamp), leans = lit_by("kerr", -0.7, Emissivity::kPowerLaw);
    powers.disc->emissivity.powers = {5, 0, 3}, powers.disc->emissivity.breaks = {3.5, 6};
    rows.disc->emissivity.file = table;
    lamp.disc->emissivity.lamp = {2, 2.4};
    still.disc->emissivity.lamp = {4, 2};
    leans.disc->inner = 5, leans.disc->lean.tilt = 0.5, leans.disc->emissivity.powers = {1, 1, 1};
    return {{"two breaks", powers},
            {"a table", rows},
            {"a lamp about a rotating hole", lamp},
            {"a lamp", still},
            {"a lamp in flat space", flat},
            {"a leaning disc", leans}};
}

TEST_CASE("disc emissivity: pictures are the reference's") {
    constexpr double kLight = 2e-5;  // relative: of the temperature's table, and g of floats
    constexpr double kRims = 0.15;   // of the lit pixels: rims and edges of tables, where a ray's place decides
    const std::filesystem::path table = std::filesystem::temp_directory_path() / "nullscope-emissivity.csv";
    REQUIRE(write_text_atomically(table, "r,epsilon\n1.2,1\n2,4\n5,0.5\n8,0.1\n"));
    on_one_context([&](GpuSession& session) {
        for (const auto& [name, scene] : shining_scenes(table)) {
            CAPTURE(std::string(name));
            const auto sky = build_sky(scene.sky, assets_directory(), 16);
            REQUIRE(sky);
            const auto exact = reference::render_frame(scene, *sky, {}, 1);
            REQUIRE(exact);
            const Image<float> picture = picture_of(session, scene);
            Scene other = scene;
            other.disc->emissivity.by = Emissivity::kAccretion;
            const Image<float> accretion = picture_of(session, other);
            const auto [off, changed] = lit_against(*exact, 1e-6, picture, accretion, 0.05);
            REQUIRE(off.size() > 100);
            const double most = off[static_cast<std::size_t>((1 - kRims) * static_cast<double>(off.size()))];
            fmt::print(
                "disc emissivity: {}: {} lit pixels, median {:.1e}, within rims {:.1e}, {} differ from accretion's\n",
                name, off.size(), off[off.size() / 2], most, changed);
            CHECK(most < kLight);
            CHECK(changed > 50);
        }
    });
    std::filesystem::remove(table);
}

}  // namespace
