// nullscope visibility: what the baselines of telescopes measure of a scene's picture.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "cli/visibility_request.h"
#include "cli/visibility_tables.h"
#include "command/arguments.h"
#include "command/ring_parts.h"
#include "command/shot.h"
#include "command/sky_light.h"
#include "observer/path.h"
#include "scenefile/scene_keys.h"
#include "telescope/first_minimum.h"
#include "telescope/scattering.h"
#include "telescope/sky_sum.h"

namespace nullscope::cli {
namespace {

// A picture that is drawn or read, and what is said of it.
struct SeenSky {
    SkyLight light;
    std::string title, drawn_by{};
    std::optional<Scene> scene{};        // that was drawn
    std::optional<SkyParts> parts{};     // then its grid is `light`
    std::optional<SkyPicture> coarse{};  // the same, drawn with half as many pixels a side
};

bool is_several(const Scene& scene) { return scene.split || scene.camera.stereo != Stereo::kOff; }

// Of a [path] its first frame, as capture's.
Result<Shot> visibility_shot(const VisibilityOptions& options) {
    TRY(scene, asked_scene(options));
    Shot shot{std::move(*scene)};
    if (options.time) shot.scene.time = *options.time;
    if (options.samples && options.renderer == "gl") shot.scene.picture.samples = *options.samples;
    if (shot.scene.path) {
        TRY(path, CameraPath::make(shot.scene));
        shot.path = std::move(*path);
    }
    if (is_several(shot.scene))
        return bad_input(fmt::format("{}: visibilities are of one picture", options.scene),
                         "no [split] and no camera.stereo");
    return shot;
}

double longest_of(const VisibilityRows& rows) {
    double longest = 0;
    for (const auto& [u, v] : rows.baselines) longest = std::max(longest, std::hypot(u, v));
    return longest;
}

// What the pixels' light is with half as many of them a side; chart, share: of parts. Nothing: they are no whole number.
Result<std::optional<SkyPicture>> drawn_coarser(const Shot& shot, Session* session, const Exposure& shown,
                                                const DrawOptions& drawing, const std::optional<RingChart>& chart,
                                                double share) {
    const CameraSpec& camera = shown.scene.camera;
    if (camera.width % 2 != 0 || camera.height % 2 != 0) return std::optional<SkyPicture>();
    const Exposure coarse = changed(shown, [](Scene scene) {
        scene.camera.width /= 2, scene.camera.height /= 2;
        return scene;
    });
    TRY(captured, draw_shot(shot, session, coarse, drawing, false));
    TRY(light, sky_light(coarse.scene, *captured));
    if (chart) take_band(coarse.scene.camera, *chart, light->picture);
    for (double& value : light->picture.flux.data) value *= share;
    return std::optional(std::move(light->picture));
}

Result<SeenSky> drawn_sky(const VisibilityOptions& options, const Shot& shot, double longest) {
    DrawOptions drawing;
    drawing.stokes = true;
    const Exposure shown = exposure_in(shot, 0, 0);
    std::optional<RingChart> chart;
    if (options.rings) {
        TRY(made, ring_chart(shown.scene, longest));
        chart = std::move(*made);
    }
    std::optional<Session> session;
    if (options.renderer == "gl") {
        TRY(method, chosen_method("auto", {}, shot.scene, drawing.listener));
        TRY(opened, open_session(options.context));
        session = std::move(*opened);
        session->renderer->set_method(*method);
        session->renderer->limit_tiles(worth_tiles(shot, 1) ? Tiles::kTraced : Tiles::kBodies);
    } else {
        drawing.samples = options.samples;
    }
    Session* drawn_on = session ? &*session : nullptr;
    TRY(captured, draw_shot(shot, drawn_on, shown, drawing, false));
    SeenSky seen{{}, shown.scene.name, captured->made_by, shown.scene};
    if (chart) {
        TRY(parts, sky_parts(shot, drawn_on, shown, drawing, *captured, *chart));
        seen.light = parts->grid, seen.parts = std::move(*parts);
    } else {
        TRY(light, sky_light(shown.scene, *captured));
        seen.light = std::move(*light);
    }
    TRY(coarse, drawn_coarser(shot, drawn_on, shown, drawing, chart, seen.parts ? seen.parts->share : 1));
    seen.coarse = std::move(*coarse);
    return seen;
}

// What is known of a scene's light before it is drawn. Error: it has no scale.
Result<LightSource> source_in(const Scene& scene) {
    TRY(scaled, sky_scale(scene));
    LightSource source;
    if (const auto unit = flux_unit(scene, false)) source.frequency_GHz = unit->frequency_GHz;
    if (const KnownObject* known = known_object(scene.object.name)) source.place = known->place;
    return source;
}

void scatter(const VisibilityOptions& options, double frequency_ghz, VisibilityRows& rows) {
    if (options.scattering == "none") return;
    for (std::size_t i = 0; i < rows.found.size(); ++i) {
        const double of_row = rows.frequency_ghz.empty() ? frequency_ghz : rows.frequency_ghz[i];
        const double factor = scattering(kSgrAScattering, rows.baselines[i], 1e9 * of_row);
        for (std::complex<double>& plane : rows.found[i]) plane *= factor;
    }
}

void add_noise(const VisibilityOptions& options, VisibilityRows& rows) {
    if (rows.noise.empty()) return;
    const auto seed = static_cast<std::uint64_t>(options.noise.value_or(0));
    const std::size_t planes = rows.polarised ? 4 : 1;
    for (std::size_t i = 0; i < rows.found.size(); ++i)
        for (std::size_t plane = 0; plane < planes; ++plane)
            rows.found[i][plane] += rows.noise[i] * noise_at(seed, 4 * i + plane);
}

// ", first minimum at 3.76 Gλ: 0.0012", of a line.
std::string minimum_words(const SkySum& picture, const VisibilityRows& rows) {
    if (!rows.is_line) return "";
    std::vector<double> amplitudes;
    for (const Visibility& found : rows.found) amplitudes.push_back(std::abs(found[0]));
    const auto least =
        first_minimum([&](Baseline b) { return std::abs(picture.at(b)[0]); }, rows.baselines, amplitudes);
    if (!least) return "";
    return fmt::format("; first minimum of |V| at {:.7g} Gλ: {:.3g}",
                       1e-9 * std::hypot(least->baseline.u, least->baseline.v), least->amplitude);
}

// What the pixels do not hold. reach: reach_of().
void say_limits(const SeenSky& sky, const VisibilityRows& rows, double reach, const Listener& listener) {
    if (!sky.light.in_jansky) listener.note("the picture is not in Jy: visibilities are fractions of its whole light");
    const double repeats = 0.5 / sky.light.picture.pixel;
    const char* farther = sky.parts   ? "a larger --size of the same view reaches farther"
                          : sky.scene ? "a larger --size of the same view reaches farther, --rings too"
                                      : "a finer picture reaches farther";
    if (std::ranges::any_of(rows.baselines,
                            [&](Baseline b) { return std::max(std::fabs(b.u), std::fabs(b.v)) > repeats; }))
        listener.note(fmt::format(
            "beyond {:.4g} Gλ, where a fringe is two pixels wide, V is of the pixels, not of the source: {}",
            1e-9 * repeats, farther));
    if (std::isfinite(reach))
        listener.note(
            fmt::format("V may be off by more than {:g} % from {:.4g} Gλ on, where it changes by that with half as "
                        "many {} a side: {}",
                        100 * kReachShare, 1e-9 * reach, sky.parts ? "pixels and rays" : "pixels", farther));
}

Status write_visibilities(const VisibilityOptions& options, const SeenSky& sky, const VisibilityRows& rows) {
    if (rows.of_array()) {
        TRY(phases, write_text_atomically(options.output + "-closure-phases.csv", closure_phase_csv(rows)));
        TRY(amplitudes, write_text_atomically(options.output + "-closure-amplitudes.csv", closure_amplitude_csv(rows)));
    }
    TableOrigin origin{sky.scene.value_or(Scene{}), sky.scene ? options.scene : "", options.given.words(), sky.drawn_by,
                       visibility_columns(rows)};
    origin.of_scene = sky.scene.has_value();
    if (sky.scene) origin.times = {sky.scene->time};
    return write_table(options.output + ".csv", visibility_csv(rows), options.output + ".svg",
                       visibility_svg(sky.title, rows), origin);
}

void print_visibilities(const VisibilityOptions& options, const SeenSky& sky, const SkySum& picture,
                        const VisibilityRows& rows, double frequency_ghz) {
    fmt::print("{0}.csv, {0}.svg: {1} baselines up to {2:.4g} Gλ", options.output, rows.baselines.size(),
               1e-9 * longest_of(rows));
    if (rows.of_array())
        fmt::print(" of {} stations in {} scans at {:g} GHz", rows.stations.size(), rows.seen.scans.size(),
                   frequency_ghz);
    fmt::print("; {}x{} pixels ({}s) of {:.4g} µas", sky.light.picture.flux.width, sky.light.picture.flux.height,
               options.pixel, sky.light.picture.pixel * 180 / M_PI * 3600e6);
    if (sky.parts) fmt::print(" and {}x{} rays along the critical curve", sky.parts->across, sky.parts->around);
    if (sky.light.in_jansky) fmt::print("; {:.4g} Jy in all", rows.whole);
    fmt::print("{}\n", minimum_words(picture, rows));
}

// Rows that are asked for, of a picture that there is.
Result<int> measured(const VisibilityOptions& options, const SeenSky& sky, VisibilityRows rows, double frequency_ghz) {
    const auto shape = static_cast<PixelShape>(std::ranges::find(kPixelShapes, options.pixel) - kPixelShapes.begin());
    const SkySum picture{PictureVisibility(sky.light.picture, shape),
                         sky.parts ? std::optional(sky.parts->band) : std::nullopt,
                         sky.coarse ? std::optional(PictureVisibility(*sky.coarse, shape)) : std::nullopt};
    const std::vector<VisibilitySum> sums = picture.with_change(rows.baselines);
    for (const VisibilitySum& sum : sums) rows.found.push_back(sum.all);
    rows.whole = total_flux(sky.light.picture) + (sky.parts ? sky.parts->band.whole() : 0.0);
    rows.in_jansky = sky.light.in_jansky, rows.polarised = sky.light.picture.flux.channels == 4;
    scatter(options, frequency_ghz, rows);
    add_noise(options, rows);
    say_limits(sky, rows, reach_of(rows.baselines, sums), Listener());
    TRY(written, write_visibilities(options, sky, rows));
    print_visibilities(options, sky, picture, rows, frequency_ghz);
    return 0;
}

Result<int> run_on_image(const VisibilityOptions& options) {
    for (const char* name : {"--size", "--time", "--renderer", "--samples", "--context", "--device", "--rings"})
        if (options.given.has(name))
            return bad_input(fmt::format("{}: --image is a picture as it is", name), "with a scene");
    TRY(fits, load_fits(options.image));
    TRY(light, sky_light(*fits, options.image));
    const LightSource source{light->frequency_GHz, light->place};
    TRY(frequency, frequency_of(options, source));
    TRY(rows, requested_rows(options, source));
    const SeenSky sky{std::move(*light), std::filesystem::path(options.image).filename().string()};
    return measured(options, sky, std::move(*rows), *frequency);
}

Result<int> run_visibility(const VisibilityOptions& options) {
    if (options.scene.empty() == options.image.empty())
        return bad_input(options.scene.empty() ? "neither a scene nor --image" : "a scene and --image", "one of both");
    if (!options.image.empty()) return run_on_image(options);
    if (options.rings && options.given.has("--pixel"))
        return bad_input("--pixel: the rays of --rings are points, so are its pixels", "one of both");
    TRY(context, check_context(options.renderer, options.context));
    TRY(shot, visibility_shot(options));
    TRY(source, source_in(scene_at(*shot, 0, 0)));
    TRY(frequency, frequency_of(options, *source));
    TRY(rows, requested_rows(options, *source));
    TRY(sky, drawn_sky(options, *shot, longest_of(*rows)));
    return measured(options, *sky, std::move(*rows), *frequency);
}

void add_array_options(Command& command, VisibilityOptions& options) {
    command.add_option(
        "--array", &options.array,
        "Stations that see the source as the Earth turns: an array that ships (eht-2017, eht-2017-space), or "
        "a file");
    command
        .add_option(
            "--hours", &options.hours,
            "FROM TO STEP: scans, hours of Greenwich sidereal time, or with --mjd of UT (default: 24 h, every 10 "
            "minutes)")
        .count(3)
        .needs("--array");
    number_option(command, "--mjd", options.mjd, -100000, 200000, "Day whose hours --hours are, modified Julian date")
        .needs("--array");
    command
        .add_option("--source", &options.source,
                    "RA DEC of the source, hours and degrees (default: the [object]'s, or the image's)")
        .count(2)
        .needs("--array");
    number_option(command, "--elevation", options.elevation_deg, -90, 90,
                  "Least height of the source over a station's horizon, degrees")
        .needs("--array");
    number_option(command, "--noise", options.noise, 0, 2147483647, "Adds thermal noise; the number chooses which")
        .needs("--array");
    number_option(command, "--bandwidth", options.bandwidth_GHz, 1e-6, 1000, "Of the noise, GHz").needs("--noise");
    number_option(command, "--integration", options.integration_s, 1e-3, 1e6, "Time that is averaged, of the noise, s")
        .needs("--noise");
}

}  // namespace

void add_visibility(Command& parent) {
    auto [command, options] = add_command<VisibilityOptions>(
        parent, "visibility",
        "What baselines of telescopes measure of a scene's picture: FILE.csv and FILE.svg; of an array closure "
        "phases and amplitudes too",
        run_visibility);
    options.given.of(command);
    const KeyRange times = key_range("time");
    command.add_option("scene", &options.scene,
                       "Scene file, or the name of a built-in scene, of an object with mass and distance");
    set_option(command, options.set);
    command.add_option("--image", &options.image, "Instead of a scene: a FITS picture of the sky");
    text_option(command, "-o,--output", options.output, "Name of the files to write, without .csv and .svg");
    command.add_option("--baselines", &options.baselines,
                       "Table (CSV) with the columns u, v (wavelengths), and if you like time_h, frequency_ghz");
    command
        .add_option("--radial", &options.radial,
                    "ANGLE MAX: baselines from 0 to MAX Gλ along a position angle, degrees from north through east")
        .count(2);
    number_option(command, "--points", options.points, 2, 1000000, "Number of baselines of --radial").needs("--radial");
    add_array_options(command, options);
    number_option(command, "--frequency", options.frequency_GHz, 1e-3, 1e6,
                  "GHz, of light that has no frequency of its own (default: 230)");
    text_option(command, "--scattering", options.scattering,
                "Blurs by interstellar matter: sgr-a, the Gaussian of Johnson et al. (2018)", {"none", "sgr-a"});
    text_option(command, "--pixel", options.pixel, "What stands for a pixel's light; ehtim's own is triangle",
                {kPixelShapes.begin(), kPixelShapes.end()});
    command.add_flag("--rings", &options.rings,
                     "Rays in a band along the critical curve, denser towards it, beside the pixels: for baselines "
                     "that see the photon ring");
    command.add_option("--size", &options.size, "Picture size in pixels, WIDTHxHEIGHT (default: the scene's)");
    number_option(command, "--time", options.time, times.low, times.high, "Scene time in r_s/c (default: the scene's)");
    renderer_option(command, options.renderer);
    number_option(command, "--samples", options.samples, 1, 16,
                  "N x N rays per pixel (default: the scene's picture.samples; with --renderer reference 3)");
    context_option(command, options.context);
}

}  // namespace nullscope::cli
