// nullscope trace: single rays, by the reference or through the shader's own text.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "base/text.h"
#include "cli/command.h"
#include "cli/curve_file.h"
#include "cli/ray_csv.h"
#include "command/ray_curves.h"
#include "command/ray_derivatives.h"
#include "command/ray_trace.h"
#include "scenefile/scene_file.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

struct Options : TraceOptions {
    std::vector<std::string> set;  // scenefile/scene_override.h
    std::string scene, rays, output;
    int points = 0;  // of each ray as a curve; 0: rays as rows
    double far = reference::CurveSpec{}.farthest;
    std::optional<double> to_r, to_theta, to_mino;
    CurveForm form;
    std::string derivatives;  // parameters, with commas between
};

bool ends_in_obj(const std::string& name) { return name.ends_with(".obj") || name.ends_with(".OBJ"); }

Status write(const Options& options, const std::string& text) {
    if (!options.output.empty()) return write_text_atomically(options.output, text);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return Done{};
}

Status check_curve_options(const Options& options) {
    const bool ends =
        options.far != reference::CurveSpec{}.farthest || options.to_r || options.to_theta || options.to_mino;
    if (options.points == 0) {
        if (options.form.cartesian || options.form.rates || ends)
            return bad_input("--cartesian, --rates, --far, --to-r, --to-theta and --to-mino are of curves",
                             "with --points N");
        if (ends_in_obj(options.output))
            return bad_input(fmt::format("-o {}: a polyline needs points", options.output), "--points N, or a .csv");
        return Done{};
    }
    if (options.points == 1) return bad_input("--points 1: one point is no curve", "[2, 100000]");
    if (options.with != "reference" || options.method != "auto" || !options.context.is_auto())
        return bad_input("--points: curves are the reference's", "--with reference, without --method and --context");
    if (options.crossings > 0) return bad_input("--points: not with --crossings", "one of them");
    if (ends_in_obj(options.output) && options.form.rates)
        return bad_input("--rates: an OBJ file has places alone", "a .csv");
    return Done{};
}

Status write_curves(const Options& options, const Scene& scene, const Spacetime& spacetime, const RayTable& table) {
    std::vector<Curve> curves(table.queries.size());
    {
        Progress progress("rays", static_cast<long long>(curves.size()));
        const CurveOutput output{[&](std::size_t i, Curve&& curve) { curves[i] = std::move(curve); },
                                 [&](long long n) { progress.advance(n); },
                                 [&](std::size_t i, const Error& error) { return ray_error(table, i, error); }};
        TRY(traced,
            trace_curves(scene, spacetime.length_unit(), table.queries,
                         {options.points, options.far, options.to_r, options.to_theta, options.to_mino}, output));
    }
    const auto without = std::ranges::count_if(curves, [](const Curve& curve) { return curve.empty(); });
    const std::string note = no_curve_note(static_cast<std::size_t>(without), curves.size(), options.far);
    if (!note.empty()) fmt::print(stderr, "nullscope: {}\n", note);
    return write(options, ends_in_obj(options.output) ? curves_obj(curves) : curves_csv(curves, options.form));
}

Status check_derivative_options(const Options& options) {
    if (options.derivatives.empty()) return Done{};
    if (options.points > 0) return bad_input("--derivatives: not of curves", "without --points");
    if (options.with != "reference")
        return bad_input(fmt::format("--derivatives: not with --with {}", options.with), "--with reference");
    return Done{};
}

Result<MoreColumns> derivative_columns(const Options& options, const Scene& scene, const RayTable& table,
                                       const RayRecords& records) {
    MoreColumns more;
    if (options.derivatives.empty()) return more;
    auto tracer = DerivativeTracer::make(scene, split(options.derivatives, ','), options.crossings);
    if (!tracer) return bad_input("--derivatives: " + tracer.error().what, tracer.error().allowed);
    more.header = ",derivatives";
    for (const std::string& column : tracer->columns()) more.header += ',' + column;
    Progress progress("derivatives", static_cast<long long>(records.size()));
    for (std::size_t i = 0; i < records.size(); ++i) {
        auto found = tracer->derivatives(table.queries[i], *records[i]);
        if (!found) return ray_error(table, i, found.error());
        std::string row = fmt::format(",{}", kDerivativeStates[static_cast<int>(found->state)]);
        for (const double value : found->values) row += std::isfinite(value) ? fmt::format(",{:.17g}", value) : ",";
        more.rows.push_back(std::move(row));
        progress.advance(1);
    }
    return more;
}

Status run(const Options& options) {
    TRY(fitting, check_curve_options(options));
    TRY(of_rays, check_derivative_options(options));
    TRY(scene, asked_scene(options));
    TRY(spacetime, make_spacetime(scene->spacetime.metric, scene->spacetime.parameters));
    TRY(table, read_rays(options.rays, **spacetime));
    if (options.points > 0) return write_curves(options, *scene, **spacetime, *table);
    RayRecords records(table->rows.size());
    {
        Progress progress("rays", static_cast<long long>(records.size()));
        const TraceOutput output{[&](std::size_t i, RayRecord&& record) { records[i] = std::move(record); },
                                 [&](long long n) { progress.advance(n); },
                                 [&](std::size_t i, const Error& error) { return ray_error(*table, i, error); },
                                 note_on_terminal};
        TRY(traced, trace_rays(*scene, **spacetime, table->queries, options, output));
    }
    const auto left_out = std::ranges::count(records, false, &std::optional<RayRecord>::has_value);
    for (const std::string& note : {left_out_note(static_cast<std::size_t>(left_out), records.size(), options),
                                    no_places_note(*scene, **spacetime, table->queries, options)})
        if (!note.empty()) fmt::print(stderr, "nullscope: {}\n", note);
    TRY(more, derivative_columns(options, *scene, *table, records));
    const std::string text = rays_text(*table, *scene, records, options.crossings,
                                       crossing_columns(*scene, **spacetime), (*spacetime)->length_unit(), *more);
    return write(options, text);
}

}  // namespace

void add_trace(Command& parent) {
    auto [command, options] =
        add_command<Options>(parent, "trace", "Trace a list of rays: CSV in, CSV out (columns: docs/ray-data.md)", run);
    required_option(command, "scene", options.scene,
                    "Scene file, or the name of a built-in scene; its metric and disc are used, its camera is not");
    set_option(command, options.set);
    required_option(command, "--rays", options.rays,
                    "CSV with the columns r,theta,phi,n_r,n_theta,n_phi[,frame], or alpha,beta,theta[,phi,unit] or "
                    "lambda,eta,theta[,up,phi,unit] of an "
                    "observer at infinity, or "
                    "q,zeta0,s; optional at_angle; other columns are copied");
    command.add_option("-o,--output", &options.output, "File to write (default: standard output)");
    text_option(
        command, "--with", options.with,
        "reference: double precision, every column. core64, core32: the shader's code compiled as C++ in double "
        "and float; gl: the shader on the GPU. These three leave turn empty, delay where the shader does not "
        "compute it, g of rays that do not escape, and crossings from the 13th on",
        {"reference", "core64", "core32", "gl"});
    text_option(command, "--method", options.method,
                "How --with gl traces rays: auto (= strip), strip, table[:SIZE[:LOOKUP]], closed-form, "
                "integrate[:ORDER[:STEP]], euler:STEPS; core64 and core32 use strip, reference its own method");
    number_option(command, "--crossings", options.crossings, 0, 1000,
                  "Number of crossings of the equatorial plane to list: r_1, phi_1, ...; with a thermal disc also g_1, "
                  "..., with a polarised one "
                  "chi_1, p_1, ...");
    command.add_option(
        "--derivatives", &options.derivatives,
        "Derivatives too: KEY,KEY,... of spin, charge (where the metric has them), camera.r, .theta, .phi, "
        ".yaw, .pitch, .roll, .fov, disc.tilt, .node, .precession: columns derivatives (yes, edge or "
        "lost) and d_KEY.x, .y, .z, .g, .delay, .r_1, .phi_1, ... per rad, r_s or 1; with the reference");
    stage_option(command, options.stage);
    context_option(command, options.context, "OpenGL context of --with gl");
    number_option(
        command, "--points", options.points, 0, kMostCurvePoints,
        "Each ray as a curve of N points instead: ray, lambda (affine parameter), r, theta, phi, t; -o NAME.obj "
        "writes polylines");
    number_option(command, "--far", options.far, 1e-3, 1e9,
                  "With --points: radius beyond which curves are left out, r_s (wormholes: the throat's radius)");
    number_option(command, "--to-r", options.to_r, -1e9, 1e9,
                  "With --points: a curve ends where it first has this r, r_s (wormholes: l, in the throat's radius)");
    number_option(command, "--to-theta", options.to_theta, 0, 3.141592653589793,
                  "With --points: ... this polar angle, rad");
    number_option(command, "--to-mino", options.to_mino, 1e-9, 1e9,
                  "With --points: ... this of Mino's time after its first point, 1/r_s");
    command.add_flag("--cartesian", &options.form.cartesian, "With --points: x, y, z instead of r, theta, phi");
    command.add_flag("--rates", &options.form.rates, "With --points: derivatives by lambda too");
}

}  // namespace nullscope::cli
