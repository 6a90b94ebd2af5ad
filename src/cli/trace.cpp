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
#include "command/session.h"
#include "reference/disc_light.h"
#include "reference/ray_plane.h"
#include "reference/reference.h"
#include "scenefile/scene_file.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

struct Options {
    std::string scene, rays, output, with = "reference", method = "auto", context = "auto";
    int crossings = 0;
};

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
        record.hit = kDiscHit;
        if (std::isfinite(record.angle))
            record.angle = plane.crossing(static_cast<int>(k) + 1);  // of a ray that stays in a plane
        record.theta_inf = record.phi_inf = record.delay = kNotANumber;
        return;
    }
}

Result<RayRecords> trace_with_reference(const Scene& scene, const Spacetime& spacetime, const RayTable& table,
                                        int crossings, Progress& progress) {
    const bool opaque = scene.disc && scene.disc->opacity >= 1.0;
    TRY(metric, reference::make_metric(scene.spacetime));
    std::optional<reference::DiscLight> matter;
    if (crossings > 0 && has_matter(scene, spacetime)) matter.emplace(**metric, *scene.disc, scene.light);
    RayRecords records;
    for (const RayRow& row : table.rows) {
        const int listed = opaque ? std::max(crossings, kAllCrossings) : crossings;
        auto record = reference::trace_ray(scene, row.query, listed, matter ? &*matter : nullptr);
        if (!record) return ray_error(table, row, record.error().message());
        if (opaque) stop_at_disc(*scene.disc, row.query, *record);
        records.emplace_back(std::move(*record));
        progress.advance();
    }
    return records;
}

Result<Method> method_of(const Options& options) {
    if (options.method == "auto") return Method{};
    auto method = parse_method(options.method);
    if (!method) return bad_input("--method: " + method.error().message());
    if (options.with == "gl" || method->kind == MethodKind::kStrip || options.method == "table") return method;
    return bad_input(fmt::format("--method {}: not with --with {}", options.method, options.with),
                     "auto, strip and table, or --with gl");
}

Result<RayRecords> trace_rows(const Scene& scene, const RayTable& table, const Spacetime& spacetime,
                              const Options& options) {
    TRY(method, method_of(options));
    Progress progress("rays", static_cast<long long>(table.rows.size()));
    if (options.with == "reference") return trace_with_reference(scene, spacetime, table, options.crossings, progress);
    const ShaderRun run{options.with, *method, options.context, options.crossings};
    return trace_with_shader(scene, spacetime, table, run, [&](long long n) { progress.advance(n); });
}

Status run(const Options& options) {
    TRY(scene, load_scene(options.scene));
    TRY(spacetime, make_spacetime(scene->spacetime.metric, scene->spacetime.parameters));
    TRY(table, read_rays(options.rays, **spacetime));
    TRY(records, trace_rows(*scene, *table, **spacetime, options));
    if (const auto left_out = std::ranges::count(*records, false, &std::optional<RayRecord>::has_value); left_out > 0)
        fmt::print(stderr,
                   "nullscope: {} of {} rays left empty: --with {} needs rays of a static or rain observer with r up "
                   "to {:g}\n",
                   left_out, records->size(), options.with, kFarthestCamera);
    const auto asks_place = [](const RayRow& row) { return row.query.at_angle.has_value(); };
    const bool asks_plane = options.crossings > 0 || std::ranges::any_of(table->rows, asks_place);
    if (asks_plane && options.with != "reference" && !(*spacetime)->can_have_disc())
        fmt::print(stderr,
                   "nullscope: crossings and at left empty: --with {} does not compute them in metric {}; allowed: "
                   "--with reference\n",
                   options.with, scene->spacetime.metric);
    const std::string text = rays_text(*table, *scene, *records, options.crossings, (*spacetime)->length_unit(),
                                       has_matter(*scene, **spacetime));
    if (options.output.empty()) {
        std::fwrite(text.data(), 1, text.size(), stdout);
        return Done{};
    }
    return write_text_atomically(options.output, text);
}

}  // namespace

void add_trace(Command& parent) {
    auto [command, options] =
        add_command<Options>(parent, "trace", "Trace a list of rays: CSV in, CSV out (columns: docs/ray-data.md)", run);
    required_option(command, "scene", options.scene,
                    "Scene file, or the name of a built-in scene; its metric and disc are used, its camera is not");
    required_option(command, "--rays", options.rays,
                    "CSV with the columns r,theta,phi,n_r,n_theta,n_phi[,frame] or q,zeta0,s; optional at_angle; other "
                    "columns are copied");
    command.add_option("-o,--output", &options.output, "File to write (default: standard output)");
    text_option(
        command, "--with", options.with,
        "reference: double precision, every column. core64, core32: the shader's code compiled as C++ in double "
        "and float; gl: the shader on the GPU. These three leave turn empty, delay where the shader does not "
        "compute it, g of rays that do not escape, at beyond half a turn, and crossings from the 13th on",
        {"reference", "core64", "core32", "gl"});
    text_option(command, "--method", options.method,
                "How --with gl traces rays: auto (= strip), strip, table[:SIZE[:LOOKUP]], closed-form, "
                "integrate[:ORDER[:STEP]], euler:STEPS; core64 and core32 use strip, reference its own method");
    number_option(
        command, "--crossings", options.crossings, 0, 1000,
        "Number of crossings of the equatorial plane to list: r_1, phi_1, ...; with a thermal disc also g_1, ...");
    context_option(command, options.context, "OpenGL context of --with gl: auto, egl, osmesa");
}

}  // namespace nullscope::cli
