// nullscope trace: single rays, by the reference or through the shader's own text.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "cli/command.h"
#include "cli/ray_csv.h"
#include "command/ray_trace.h"
#include "scenefile/scene_file.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

struct Options : TraceOptions {
    std::vector<std::string> set;  // scenefile/scene_override.h
    std::string scene, rays, output;
};

Status run(const Options& options) {
    TRY(scene, asked_scene(options));
    TRY(spacetime, make_spacetime(scene->spacetime.metric, scene->spacetime.parameters));
    TRY(table, read_rays(options.rays, **spacetime));
    RayRecords records(table->rows.size());
    {
        Progress progress("rays", static_cast<long long>(records.size()));
        const TraceOutput output{[&](std::size_t i, RayRecord&& record) { records[i] = std::move(record); },
                                 [&](long long n) { progress.advance(n); },
                                 [&](std::size_t i, const Error& error) { return ray_error(*table, i, error); }};
        TRY(traced, trace_rays(*scene, **spacetime, table->queries, options, output));
    }
    const auto left_out = std::ranges::count(records, false, &std::optional<RayRecord>::has_value);
    for (const std::string& note : {left_out_note(static_cast<std::size_t>(left_out), records.size(), options),
                                    no_places_note(*scene, **spacetime, table->queries, options)})
        if (!note.empty()) fmt::print(stderr, "nullscope: {}\n", note);
    const std::string text = rays_text(*table, *scene, records, options.crossings,
                                       crossing_columns(*scene, **spacetime), (*spacetime)->length_unit());
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
    set_option(command, options.set);
    required_option(command, "--rays", options.rays,
                    "CSV with the columns r,theta,phi,n_r,n_theta,n_phi[,frame], or alpha,beta,theta[,phi] of an "
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
    context_option(command, options.context, "OpenGL context of --with gl: auto, egl, osmesa");
}

}  // namespace nullscope::cli
