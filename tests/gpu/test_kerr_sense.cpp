// Holes that turn towards falling phi, extremal holes, and discs of either sense, as the driver draws them: against the reference, and against
// the picture of the other spin turned about the x axis.
#include <cmath>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "against_reference.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

Draft turning(double spin, double charge = 0) {
    Draft draft;
    draft.metric("kerr-newman", {{"spin", spin}, {"charge", charge}}).by(ObserverKind::kZamo);
    return draft.place(8, 1.25).plane(1.6).size(24, 14);
}

Draft with_disc(Draft draft, OrbitSense sense) {
    draft.disc(1.2, 9);
    draft.scene.disc->emission = DiscEmission::kThermal, draft.scene.disc->sense = sense;
    return draft;
}

TEST_CASE("kerr sense: frames of spins of either sign are the reference's, disc and all") {
    std::vector<FrameCase> cases;
    for (const auto& [spin, charge] : {std::pair{-0.9, 0.0},
                                       {-0.5, 0.0},
                                       {-1.0, 0.0},
                                       {1.0, 0.0},
                                       {1 - 1e-9, 0.0},
                                       {-0.6, 0.8},
                                       {0.6, std::sqrt(0.64 - 1e-9)}}) {
        const std::string name = fmt::format("a = {} Q = {:.9g}", spin, charge);
        cases.push_back({name + " sky", turning(spin, charge).sky(SkyKind::kGrid)});
        cases.push_back({name + " disc", with_disc(turning(spin, charge), OrbitSense::kEastward)});
    }
    Draft fall = turning(-0.9).by(ObserverKind::kRain).r(0.7);
    cases.push_back({"a = -0.9 from inside", fall.sky(SkyKind::kGrid)});
    AgainstReference judge("kerr sense", {.sky = kEveryRay_px, .place = kEveryRay_px, .of_width = 1920});
    on_one_context([&](GpuSession& session) { judge.frames(session, Selection(3), cases); });
}

// Half a turn about the x axis: theta to pi - theta, phi to -phi, roll by pi; the picture keeps its pixels.
TEST_CASE("kerr sense: the other spin turned is the same picture") {
    on_one_context([](GpuSession& session) {
        for (const OrbitSense sense : {OrbitSense::kEastward, OrbitSense::kWestward}) {
            Draft one = with_disc(turning(0.9), sense);
            one.scene.camera.phi = 0.4;
            one.scene.sky.kind = SkyKind::kBlack, one.scene.picture.refine = false;
            Draft other = with_disc(turning(-0.9),
                                    sense == OrbitSense::kEastward ? OrbitSense::kWestward : OrbitSense::kEastward);
            other.scene.sky.kind = SkyKind::kBlack, other.scene.picture.refine = false;
            CameraSpec& camera = other.scene.camera;
            camera.theta = M_PI - one.scene.camera.theta, camera.phi = -0.4, camera.roll = M_PI;
            const Image<float> a = picture_of(session, one), b = picture_of(session, other);
            other.scene.disc->sense = sense;
            const Image<float> wrong = picture_of(session, other);
            double most = 0, wrong_most = 0;
            for (int y = 0; y < a.height; ++y)
                for (int x = 0; x < a.width; ++x) {
                    const double light = a.at(x, y)[0];
                    most = std::max(most, std::fabs(b.at(x, y)[0] - light) / (light + 0.01));
                    wrong_most = std::max(wrong_most, std::fabs(wrong.at(x, y)[0] - light) / (light + 0.01));
                }
            fmt::print("kerr sense: the other spin turned is off by {:.1e} of a pixel, the other sense by {:.1e}\n",
                       most, wrong_most);
            CHECK(most < 1e-3);
            CHECK(wrong_most > 0.1);
        }
    });
}

}  // namespace
