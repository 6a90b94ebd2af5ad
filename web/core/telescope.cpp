// What telescopes measure of the picture, by the class that the window's panel has. Needs the page's WebGL2 context.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "core/exports.h"
#include "core/session.h"
#include "render/display.h"
#include "scene/picture_size.h"
#include "telescope/live_telescope.h"
#include "viewer/small_light.h"

namespace nullscope::web {
namespace {

constexpr int kLightInMotion_px = 96, kLight_px = 256;  // as the window has it
constexpr double kUasOfPage = M_PI / 180 / 3600e6;      // rad

std::optional<LiveTelescope> live;
viewer::SmallLight light;
Scene seen;                         // whose light it is
Image<unsigned char> through_beam;  // RGBA, as it is displayed

Status load_array() {
    if (live) return Done{};
    const auto file = assets_directory() / "telescopes" / "eht-2017.csv";
    TRY(text, read_text(file));
    TRY(stations, read_stations(*text, file.string()));
    live.emplace(std::move(*stations));
    return Done{};
}

std::string tracks_json() {
    const auto& triangles = live->triangles();
    const std::size_t index = live->wish().triangle;
    std::vector<std::string> tracks;  // u, v, and 1 where the chosen triangle has it
    for (std::size_t i = 0; i < live->day().pairs.size(); ++i) {
        const auto [first, second] = live->day().pairs[i];
        const bool chosen = index < triangles.size() && std::ranges::count(triangles[index], first) > 0 &&
                            std::ranges::count(triangles[index], second) > 0;
        const auto [u, v] = live->day().baselines[i];
        tracks.push_back(fmt::format("{:.4g},{:.4g},{}", 1e-9 * u, 1e-9 * v, chosen ? 1 : 0));
    }
    return fmt::format("[{}]", fmt::join(tracks, ","));
}

// [[hours, degrees], ...], of a day or of the scene's clock.
std::string closure_json() {
    std::vector<std::string> dots;
    const auto add = [&](double hours, double phase) {
        dots.push_back(fmt::format("[{:.6g},{:.5g}]", hours, phase * 180 / M_PI));
    };
    for (const TimedPhase& each : live->by_time()) add(each.hours - live->by_time().front().hours, each.phase);
    if (dots.empty())
        for (const TrianglePhase& each : live->view().phases) add(each.hour, each.phase);
    return fmt::format("[{}]", fmt::join(dots, ","));
}

// The beam's widths as parts of the picture's width, its angle in rad, and the picture through it: [width, height, place of RGBA].
std::string beam_json() {
    const auto beam = live->beam();
    if (!beam) return "null";
    const Image<unsigned char> rgb = display_encoded(live->through(*beam), seen.camera.exposure_ev, seen.picture);
    through_beam = Image<unsigned char>(rgb.width, rgb.height, 4);
    for (std::size_t i = 0; i < rgb.data.size() / 3; ++i) {
        std::copy_n(&rgb.data[3 * i], 3, &through_beam.data[4 * i]);
        through_beam.data[4 * i + 3] = 255;
    }
    const double across = live->source().pixel * seen.camera.width;
    return fmt::format(R"({{"major": {:.6g}, "minor": {:.6g}, "angle": {:.6g}, "picture": [{}, {}, {}]}})",
                       beam->major / across, beam->minor / across, beam->angle, rgb.width, rgb.height,
                       reinterpret_cast<std::size_t>(through_beam.data.data()));
}

std::string source_json() {
    const LiveSource& source = live->source();
    return fmt::format(
        R"({{"object": {}, "assumed": {}, "assumed_place": {}, "rough": {}, "uas": [{:.4g}, {:.4g}], "GHz": {:.6g}, "jansky": {}}})",
        in_json(source.object), source.assumed_object, source.assumed_place, source.rough,
        seen.camera.width * source.pixel / kUasOfPage, seen.camera.height * source.pixel / kUasOfPage,
        source.frequency_GHz, source.unit.has_value());
}

std::string found_json() {
    if (!live->has_light()) return "null";
    const LiveView& view = live->view();
    std::string least = "null";
    if (view.minimum)
        least = fmt::format("[{:.8g}, {:.6g}]", 1e-9 * std::hypot(view.minimum->baseline.u, view.minimum->baseline.v),
                            view.minimum->amplitude);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < live->triangles().size(); ++i) names.push_back(in_json(live->triangle_words(i)));
    return fmt::format(
        R"({{"source": {}, "longest": {:.8g}, "angle": {:.6g}, "curve": [{:.6g}], "minimum": {}, "triangles": [{}], "triangle": {}, )"
        R"("plane": [{}, {:.4g}], "tracks": {}, "closure": {}, "moves": {}, "beam": {}}})",
        source_json(), live->wish().longest_glambda, live->wish().angle_deg, fmt::join(view.amplitudes, ","), least,
        fmt::join(names, ","), live->wish().triangle, view.plane.width, fmt::join(view.plane.data, ","), tracks_json(),
        closure_json(), !live->by_time().empty(), beam_json());
}

}  // namespace

// What is found in the picture of that size, as JSON: null where it is dark. quick: of fewer pixels. false: the answer says why not; files that
// are missing are named by missed_files().
NULLSCOPE_EXPORT(look_by_telescope) bool look_by_telescope(int width, int height, bool quick) {
    if (const Status ready = load_array(); !ready) return answer(ready.error());
    Scene scene = session().scene;
    scene.path.reset();
    set_size(scene, width, height);
    if (scene.split) return answer(bad_input("telescopes look at one picture", "scenes without [split]"));
    const auto method = method_of(scene);
    if (!method) return answer(method.error());
    viewer::PaintJob job{scene, *method};
    const int side = quick ? kLightInMotion_px : kLight_px;
    Image<float> linear = light.draw(job, side, {});
    if (linear.empty()) return answer(bad_input("the picture has no light"));
    seen = viewer::small_scene(scene, side);
    if (const Status looked = live->look(seen, std::move(linear), quick); !looked) return answer(looked.error());
    return answer(found_json());
}
// What is wished of it from now on; found anew in the last picture's light. through: 0 nothing, 1 a beam, 2 the longest baseline. triangle: of the list,
// or -1: that is chosen already.
NULLSCOPE_EXPORT(want_of_telescope)
bool want_of_telescope(double angle_deg, double longest_glambda, int triangle, int through, double beam_uas,
                       double beam_ratio, double beam_angle_deg) {
    if (const Status ready = load_array(); !ready) return answer(ready.error());
    TelescopeWish wish = live->wish();
    wish.angle_deg = angle_deg, wish.longest_glambda = std::clamp(longest_glambda, 0.1, 100.0);
    if (triangle >= 0) wish.triangle = static_cast<std::size_t>(triangle);
    wish.through = static_cast<SeenThrough>(std::clamp(through, 0, 2));
    wish.beam_uas = beam_uas, wish.beam_ratio = beam_ratio, wish.beam_angle_deg = beam_angle_deg;
    live->want(wish);
    return answer(found_json());
}
// Frees what it keeps; also where the context was lost.
NULLSCOPE_EXPORT(end_telescope) void end_telescope() {
    light.drop();
    live.reset();
}

}  // namespace nullscope::web
