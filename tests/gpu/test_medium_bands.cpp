// Matter that is seen at several frequencies in one march: each as it is seen alone, and as the reference has them; Faraday's rotation between
// frequencies behind and before a screen, against its closed form.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "command/band_pictures.h"
#include "compare/rotation_measure.h"
#include "reference/matter_stokes.h"
#include "scene/medium_bands.h"
#include "scene/projection.h"
#include "support/medium_pictures.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// Samples are as short as the densest matter of all frequencies asks: of thin matter the same, of thick matter others than at one frequency, whose
// pixels differ from the reference's by up to 5e-3 of the brightest.
struct BandBound {
    double pixel, flux;  // of the brightest pixel of a frequency, and of its flux
};
constexpr BandBound kThinBand{1e-5, 1e-6}, kThickBand{2e-3, 2e-4};

Scene matter_scene(MediumKind kind, MediumEmission law, double density) {
    Scene scene = bare_scene("kerr", 0.7);
    scene.sky.kind = SkyKind::kBlack;
    scene.object.mass_suns = 4.3e6;
    scene.camera.r = 40, scene.camera.theta = 1.1, scene.camera.plane_width = 0.5;
    scene.camera.width = 32, scene.camera.height = 18;
    MediumSpec& medium = scene.medium.emplace();
    medium.kind = kind, medium.emission = law;
    medium.formulas = {"exp(-r^2/18)", "3e10/max(r, 1)", "30/max(r, 1)"};
    medium.emissivity = 3e-18, medium.spectral_index = 0.7;
    medium.flow.radius = 3, medium.inner = 2, medium.outer = 10, medium.density_scale = density;
    return scene;
}

Scene with_bands(Scene scene, std::vector<double> bands) {
    scene.medium->bands_GHz = std::move(bands);
    settle_bands(*scene.medium);
    return scene;
}

std::vector<BandPicture> bands_of(GpuSession& session, const Scene& scene) {
    const auto light = [&](const Exposure& one) -> Result<Image<float>> { return picture_of(session, one.scene); };
    const auto stokes = [&](const Exposure& one) -> Result<Image<float>> {
        REQUIRE(session.renderer->prepare(one.scene));
        return draw_stokes(*session.renderer);
    };
    auto bands = cli::band_pictures(scene, {light, stokes}, {});
    REQUIRE(bands);
    return std::move(*bands);
}

struct BandError {
    double pixel = 0, flux = 0;
};
BandError band_error(const Image<float>& band, const Image<float>& alone) {
    BandError error;
    double most = 0, sum = 0, told = 0;
    for (std::size_t i = 0; i < band.data.size(); ++i) most = std::max<double>(most, alone.data[3 * i]);
    for (std::size_t i = 0; i < band.data.size(); ++i) {
        const double value = band.data[i], exact = alone.data[3 * i];
        error.pixel = std::isfinite(value) ? std::max(error.pixel, std::abs(value - exact) / most) : INFINITY;
        sum += value, told += exact;
    }
    REQUIRE(told > 0);
    error.flux = std::abs(sum / told - 1);
    return error;
}

void hold_bands(GpuSession& session, const std::string& what, const Scene& scene, const BandBound& most) {
    CAPTURE(what);
    const std::vector<BandPicture> bands = bands_of(session, scene);
    const std::vector<Scene> alone = scenes_of_bands(scene);
    REQUIRE(bands.size() == alone.size());
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const BandError error = band_error(bands[i].light, picture_of(session, alone[i]));
        fmt::print("{}, {}: pixels within {:.1e}, flux {:.1e} of the picture at one frequency\n", what,
                   band_name(bands[i].frequency_GHz), error.pixel, error.flux);
        CHECK(error.pixel < most.pixel);
        CHECK(error.flux < most.flux);
    }
}

// The reference's pictures at the frequencies that are shown, each in its colour.
void hold_colours(GpuSession& session, const std::string& what, const Scene& scene) {
    constexpr double kFlux = 1e-3, kPixel = 5e-3;  // as docs/matter.md has them at one frequency
    const std::vector<std::size_t> shown = bands_as_colours(*scene.medium);
    Image<float> exact(scene.camera.width, scene.camera.height, 3);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        Scene alone = at_band(scene, shown[i]);
        alone.sky.kind = SkyKind::kPlain;  // black, without a cube
        const Image<float> light = reference_picture(alone);
        const Vec3 colour = colour_of_band(i, shown.size());
        const std::array<double, 3> shares{colour.x, colour.y, colour.z};
        for (std::size_t k = 0; k < light.data.size(); ++k)
            exact.data[k] += static_cast<float>(shares[k % 3] * light.data[k]);
    }
    const Difference off = difference(picture_of(session, scene), exact, kPixel);
    fmt::print("{}: red flux over the reference's {:+.1e}, pixels {:.1e}\n", what, off.flux, off.largest);
    CHECK(std::abs(off.flux) < kFlux);
    CHECK(off.largest < kPixel);
}

// A hot source at x = 1.5 and cold matter at x = 4, or the other way round, on a camera's line of sight along x in flat space; the field is
// `along` the direction to the camera and 0.8 across it.
constexpr double kScreenField = 10, kScreenDensity = 4.4e4, kScreenWidth2 = 0.1;
Scene screen_scene(double along, bool before) {
    Scene scene = bare_scene("minkowski", 0);
    scene.sky.kind = SkyKind::kBlack;
    scene.object.mass_suns = 4.3e6;
    scene.camera.r = 60, scene.camera.theta = M_PI / 2, scene.camera.plane_width = 1e-3;
    scene.camera.width = scene.camera.height = 3;
    MediumSpec& medium = scene.medium.emplace();
    medium.kind = MediumKind::kFormula, medium.emission = MediumEmission::kSynchrotron;
    const double source = before ? 1.5 : 4, screen = before ? 4 : 1.5;
    medium.formulas.density =
        fmt::format("100*exp(-(x-{})^2/0.1) + {}*exp(-(x-{})^2/{})", source, kScreenDensity, screen, kScreenWidth2);
    medium.formulas.temperature = fmt::format("1e4 + 4e10*exp(-((x-{})/0.7)^4)", source);
    medium.formulas.field = fmt::format("{}", kScreenField);
    medium.field_direction = FieldDirection::kVector, medium.field_vector = {along, 0.8, 0};
    medium.polarisation = true;
    medium.outer = 6, medium.steps = 768, medium.brightness = 1e6;
    return with_bands(scene, {86, 90, 230, 345});
}

// RM = e^3/(2 pi m^2 c^4) times the integral of n B along the way, here of a Gaussian.
double screen_rm(const Scene& scene, double along) {
    constexpr double kCharge = 4.80320471e-10, kMass = 9.1093837e-28, kSpeed = 2.99792458e10;
    const double length_cm = 100 * schwarzschild_radius_m(*scene.object.mass_suns) * std::sqrt(M_PI * kScreenWidth2);
    return 1e4 * std::pow(kCharge, 3) / (2 * M_PI * std::pow(kMass, 2) * std::pow(kSpeed, 4)) * kScreenDensity *
           kScreenField * along * length_cm;
}

// The reference's Stokes parameters of the middle of each pixel.
std::vector<BandPicture> reference_bands(const Scene& scene) {
    std::vector<BandPicture> bands;
    for (Scene& one : scenes_of_bands(scene)) {
        const CameraSpec& camera = one.camera;
        const auto exact = reference::MatterStokes::make(one);
        REQUIRE(exact);
        const auto from = exact->axes_of(camera);
        REQUIRE(from);
        BandPicture band{one.medium->frequency_GHz, {}, Image<float>(camera.width, camera.height, 4)};
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) {
                const auto seen = exact->at(*from, normalized(pixel_direction(camera, x + 0.5, y + 0.5)));
                for (std::size_t c = 0; c < 4; ++c) band.stokes.at(x, y)[c] = static_cast<float>(seen.light[c]);
            }
        bands.push_back(std::move(band));
    }
    return bands;
}

}  // namespace

TEST_CASE("medium bands: frequencies of one march are those of pictures at one frequency") {
    on_one_context([&](GpuSession& session) {
        const std::vector<double> three = {86, 230, 345};
        using enum MediumEmission;
        hold_bands(session, "thin synchrotron",
                   with_bands(matter_scene(MediumKind::kFormula, kSynchrotron, 1e3), three), kThinBand);
        hold_bands(session, "thin power law of a flow",
                   with_bands(matter_scene(MediumKind::kFlow, kPowerLaw, 1), three), kThinBand);
        hold_bands(session, "thin jet of two", with_bands(matter_scene(MediumKind::kJet, kPowerLaw, 1), {43, 86}),
                   kThinBand);
        Scene thick = matter_scene(MediumKind::kFlow, kPowerLaw, 2);
        thick.medium->absorption = 1e5;
        hold_bands(session, "thick power law of a flow", with_bands(thick, three), kThickBand);
        hold_bands(session, "thick synchrotron of five",
                   with_bands(matter_scene(MediumKind::kFormula, kSynchrotron, 2e6), {22, 43, 86, 230, 345}),
                   kThickBand);
        hold_bands(session, "bremsstrahlung of a flow",
                   with_bands(matter_scene(MediumKind::kFlow, kBremsstrahlung, 1e9), three), kThickBand);
    });
}

TEST_CASE("medium bands: the picture in colours is the reference's") {
    on_one_context([&](GpuSession& session) {
        Scene scene = matter_scene(MediumKind::kFormula, MediumEmission::kSynchrotron, 1e6);
        scene.medium->steps = 128, scene.medium->colour = {1, 0.7, 0.4}, scene.medium->brightness = 2;
        const std::vector<std::vector<double>> several = {{86, 230, 345}, {86, 345}, {43, 86, 150, 230, 345}};
        for (const std::vector<double>& bands : several)
            hold_colours(session, fmt::format("{} frequencies as colours", bands.size()), with_bands(scene, bands));
        Scene one = with_bands(scene, {86, 230, 345});
        one.medium->shown_band = 2;
        settle_bands(*one.medium);
        scene.medium->frequency_GHz = 230;
        CHECK(picture_of(session, one).data == picture_of(session, scene).data);  // bit for bit
    });
}

TEST_CASE("rotation measure: of a screen before a source its closed form, of one behind it none, in both tracers") {
    constexpr double kRotation = 2e-3, kNoRotation = 2e-3;  // of the screen's: the source turns its own light a little
    on_one_context([&](GpuSession& session) {
        for (const double along : {0.6, -0.6})
            for (const bool before : {true, false}) {
                const Scene scene = screen_scene(along, before);
                const double screen = screen_rm(scene, along), meant = before ? screen : 0;
                for (const bool exact : {false, true}) {
                    const std::vector<BandPicture> bands = exact ? reference_bands(scene) : bands_of(session, scene);
                    const Image<float> each = rotation_measure_image(bands);
                    const double pixel = each.at(1, 0)[0];  // above the middle: a ray through the centre has no plane
                    const std::vector<RotationMeasure> net = rotation_measures(bands);
                    REQUIRE(net.size() == 3);
                    fmt::print("{}: screen of {:.5g} rad/m^2 {} the source: {}, {}, {}; pixel {:.5g}\n",
                               exact ? "reference" : "gl", screen, before ? "before" : "behind", words_of(net[0]),
                               words_of(net[1]), words_of(net[2]), pixel);
                    const double most = (before ? kRotation : kNoRotation) * std::abs(screen);
                    for (const RotationMeasure& one : net) CHECK(std::abs(one.rad_m2 - meant) < most);
                    CHECK(std::abs(pixel - meant) < most);
                }
            }
    });
}
