// nullscope bench hard: the list of hard cases, what each may err by, and what every witness measures.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "cli/bench.h"
#include "cli/json.h"
#include "cli/session.h"
#include "compare/hard_cases.h"
#include "compare/ray_metrics.h"
#include "reference/reference.h"

namespace nullscope::cli {
namespace {

struct Options {
    std::string json, reference, only;
};

constexpr double kRefineAbove_px = 1e-5;  // below every bound of the list but those of frames of a pixel or two
constexpr std::array<const char*, 4> kWitnesses = {"core64", "core32", "egl", "osmesa"};

struct Measured {
    HardBound bound, error;  // px
    long long fate_errors = 0, not_finite = 0;
    double over_bound() const {  // more than 1: outside
        if (fate_errors + not_finite > 0) return INFINITY;
        return std::max(
            {error.sky / bound.sky, error.place / bound.place, error.swept / bound.swept, error.g / bound.g});
    }
};

struct ReferenceRow {
    double error_px = 0, bound_px = 0;
};

struct Row {
    const HardCase* hard = nullptr;
    RayFrame exact;
    std::optional<ReferenceRow> reference;
    std::array<std::optional<Measured>, kWitnesses.size()> witness;
    bool within() const {
        if (reference && !(reference->error_px <= reference->bound_px)) return false;
        return std::all_of(witness.begin(), witness.end(), [](const auto& m) { return !m || m->over_bound() <= 1; });
    }
};

Measured measured(const Row& row, const RayFrame& tested, double bit) {
    const Scene& scene = row.hard->scene;
    const ExactTrace trace = [&](const std::vector<std::array<double, 2>>& positions) {
        auto pixels = reference::trace_pixels(scene, positions);
        return pixels ? std::move(*pixels) : std::vector<RayPixel>(positions.size());
    };
    const RayMeasures m = measure_rays(tested, scene.camera, trace, 1, kRefineAbove_px);
    return {hard_bound(scene, row.exact, bit),
            {m.sky_px.max, m.place_px.max, m.angle_px.max, m.g_px.max},
            m.fate_errors,
            m.not_finite};
}

// The shader's text in C++ at every pixel.
template <class Trace>
RayFrame core_frame(const Scene& scene, CoreInput input, Trace trace) {
    const int width = scene.camera.width, height = scene.camera.height;
    input.cubic = hard_cubic(scene);
    RayFrame frame{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            frame.pixels.push_back(trace(input, x + 0.5 - 0.5 * width, 0.5 * height - (y + 0.5)));
    return frame;
}

Status measure_on_cpu(std::vector<Row>& rows) {
    FrameTables tables;
    Progress progress("hard cases, C++", static_cast<long long>(rows.size()));
    for (Row& row : rows) {
        const Scene& scene = row.hard->scene;
        auto exact = reference::trace_frame(scene);
        if (!exact) return exact.error();
        row.exact = std::move(*exact);
        if (Status ready = tables.update(scene); !ready) return ready;
        const CoreInput input = tables.core_input();
        row.witness[0] = measured(row, core_frame(scene, input, trace_core64), kDoubleBit);
        row.witness[1] = measured(row, core_frame(scene, input, trace_core32), kFloatBit);
        progress.advance();
    }
    return Done{};
}

Status measure_on_gpu(std::vector<Row>& rows, std::size_t at) {
    auto session = open_session(kWitnesses[at]);
    if (!session) {
        fmt::print(stderr, "nullscope: {}: column left empty\n", session.error().message);
        return Done{};
    }
    Progress progress(fmt::format("hard cases, {}", kWitnesses[at]), static_cast<long long>(rows.size()));
    for (Row& row : rows) {
        session->renderer->set_method(Method{.cubic = hard_cubic(row.hard->scene)});
        if (Status ready = session->renderer->prepare(row.hard->scene); !ready) return ready;
        row.witness[at] = measured(row, session->renderer->ray_data(), kFloatBit);
        progress.advance();
    }
    return Done{};
}

// Lines "name TAB error TAB bound", px, as proof_tests writes them.
Status read_reference(const std::string& path, std::vector<Row>& rows) {
    std::ifstream file(path);
    if (!file) return bad_input(fmt::format("{}: cannot be read", path));
    std::map<std::string, ReferenceRow> found;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
        if (first == std::string::npos || second == std::string::npos)
            return bad_input(
                fmt::format("{}:{}: expected a name, an error and a bound, tabs between them", path, number));
        ReferenceRow row;
        std::istringstream numbers(line.substr(first + 1));
        if (!(numbers >> row.error_px >> row.bound_px))
            return bad_input(fmt::format("{}:{}: two numbers are expected after the name", path, number));
        found[line.substr(0, first)] = row;
    }
    for (Row& row : rows)
        if (const auto at = found.find(row.hard->name); at != found.end()) row.reference = at->second;
    return Done{};
}

std::string pair_text(double sky, double place, bool disc) {
    return disc ? fmt::format("{:.1e}, {:.1e}", sky, place) : fmt::format("{:.1e}", sky);
}

std::string cell(const std::optional<Measured>& m, bool disc) {
    if (!m) return "-";
    const std::string text = pair_text(m->error.sky, m->error.place, disc);
    return m->over_bound() <= 1 ? text : fmt::format("**{}, {:.2g} x**", text, m->over_bound());
}

void print_table(const std::vector<Row>& rows) {
    fmt::print(
        "| case | why it is hard | bound px | reference | core64 | core32 | EGL | OSMesa "
        "|\n|---|---|---|---|---|---|---|---|\n");
    for (const Row& row : rows) {
        const bool disc = row.hard->scene.disc.has_value();
        const HardBound bound = hard_bound(row.hard->scene, row.exact);
        fmt::print(
            "| {} | {} | {} | {} |", row.hard->name, row.hard->why, pair_text(bound.sky, bound.place, disc),
            row.reference ? fmt::format("{:.0e} of {:.0e}", row.reference->error_px, row.reference->bound_px) : "-");
        for (const auto& m : row.witness) fmt::print(" {} |", cell(m, disc));
        fmt::print("\n");
    }
    const auto within = std::count_if(rows.begin(), rows.end(), [](const Row& r) { return r.within(); });
    fmt::print("\n{} of {} rows within their bounds; largest error over bound:", within, rows.size());
    for (std::size_t i = 0; i < kWitnesses.size(); ++i) {
        double most = -1;
        for (const Row& row : rows)
            if (row.witness[i]) most = std::max(most, row.witness[i]->over_bound());
        if (most >= 0) fmt::print(" {} {:.2f}", kWitnesses[i], most);
    }
    fmt::print("\n");
}

std::string json_of(const HardBound& b) {
    return JsonObject().add("sky_px", b.sky).add("place_px", b.place).add("swept_px", b.swept).add("g_px", b.g).text();
}

JsonObject json_of(const Row& row) {
    JsonObject o;
    o.add("case", row.hard->name).add("why", row.hard->why);
    if (row.reference)
        o.raw("reference",
              JsonObject().add("sky_px", row.reference->error_px).add("bound_px", row.reference->bound_px).text());
    for (std::size_t i = 0; i < kWitnesses.size(); ++i) {
        if (!row.witness[i]) continue;
        const Measured& m = *row.witness[i];
        o.raw(kWitnesses[i], JsonObject()
                                 .raw("bound", json_of(m.bound))
                                 .raw("error", json_of(m.error))
                                 .add("fate_errors", m.fate_errors)
                                 .add("not_finite", m.not_finite)
                                 .add("error_over_bound", m.over_bound())
                                 .text());
    }
    o.raw("within", row.within() ? "true" : "false");
    return o;
}

int run(const Options& options) {
    std::vector<Row> rows;
    for (const HardCase& hard : hard_cases()) {
        if (hard.name.find(options.only) == std::string::npos) continue;
        rows.emplace_back().hard = &hard;
    }
    if (rows.empty()) return report(bad_input(fmt::format("no hard case has \"{}\" in its name", options.only)));
    if (!options.reference.empty())
        if (Status read = read_reference(options.reference, rows); !read) return report(read.error());
    if (Status done = measure_on_cpu(rows); !done) return report(done.error());
    for (const std::size_t at : {std::size_t{2}, std::size_t{3}})
        if (Status done = measure_on_gpu(rows, at); !done) return report(done.error());
    print_table(rows);
    if (!options.json.empty()) {
        std::vector<JsonObject> objects;
        objects.reserve(rows.size());
        for (const Row& row : rows) objects.push_back(json_of(row));
        if (Status written = write_text_atomically(options.json, json_list(objects)); !written)
            return report(written.error());
    }
    return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.within(); }) ? 0 : 1;
}

}  // namespace

void add_bench_hard(Command& bench) {
    auto options = std::make_shared<Options>();
    Command& command = bench.add_command("hard",
                                         "The hard cases: what each may err by and what every witness measures; status "
                                         "1 if one is outside of its bound");
    command.add_option("--json", &options->json, "Write the rows to this file");
    command.add_option(
        "--reference", &options->reference,
        "Fill the column of the reference from this file (proof_tests writes it: reports/hard-reference.tsv)");
    command.add_option("--only", &options->only, "Only cases with this text in their name");
    command.on_run([options] { return run(*options); });
}

}  // namespace nullscope::cli
