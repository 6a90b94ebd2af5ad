// nullscope bench rays: rays of a list by each tracer, as `nullscope trace` and Python's trace() have them: how many a core-second traces,
// behind what it takes to begin, and how far they are from the reference's.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "bench/bench.h"
#include "bench/spread_json.h"
#include "command/json.h"
#include "command/ray_trace.h"
#include "compare/ray_errors.h"
#include "scenefile/scene_file.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

constexpr int kSide = 320;             // 102,400 rays of each scene
constexpr std::size_t kJudged = 2000;  // of them that the reference traces
constexpr double kFar = 500.0;         // r_s: 1000 M

struct RaysBench : BenchOptions {
    RaysBench() { scenes = {}, frames = 4; }
    int crossings = 1;
};

// Kerr's hole of a = 0.9 M from 1000 M, and a disc in whose plane rays cross.
Scene far_hole() {
    Scene scene;
    scene.name = "a = 0.9 from 1000 M";
    scene.spacetime = {"kerr", {{"spin", 0.9}}};
    scene.disc = DiscSpec{};
    scene.disc->inner = 1.17, scene.disc->outer = 20.0;
    scene.disc->opacity = 0.5;  // rays go on behind it
    scene.disc->emission = DiscEmission::kThermal;
    scene.camera.r = kFar, scene.camera.theta = 75.0 * M_PI / 180;
    scene.camera.plane_width = 0.04;
    return scene;
}

double core_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Traced {
    std::vector<std::optional<RayRecord>> records;
    double first_s = 0, rest_s = 0;  // core-seconds until the first rays are done, and of the others
    long long first = 0, rest = 0;   // rays
};

Result<Traced> traced(const Scene& scene, const Spacetime& spacetime, const std::vector<RayQuery>& rays,
                      const TraceOptions& options) {
    Traced traced;
    traced.records.resize(rays.size());
    const double begun_s = core_seconds();
    const TraceOutput output{[&](std::size_t i, RayRecord&& record) { traced.records[i] = std::move(record); },
                             [&](long long n) {
                                 if (n == 0) return;
                                 const double now_s = core_seconds() - begun_s;
                                 if (traced.first == 0)
                                     traced.first = n, traced.first_s = now_s;
                                 else
                                     traced.rest += n, traced.rest_s = now_s - traced.first_s;
                             },
                             [](std::size_t, Error error) { return error; }};
    TRY(done, trace_rays(scene, spacetime, rays, options, output));
    return traced;
}

struct Errors {
    Spread sky, r, phi, g;  // rad; relative; rad; relative
    long long fates = 0, counted = 0;
};

Errors errors_of(const std::vector<std::optional<RayRecord>>& records, const std::vector<std::size_t>& rows,
                 const std::vector<std::optional<RayRecord>>& exact) {
    std::vector<float> sky, r, phi, g;
    Errors errors;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!records[rows[i]] || !exact[i]) continue;
        const RayRecord &one = *records[rows[i]], &other = *exact[i];
        ++errors.counted;
        errors.fates += one.fate != other.fate;
        if (one.fate != other.fate) continue;
        if (one.fate == Fate::kEscaped) sky.push_back(static_cast<float>(angle_between(one.sky, other.sky)));
        for (std::size_t k = 0; k < std::min(one.crossings.size(), other.crossings.size()); ++k) {
            const auto &a = one.crossings[k], &b = other.crossings[k];
            r.push_back(static_cast<float>(std::fabs(a.r / b.r - 1.0)));
            phi.push_back(static_cast<float>(std::fabs(std::remainder(a.phi - b.phi, 2 * M_PI))));
            if (std::isfinite(b.g)) g.push_back(static_cast<float>(std::fabs(a.g / b.g - 1.0)));
        }
    }
    errors.sky = spread_of(sky), errors.r = spread_of(r), errors.phi = spread_of(phi), errors.g = spread_of(g);
    return errors;
}

std::string words_of(const Spread& s) {
    return s.count == 0 ? "" : fmt::format("{:.1e}, {:.1e}, {:.1e}", s.max, s.p999, s.median);
}
Status measure(const Scene& scene, const RaysBench& options, Json& rows) {
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    CameraSpec camera = scene.camera;
    camera.width = camera.height = kSide;
    const std::vector<RayQuery> once = rays_of(camera);
    std::vector<RayQuery> all;
    for (int again = 0; again < options.frames; ++again) all.insert(all.end(), once.begin(), once.end());
    std::vector<RayQuery> judged;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < kJudged; ++i) {
        places.push_back(i * once.size() / kJudged);
        judged.push_back(once[places.back()]);
    }
    const TraceOptions by_reference{.crossings = options.crossings};
    TRY(exact, traced(scene, **spacetime, judged, by_reference));
    fmt::print(
        "{}, {} rays, {} crossings\n\n| tracer | rays a core-second | core-s to begin | fates | sky rad: max, "
        "99.9 %, median | r_k | phi_k rad | g_k |\n|---|---|---|---|---|---|---|---|\n",
        scene.name, once.size(), options.crossings);
    for (const std::string with : {"gl", "core64", "core32", "reference"}) {
        const bool slow = with == "reference";
        TraceOptions by = by_reference;
        by.with = with, by.context = options.context;
        Traced found;
        if (slow) {
            found = *exact;
        } else {
            TRY(listed, traced(scene, **spacetime, all, by));
            found = std::move(*listed);
        }
        const double rate = static_cast<double>(found.rest) / found.rest_s,
                     begin_s = std::max(found.first_s - static_cast<double>(found.first) / rate, 0.0);
        const Errors e = slow ? Errors{} : errors_of(found.records, places, exact->records);
        fmt::print("| {} | {:.0f} | {:.2f} | {} | {} | {} | {} | {} |\n", with, rate, begin_s, e.fates, words_of(e.sky),
                   words_of(e.r), words_of(e.phi), words_of(e.g));
        std::fflush(stdout);
        rows.push_back({{"scene", scene.name},
                        {"tracer", with},
                        {"rays_a_core_second", rate},
                        {"begin_core_seconds", begin_s},
                        {"judged", e.counted},
                        {"fate_errors", e.fates},
                        {"sky_rad", spread_json(e.sky)},
                        {"r", spread_json(e.r)},
                        {"phi_rad", spread_json(e.phi)},
                        {"g", spread_json(e.g)}});
    }
    return Done{};
}

Status run_rays(const RaysBench& options) {
    Json rows = Json::array();
    if (options.scenes.empty()) {
        TRY(done, measure(far_hole(), options, rows));
    }
    for (const std::string& name : options.scenes) {
        TRY(scene, load_scene(name));
        TRY(done, measure(*scene, options, rows));
    }
    return write_json(options.json, rows);
}

}  // namespace

void add_bench_rays(Command& bench) {
    auto [command, options] = add_command<RaysBench>(
        bench, "rays",
        "Rays of a list by each tracer: how many a core-second traces, and how far they are from "
        "the reference's",
        run_rays);
    command.add_option("scenes", &options.scenes,
                       "Scenes through whose pixels rays are traced (default: Kerr's hole of a = 0.9 from 1000 M)");
    context_option(command, options.context);
    number_option(command, "--crossings", options.crossings, 0, 12, "Crossings of the equatorial plane to list");
    number_option(command, "--times", options.frames, 2, 100,
                  "How often the list of 102,400 rays is traced, in one go");
    json_option(command, options);
}

}  // namespace nullscope::cli
