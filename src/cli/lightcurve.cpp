// nullscope lightcurve: the light of a scene, or of a part of its picture, against time.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "cli/command.h"
#include "cli/table_file.h"
#include "command/arguments.h"
#include "command/band_pictures.h"
#include "command/capture_picture.h"
#include "command/curve_light.h"
#include "command/curve_plot.h"
#include "command/loop_plot.h"
#include "command/session.h"
#include "compare/stokes_loop.h"
#include "plan/dump_window.h"
#include "plan/moving.h"
#include "scene/bodies.h"
#include "scene/medium_dumps.h"
#include "scene/spot_orbit.h"
#include "telescope/flux.h"

namespace nullscope::cli {
namespace {

struct LightcurveOptions {
    std::vector<std::string> set;  // scenefile/scene_override.h
    std::string scene, output = "lightcurve", size, renderer = "gl";
    ContextChoice context;
    std::vector<int> region;  // x, y of the first pixel, x, y behind the last
    std::optional<double> from, to;
    std::optional<int> samples;  // reference alone
    int steps = 120;
    GivenWords given;
};

struct CurvePoint {
    double time;
    std::array<double, 4> flux;    // luminance, red, green, blue, over the solid angle: 1 is a steradian of white
    std::vector<double> jansky{};  // by the columns of flux
    StokesPoint stokes{};          // in the unit of flux[0], where light is polarised
};

bool dimmer(const CurvePoint& a, const CurvePoint& b) { return a.flux[0] < b.flux[0]; }

// To the last dump, one turn of the spots, one pulse or turn of the sphere, or 100 r_s/c.
double period_of(const Scene& scene, double from) {
    if (has_dumps(scene)) return medium_times(scene).to - from;
    if (const auto orbit = spot_period(scene)) return *orbit;
    const SphereSpec* sphere = first_shape<SphereSpec>(scene);
    if (sphere != nullptr && sphere->amplitude > 0) return sphere->period;
    return sphere != nullptr && sphere->spin_rate != 0 ? 2 * M_PI / std::fabs(sphere->spin_rate) : 100.0;
}

// What the columns mean, for people.
std::string column_words(const std::vector<FluxColumn>& columns, bool polarised) {
    std::string words = "light against time. time: r_s/c; flux: luminance times solid angle (sr), white is 1";
    for (const FluxColumn& column : columns)
        words += fmt::format("; {}: flux density at {} GHz, Jy", column.name, column.unit.frequency_GHz);
    if (polarised) words += "; stokes_q, stokes_u: of flux, angles from the picture's right towards up";
    return words;
}

std::string csv_of(const std::vector<CurvePoint>& curve, const std::vector<FluxColumn>& columns, bool polarised) {
    std::string text = "time,flux,red,green,blue";
    for (const FluxColumn& column : columns) text += ',' + column.name;
    text += polarised ? ",stokes_q,stokes_u\n" : "\n";
    for (const CurvePoint& s : curve) {
        text += fmt::format("{:.17g},{:.9g},{:.9g},{:.9g},{:.9g}", s.time, s.flux[0], s.flux[1], s.flux[2], s.flux[3]);
        for (const double jansky : s.jansky) text += fmt::format(",{:.9g}", jansky);
        if (polarised) text += fmt::format(",{:.9g},{:.9g}", s.stokes.q, s.stokes.u);
        text += '\n';
    }
    return text;
}

// The vertical axis in Jy, where there is a unit, of several frequencies the first. Beside it Q and U, where there are these.
std::string svg_of(const Scene& scene, const std::vector<CurvePoint>& curve, const std::vector<FluxColumn>& columns,
                   const StokesLoop& loop) {
    std::vector<std::array<double, 2>> points;
    points.reserve(curve.size());
    for (const CurvePoint& s : curve) points.push_back({s.time, s.jansky.empty() ? s.flux[0] : s.jansky.front()});
    const std::string title =
        columns.empty() ? scene.name : fmt::format("{}: Jy at {} GHz", scene.name, columns.front().unit.frequency_GHz);
    if (loop.empty()) return curve_plot(title, "time, r_s/c", points);
    return svg_document(
        kCurveWidth + kLoopWidth, kCurveHeight,
        std::string(kSvgWhite) + curve_drawing(title, "time, r_s/c", points) +
            fmt::format("<g transform=\"translate({} 0)\">\n{}</g>\n", kCurveWidth, loop_plot(loop_shape(loop), 0)));
}

// What the loop does, for people.
std::string words_of(const StokesLoop& loop) {
    if (!is_closed(loop)) return "Q and U end elsewhere than they begin";
    const int turns = loop_turns(loop);
    return fmt::format("Q and U go round a closed loop whose direction turns {} times {}", std::abs(turns),
                       turns < 0 ? "clockwise" : "counterclockwise");
}

// The scene at options.steps times, the last included.
struct Curve {
    std::vector<CurvePoint> samples;
    std::string drawn_by;
};
Result<Curve> curve_of(const LightcurveOptions& options, Scene scene, double from, double to,
                       const std::array<int, 4>& region, const std::vector<FluxColumn>& columns) {
    std::optional<Session> session;
    std::optional<PictureDrawer> exact;
    if (options.renderer == "gl") {
        TRY(opened, open_session(options.context));
        session = std::move(*opened);
    } else {
        DrawOptions each;
        each.samples = options.samples.value_or(1), each.bands = !columns.empty();
        each.listener.progress = [](const std::string&, long long) { return Advance([](long long) {}); };
        TRY(drawer, picture_drawer(nullptr, scene, each));
        exact = std::move(*drawer);
    }
    const auto light_of = [&](const Exposure& one) -> Result<Image<float>> {
        TRY(ready, session->renderer->prepare(one.scene));
        tell_notes(*session, DrawOptions().listener);
        return session->renderer->picture();
    };
    const auto stokes_of = [&](const Exposure& one) -> Result<Image<float>> {
        TRY(ready, session->renderer->prepare(one.scene));
        return draw_stokes(*session->renderer);
    };
    const auto captured = [&]() -> Result<Captured> {
        if (exact) return (*exact)(scene);
        Captured drawn;
        TRY(light, light_of(scene));
        drawn.linear = std::move(*light);
        if (is_polarised(scene)) drawn.stokes = draw_stokes(*session->renderer);
        if (columns.empty()) return drawn;
        TRY(bands, band_pictures(scene, {light_of, stokes_of}, drawn.linear));
        drawn.bands = std::move(*bands);
        return drawn;
    };
    Curve curve{{}, session ? session->renderer->info().renderer : "reference tracer"};
    Progress progress("light curve", options.steps);
    for (int i = 0; i < options.steps; ++i, progress.advance()) {
        scene.time = from + i * (to - from) / (options.steps - 1);
        TRY(drawn, captured());
        CurvePoint point{scene.time, light_in(drawn->linear, scene.camera, region)};
        point.jansky = fluxes_in(*drawn, columns, region);
        if (!drawn->stokes.empty()) point.stokes = stokes_sum(drawn->stokes, scene.camera, region, scene.time);
        curve.samples.push_back(std::move(point));
    }
    return curve;
}

Result<std::array<int, 4>> region_of(const LightcurveOptions& options, const CameraSpec& camera) {
    if (options.region.empty()) return std::array<int, 4>{0, 0, camera.width, camera.height};
    const std::array<int, 4> r{options.region[0], options.region[1], options.region[2], options.region[3]};
    if (r[0] >= 0 && r[1] >= 0 && r[0] < r[2] && r[1] < r[3] && r[2] <= camera.width && r[3] <= camera.height) return r;
    return bad_input(fmt::format("--region {} {} {} {} is not a part of the picture", r[0], r[1], r[2], r[3]),
                     fmt::format("X0 < X1 <= {}, Y0 < Y1 <= {}", camera.width, camera.height));
}

Result<int> run_lightcurve(const LightcurveOptions& options) {
    TRY(scene, asked_scene(options));
    if (!changes_with_time(*scene))
        return bad_input(
            fmt::format("{}: nothing in it changes with time", options.scene),
            "a scene with disc.flow, disc.precession, [spot], sphere.amplitude, sphere.spin_rate, ball.motion, t in "
            "surface.shape or in formulas "
            "of [medium], medium.flow, or dumps as medium.file");
    TRY(samples, check_samples_of_reference(options.renderer, options.samples.has_value()));
    TRY(context, check_context(options.renderer, options.context));
    TRY(region, region_of(options, scene->camera));
    const double from = options.from.value_or(scene->time), to = options.to.value_or(from + period_of(*scene, from));
    if (!(to > from)) return bad_input(fmt::format("--to {} is not after --from {}", to, from));
    if (has_dumps(*scene))
        for (const double time : {from, to})
            if (const auto fault = medium_time_fault(*scene, time))
                return bad_input(fmt::format("{}: {} {}", options.scene, fault->key, fault->what), fault->allowed);
    const std::vector<FluxColumn> columns = flux_columns(*scene);
    const bool polarised = is_polarised(*scene) && options.renderer == "gl";
    TRY(curve, curve_of(options, *scene, from, to, *region, columns));
    std::vector<double> times;
    for (const CurvePoint& point : curve->samples) times.push_back(point.time);
    StokesLoop loop;
    for (const CurvePoint& point : curve->samples)
        if (polarised) loop.push_back(point.stokes);
    TRY(written, write_table(options.output + ".csv", csv_of(curve->samples, columns, polarised),
                             options.output + ".svg", svg_of(*scene, curve->samples, columns, loop),
                             {*scene, options.scene, options.given.words(), curve->drawn_by,
                              column_words(columns, polarised), times}));
    const auto peak = std::ranges::max_element(curve->samples, dimmer);
    std::string most = columns.empty() ? fmt::format("{:.4g}", peak->flux[0]) : "";
    for (std::size_t k = 0; k < columns.size(); ++k)
        most +=
            fmt::format("{}{:.4g} Jy at {} GHz", k == 0 ? "" : ", ", peak->jansky[k], columns[k].unit.frequency_GHz);
    fmt::print("{0}.csv, {0}.svg: {1} times from {2:g} to {3:g} r_s/c; brightest at {4:g}, {5}\n", options.output,
               options.steps, from, to, peak->time, most);
    if (polarised) fmt::print("{}\n", words_of(loop));
    return 0;
}

}  // namespace

void add_lightcurve(Command& parent) {
    auto [command, options] = add_command<LightcurveOptions>(
        parent, "lightcurve", "Light curve of a scene, brightness against time: FILE.csv and FILE.svg", run_lightcurve);
    options.given.of(command);
    required_option(command, "scene", options.scene,
                    "Scene file, or the name of a built-in scene, in which something changes with time");
    set_option(command, options.set);
    text_option(command, "-o,--output", options.output, "Name of the files to write, without .csv and .svg");
    number_option(command, "--from", options.from, -1e9, 1e9, "First time, r_s/c (default: the scene's)");
    number_option(command, "--to", options.to, -1e9, 1e9,
                  "Last time (default: that of the last dump, one orbit of the spots, one pulsation or one turn of the "
                  "sphere later, else 100)");
    number_option(command, "--steps", options.steps, 2, 100000, "Number of points in time");
    command.add_option("--size", &options.size, "Picture size in pixels, WIDTHxHEIGHT (default: the scene's)");
    command
        .add_option("--region", &options.region,
                    "X0 Y0 X1 Y1: only this part of the picture, px from its top left corner, X1 and Y1 excluded "
                    "(default: all of it)")
        .count(4);
    renderer_option(command, options.renderer);
    number_option(command, "--samples", options.samples, 1, 16,
                  "For --renderer reference: N x N rays per pixel (default 1)");
    context_option(command, options.context);
}

}  // namespace nullscope::cli
