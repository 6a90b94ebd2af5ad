// nullscope trace: single rays, by the reference or through the shader's own text.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "cli/command.h"
#include "cli/ray_csv.h"
#include "cli/shader_rays.h"
#include "reference/disc_light.h"
#include "reference/ray_plane.h"
#include "reference/reference.h"
#include "scene/scene_file.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

struct Options {
    std::string scene, rays, output, with = "reference", method = "auto", context = "auto";
    int crossings = 0;
};
using Records = std::vector<std::optional<RayRecord>>;

// Windings before double precision cannot tell the ray from the critical one: about 12 half turns.
constexpr int kAllCrossings = 40;

// Whether the disc's matter moves and shines by itself, so that light from it has a shift.
bool has_matter(const Scene& scene, const Spacetime& spacetime) {
    return scene.disc && scene.disc->emission == DiscEmission::kThermal && spacetime.can_have_disc();
}

// Ends the ray on the scene's disc if that is opaque; everything along the light ray itself stays.
void stop_at_disc(const DiscSpec& disc, const RayQuery& query, RayRecord& record) {
    const Vec3 n = query.orbit ? Vec3{0, 0, 1} : query.n;  // the reduced form lies in the equatorial plane
    const reference::RayPlane plane(query.orbit ? M_PI / 2 : query.theta, query.orbit ? 0.0 : query.phi, n);
    for (std::size_t k = 0; k < record.crossings.size(); ++k) {
        const double r = record.crossings[k].r;
        if (!(r >= disc.inner && r <= disc.outer)) continue;
        record.fate = Fate::kHit;
        record.hit = Object::kDisc;
        if (std::isfinite(record.angle))
            record.angle = plane.crossing(static_cast<int>(k) + 1);  // of a ray that stays in a plane
        record.theta_inf = record.phi_inf = record.delay = kNotANumber;
        return;
    }
}

Result<Records> trace_with_reference(const Scene& scene, const Spacetime& spacetime, const RayTable& table,
                                     int crossings, Progress& progress) {
    const bool opaque = scene.disc && scene.disc->opacity >= 1.0;
    const auto metric = reference::make_metric(scene.spacetime);
    if (!metric) return metric.error();
    std::optional<reference::DiscLight> matter;
    if (crossings > 0 && has_matter(scene, spacetime)) matter.emplace(**metric, *scene.disc, scene.light);
    Records records;
    for (const RayRow& row : table.rows) {
        const int listed = opaque ? std::max(crossings, kAllCrossings) : crossings;
        auto record = reference::trace_ray(scene, row.query, listed, matter ? &*matter : nullptr);
        if (!record) return ray_error(table, row, record.error().message);
        if (opaque) stop_at_disc(*scene.disc, row.query, *record);
        records.emplace_back(std::move(*record));
        progress.advance();
    }
    return records;
}

Result<Method> method_of(const Options& options) {
    if (options.method == "auto") return Method{};
    auto method = parse_method(options.method);
    if (!method) return bad_input("--method: " + method.error().message);
    if (options.with == "gl" || method->kind == MethodKind::kStrip || options.method == "table") return method;
    return bad_input(fmt::format("--method {}: not with --with {}; allowed: auto, strip and table, or --with gl",
                                 options.method, options.with));
}

Result<Records> trace_rows(const Scene& scene, const RayTable& table, const Spacetime& spacetime,
                           const Options& options) {
    const auto method = method_of(options);
    if (!method) return method.error();
    Progress progress("rays", static_cast<long long>(table.rows.size()));
    if (options.with == "reference") return trace_with_reference(scene, spacetime, table, options.crossings, progress);
    const ShaderTracer tracer = options.with == "gl"       ? ShaderTracer::kGl
                                : options.with == "core32" ? ShaderTracer::kCore32
                                                           : ShaderTracer::kCore64;
    return trace_with_shader(scene, spacetime, table, {tracer, *method, options.context, options.crossings},
                             [&](long long n) { progress.advance(n); });
}

int run(const Options& options) {
    const auto scene = load_scene(options.scene);
    if (!scene) return report(scene.error());
    const auto spacetime = make_spacetime(scene->spacetime.metric, scene->spacetime.parameters);
    if (!spacetime) return report(spacetime.error());
    const auto table = read_rays(options.rays, **spacetime);
    if (!table) return report(table.error());
    const auto records = trace_rows(*scene, *table, **spacetime, options);
    if (!records) return report(records.error());
    if (const auto left_out = std::count(records->begin(), records->end(), std::nullopt); left_out > 0)
        fmt::print(stderr,
                   "nullscope: {} of {} rays left empty: --with {} needs a ray that somebody can look along, static or "
                   "rain, with r up to {:g}\n",
                   left_out, records->size(), options.with, kFarthestCamera);
    const bool asks_plane =
        options.crossings > 0 || std::any_of(table->rows.begin(), table->rows.end(),
                                             [](const RayRow& row) { return row.query.at_angle.has_value(); });
    if (asks_plane && options.with != "reference" && !(*spacetime)->can_have_disc())
        fmt::print(stderr,
                   "nullscope: crossings and at left empty: --with {} does not find them in metric {}; "
                   "allowed: --with reference\n",
                   options.with, scene->spacetime.metric);
    const std::string text =
        rays_text(*table, *records, options.crossings, (*spacetime)->length_unit(), has_matter(*scene, **spacetime));
    if (options.output.empty()) {
        std::fwrite(text.data(), 1, text.size(), stdout);
        return 0;
    }
    if (Status written = write_text_atomically(options.output, text); !written) return report(written.error());
    return 0;
}

}  // namespace

void add_trace(Command& parent) {
    auto options = std::make_shared<Options>();
    Command& command = parent.add_command("trace", "Trace a list of rays: CSV in, CSV out (columns: docs/ray-data.md)");
    command
        .add_option("scene", &options->scene,
                    "Scene file, or the name of one that ships; its metric and disc count, its camera does not")
        .required();
    command
        .add_option("--rays", &options->rays,
                    "CSV with the columns r,theta,phi,n_r,n_theta,n_phi[,frame] or q,zeta0,s; optional at_angle; "
                    "others pass through")
        .required();
    command.add_option("-o,--output", &options->output, "File to write (default: standard output)");
    command
        .add_option(
            "--with", &options->with,
            "reference: double precision, every column. core64, core32: the shader's text as C++ in double and float; "
            "gl: on the GPU. These three leave turn empty, delay where the shader does not know it, g unless escaped, "
            "at beyond half a turn, and "
            "every crossing but the first")
        .one_of({"reference", "core64", "core32", "gl"})
        .show_default();
    command
        .add_option("--method", &options->method,
                    "How --with gl traces: auto (= strip), strip, table[:SIZE[:LOOKUP]], closed-form, "
                    "integrate[:ORDER[:STEP]]; "
                    "core64 and core32 have the strip, the reference its own")
        .show_default();
    command
        .add_option("--crossings", &options->crossings,
                    "List this many crossings of the equatorial plane: r_1, phi_1, ...; of a scene with a thermal disc "
                    "g_1, ... too")
        .in_range(0, 1000)
        .show_default();
    context_option(command, options->context, "OpenGL context of --with gl: auto, egl, osmesa");
    command.on_run([options] { return run(*options); });
}

}  // namespace nullscope::cli
