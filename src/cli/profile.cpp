// nullscope profile: the light of a scene's picture along a line.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "annotate/annotations.h"
#include "base/assets.h"
#include "base/progress.h"
#include "base/text.h"
#include "cli/capture_options.h"
#include "cli/command.h"
#include "cli/table_file.h"
#include "command/arguments.h"
#include "command/curve_plot.h"
#include "command/reference_inputs.h"
#include "command/session.h"
#include "observer/path.h"
#include "observer/picture_scale.h"
#include "reference/reference.h"
#include "render/picture_layers.h"
#include "scenefile/scene_keys.h"
#include "sky/point_stars.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

struct ProfileOptions {
    std::vector<std::string> set;  // scenefile/scene_override.h
    std::string scene, output = "profile", size, through, renderer = "gl";
    ContextChoice context;
    double angle = 0;
    std::optional<double> time;
    std::optional<int> steps, samples;
    GivenWords given;
};

// A part of a line in the picture: places are px from its upper left corner, distances from `through`.
struct ProfileLine {
    std::array<double, 2> through, along;  // along: of length 1, to the right and down
    double from = 0, to = 0;               // px
    std::array<double, 2> at(double distance) const {
        return {through[0] + distance * along[0], through[1] + distance * along[1]};
    }
};

struct Point {
    std::array<double, 2> place;
    double px;                     // from Line::through
    std::optional<double> impact;  // r_s
    std::array<double, 3> light;
    std::array<double, 4> stokes{};  // where light is polarised
    double luminance() const { return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2]; }  // Rec. 709
};

Result<ProfileLine> profile_line(const ProfileOptions& options, const CameraSpec& camera) {
    const std::array<double, 2> sides = {static_cast<double>(camera.width), static_cast<double>(camera.height)};
    ProfileLine line{{0.5 * sides[0], 0.5 * sides[1]}, {}, -HUGE_VAL, HUGE_VAL};
    if (!options.through.empty()) {
        const auto words = split(options.through, ',');
        const auto x = parse_number(words.front()), y = parse_number(words.back());
        if (words.size() != 2 || !x || !y || !(*x > 0.0 && *x < sides[0] && *y > 0.0 && *y < sides[1]))
            return bad_input(fmt::format("--through {}: not a place within the picture", options.through),
                             fmt::format("X,Y with 0 < X < {} and 0 < Y < {}", sides[0], sides[1]));
        line.through = {*x, *y};
    }
    const double angle = options.angle * M_PI / 180.0;
    line.along = {std::cos(angle), -std::sin(angle)};
    for (std::size_t i = 0; i < 2; ++i) {
        if (constexpr double kParallel = 1e-12;
            std::fabs(line.along[i]) < kParallel) {  // sin(180 degrees) and the like
            line.along[i] = 0.0;
            continue;
        }
        const double one = -line.through[i] / line.along[i], other = (sides[i] - line.through[i]) / line.along[i];
        line.from = std::max(line.from, std::min(one, other)), line.to = std::min(line.to, std::max(one, other));
    }
    return line;
}

// Linear between the centres of pixels; in the outer half of an outer pixel as in its centre. Of the first channels.
template <std::size_t kChannels>
std::array<double, kChannels> light_at(const Image<float>& picture, std::array<double, 2> place) {
    const double x = std::clamp(place[0] - 0.5, 0.0, picture.width - 1.0),
                 y = std::clamp(place[1] - 0.5, 0.0, picture.height - 1.0);
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    const int right = std::min(left + 1, picture.width - 1), below = std::min(top + 1, picture.height - 1);
    const double u = x - left, v = y - top;
    std::array<double, kChannels> light{};
    for (int c = 0; c < static_cast<int>(kChannels); ++c)
        light[static_cast<std::size_t>(c)] =
            (1 - v) * ((1 - u) * picture.at(left, top)[c] + u * picture.at(right, top)[c]) +
            v * ((1 - u) * picture.at(left, below)[c] + u * picture.at(right, below)[c]);
    return light;
}

// A picture, or of one the part from `corner` on.
struct Drawn {
    Image<float> picture;
    Image<float> stokes{};  // empty where light is not polarised, and of the reference
    std::array<double, 2> corner{};
    std::string by = "reference tracer";
};

Result<Drawn> drawn_gl(const ProfileOptions& options, Scene scene) {
    if (options.samples) scene.picture.samples = *options.samples;
    TRY(session, open_session(options.context));
    TRY(ready, session->renderer->prepare(scene));
    for (const std::string& note : session->renderer->take_notes()) fmt::print(stderr, "{}\n", note);
    Drawn drawn{session->renderer->picture()};
    if (is_polarised(scene)) drawn.stokes = draw_stokes(*session->renderer);
    drawn.by = session->renderer->info().renderer;
    return drawn;
}

// Only what the line passes.
Result<Drawn> drawn_by_reference(const ProfileOptions& options, Scene scene, const ProfileLine& line) {
    CameraSpec& camera = scene.camera;
    std::array<int, 2> first{}, size{};
    const std::array<int, 2> sides = {camera.width, camera.height};
    for (std::size_t i = 0; i < 2; ++i) {
        const double one = line.at(line.from)[i], other = line.at(line.to)[i];
        first[i] = std::clamp(static_cast<int>(std::floor(std::min(one, other) - 0.5)), 0, sides[i] - 1);
        size[i] = std::clamp(static_cast<int>(std::ceil(std::max(one, other) + 0.5)), 1, sides[i]) - first[i];
    }
    camera.part = PicturePart{first[0], first[1], sides[0], sides[1]};
    camera.width = size[0], camera.height = size[1];
    TRY(inputs, load_reference_inputs(scene));
    for (const std::string& note : (*inputs)->notes) fmt::print(stderr, "{}\n", note);
    TRY(stars, point_stars(scene.sky, assets_directory()));
    Progress progress("reference picture", static_cast<long long>(size[0]) * size[1]);
    TRY(picture, reference::render_frame(
                     scene, (*inputs)->sky, (*inputs)->pictures(scene), options.samples.value_or(kSamples),
                     [&](long long n) { progress.advance(n); }, (*inputs)->far(), *stars));
    return Drawn{std::move(*picture), {}, {static_cast<double>(first[0]), static_cast<double>(first[1])}};
}

// The component along the line of a ray's impact parameter, right and up in the picture; nothing where it has no scale.
std::function<std::optional<double>(std::array<double, 2>)> impacts(const Scene& scene, const ProfileLine& line) {
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    const auto scale = spacetime && scene.camera.warp.empty() ? picture_scale(**spacetime, scene.camera) : std::nullopt;
    const auto centre = scale ? centre_px(**spacetime, scene.camera) : std::nullopt;
    if (!centre) return [](std::array<double, 2>) { return std::nullopt; };
    return
        [scale = *scale, centre = *centre, along = line.along](std::array<double, 2> place) -> std::optional<double> {
            const double x = place[0] - centre[0], y = place[1] - centre[1], off = std::hypot(x, y);
            if (off == 0.0) return 0.0;
            return scale.impact(off) * (x * along[0] + y * along[1]) / off;
        };
}

// At the middles of equal parts of the line.
std::vector<Point> points_of(const Scene& scene, const ProfileLine& line, const Drawn& drawn,
                             std::optional<int> steps) {
    const int count = steps.value_or(std::max(2, static_cast<int>(std::lround(line.to - line.from))));
    const auto impact = impacts(scene, line);
    std::vector<Point> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double px = line.from + (i + 0.5) * (line.to - line.from) / count;
        const auto place = line.at(px);
        const std::array<double, 2> drawn_at = {place[0] - drawn.corner[0], place[1] - drawn.corner[1]};
        points.push_back({place, px, impact(place), light_at<3>(drawn.picture, drawn_at)});
        if (!drawn.stokes.empty()) points.back().stokes = light_at<4>(drawn.stokes, drawn_at);
    }
    return points;
}

// What a place on the line is counted in besides px: its name in the table, in words, and one of it in r_s.
struct Unit {
    const char *column, *words;
    double length;
};
std::vector<Unit> units_of(const Scene& scene, const std::vector<Point>& points) {
    if (!points.front().impact) return {};
    std::vector<Unit> units = {{"M", "M", 0.5}};
    if (const auto length = length_of_microarcsecond(scene.object)) units.push_back({"uas", "µas", *length});
    return units;
}

constexpr const char* kLineColumns =
    "linear light along a line. x, y: place in the picture, px from its upper left corner; px: from the place that the "
    "line goes through; M, uas: impact parameter along the line, M = GM/c^2";
constexpr const char* kStokesColumns =
    "; stokes_q, stokes_u: of the luminance, angles from the picture's right towards up";

std::string profile_csv(const std::vector<Point>& points, const std::vector<Unit>& units, bool polarised) {
    std::string text = "x,y,px,";
    for (const Unit& unit : units) text += fmt::format("{},", unit.column);
    text += polarised ? "luminance,red,green,blue,stokes_q,stokes_u\n" : "luminance,red,green,blue\n";
    for (const Point& p : points) {
        text += fmt::format("{:.10g},{:.10g},{:.10g},", p.place[0], p.place[1], p.px);
        for (const Unit& unit : units) text += fmt::format("{:.10g},", *p.impact / unit.length);
        text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}", p.luminance(), p.light[0], p.light[1], p.light[2]);
        if (polarised) text += fmt::format(",{:.9g},{:.9g}", p.stokes[1], p.stokes[2]);
        text += '\n';
    }
    return text;
}

std::string profile_svg(const Scene& scene, const std::vector<Point>& points, const std::vector<Unit>& units) {
    std::vector<std::array<double, 2>> curve;
    curve.reserve(points.size());
    for (const Point& p : points)
        curve.push_back({units.empty() ? p.px : *p.impact / units.back().length, p.luminance()});
    return curve_plot(scene.name,
                      units.empty() ? "along the line, px" : fmt::format("along the line, {}", units.back().words),
                      curve);
}

// Of a [path] its first frame, as capture's.
Result<Scene> profile_scene(const ProfileOptions& options) {
    TRY(scene, asked_scene(options));
    if (options.time) scene->time = *options.time;
    if (!scene->path) return scene;
    TRY(path, CameraPath::make(*scene));
    const int width = scene->camera.width, height = scene->camera.height;
    scene->camera = path->at(0), scene->time += path->clock(0);
    scene->camera.width = width, scene->camera.height = height;
    scene->path.reset();
    return scene;
}

Result<int> run_profile(const ProfileOptions& options) {
    TRY(scene, profile_scene(options));
    if (scene->split || scene->camera.stereo != Stereo::kOff)
        return bad_input(fmt::format("{}: a profile is of one picture", options.scene),
                         "no [split] and no camera.stereo");
    TRY(context, check_context(options.renderer, options.context));
    TRY(line, profile_line(options, scene->camera));
    TRY(drawn, options.renderer == "gl" ? drawn_gl(options, *scene) : drawn_by_reference(options, *scene, *line));
    const auto points = points_of(*scene, *line, *drawn, options.steps);
    const auto units = units_of(*scene, points);
    const bool polarised = !drawn->stokes.empty();
    TRY(written, write_table(options.output + ".csv", profile_csv(points, units, polarised), options.output + ".svg",
                             profile_svg(*scene, points, units),
                             {*scene, options.scene, options.given.words(), drawn->by,
                              std::string(kLineColumns) + (polarised ? kStokesColumns : "")}));
    const auto peak = std::ranges::max_element(points, {}, &Point::luminance);
    fmt::print("{0}.csv, {0}.svg: {1} points along {2:.4g} px; brightest at {3:.4g} px", options.output, points.size(),
               line->to - line->from, peak->px);
    for (const Unit& unit : units) fmt::print(", {:.5g} {}", *peak->impact / unit.length, unit.words);
    fmt::print(": {:.4g}\n", peak->luminance());
    return 0;
}

}  // namespace

void add_profile(Command& parent) {
    auto [command, options] = add_command<ProfileOptions>(
        parent, "profile", "Profile of a scene's picture, brightness along a line: FILE.csv and FILE.svg", run_profile);
    options.given.of(command);
    const KeyRange times = key_range("time");
    required_option(command, "scene", options.scene,
                    "Scene file, or the name of a built-in scene (see: nullscope scenes)");
    set_option(command, options.set);
    text_option(command, "-o,--output", options.output, "Name of the files to write, without .csv and .svg");
    number_option(command, "--angle", options.angle, -360, 360,
                  "Direction of the line, degrees: 0 to the right, 90 upward");
    command.add_option("--through", &options.through,
                       "X,Y: a place on the line, px from the picture's top left corner (default: its middle)");
    number_option(command, "--steps", options.steps, 2, 100000,
                  "Number of points, the middles of equal parts of the line (default: one per pixel of its length)");
    command.add_option("--size", &options.size, "Picture size in pixels, WIDTHxHEIGHT (default: the scene's)");
    number_option(command, "--time", options.time, times.low, times.high, "Scene time in r_s/c (default: the scene's)");
    renderer_option(command, options.renderer);
    number_option(
        command, "--samples", options.samples, 1, 16,
        fmt::format("N x N rays per pixel (default: the scene's picture.samples; with --renderer reference {})",
                    kSamples));
    context_option(command, options.context);
}

}  // namespace nullscope::cli
