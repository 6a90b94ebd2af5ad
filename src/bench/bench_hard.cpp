// nullscope bench hard: the list of hard cases, what each may err by, and what every implementation measures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/csv.h"
#include "base/progress.h"
#include "base/text.h"
#include "bench/bench.h"
#include "command/exact_trace.h"
#include "command/json.h"
#include "compare/hard_cases.h"
#include "compare/ray_metrics.h"
#include "context/context.h"
#include "gl/compute.h"
#include "reference/reference.h"

namespace nullscope::cli {
namespace {

struct HardBench {
    std::string json, reference, only;
};

constexpr double kRefineHardAbove_px = 1e-5;  // below every bound of the list but those of frames of a pixel or two
struct Implementation {
    std::string name, heading;
    std::string context;   // empty: the shader's text in C++
    bool compute = false;  // by compute shaders, where the driver has them
};

// Every kind of context that this system has, and compute shaders in the first.
const std::vector<Implementation>& implementations() {
    static const std::vector<Implementation> all = [] {
        const std::map<std::string, std::string> written = {{"egl", "EGL"}, {"osmesa", "OSMesa"}, {"wgl", "WGL"}};
        std::vector<Implementation> found = {{"core64", "core64", {}}, {"core32", "core32", {}}};
        const std::vector<std::string> kinds = context_kinds();
        for (const std::string& kind : kinds) found.push_back({kind, written.at(kind), kind});
        found.push_back({"compute", "compute", kinds.front(), true});
        return found;
    }();
    return all;
}

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

struct HardRow {
    const HardCase* hard = nullptr;
    RayFrame exact;
    std::optional<ReferenceRow> reference;
    std::vector<std::optional<Measured>> by = std::vector<std::optional<Measured>>(implementations().size());
    bool within() const {
        if (reference && !(reference->error_px <= reference->bound_px)) return false;
        return std::ranges::all_of(by, [](const auto& m) { return !m || m->over_bound() <= 1; });
    }
};

Measured measured(const HardRow& row, const RayFrame& tested, double bit) {
    const Scene& scene = row.hard->scene;
    const RayMeasures m = measure_rays(tested, scene.camera, exact_trace(scene), 1, kRefineHardAbove_px);
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

Status measure_on_cpu(std::vector<HardRow>& rows) {
    FrameTables tables;
    Progress progress("hard cases, C++", static_cast<long long>(rows.size()));
    for (HardRow& row : rows) {
        const Scene& scene = row.hard->scene;
        TRY(exact, reference::trace_frame(scene));
        row.exact = std::move(*exact);
        TRY(ready, tables.update(scene));
        const CoreInput input = tables.core_input();
        row.by[0] = measured(row, core_frame(scene, input, trace_core64), kDoubleBit);
        row.by[1] = measured(row, core_frame(scene, input, trace_core32), kFloatBit);
        progress.advance();
    }
    return Done{};
}

Status measure_on_gpu(std::vector<HardRow>& rows, std::size_t at) {
    const Implementation& by = implementations()[at];
    auto session = open_session(by.context);
    if (!session || (by.compute && !gl::computes())) {
        fmt::print(stderr, "nullscope: {}: column {} left empty\n",
                   session ? "this OpenGL is older than 4.3" : session.error().message(), by.heading);
        return Done{};
    }
    session->renderer->compute(by.compute);
    Progress progress(fmt::format("hard cases, {}", by.heading), static_cast<long long>(rows.size()));
    for (HardRow& row : rows) {
        session->renderer->set_method(Method{.cubic = hard_cubic(row.hard->scene)});
        TRY(ready, session->renderer->prepare(row.hard->scene));
        row.by[at] = measured(row, session->renderer->ray_data(), kFloatBit);
        progress.advance();
    }
    return Done{};
}

// Lines "name TAB error TAB bound", px, as proof_tests writes them.
Status read_reference(const std::string& path, std::vector<HardRow>& rows) {
    if (path.empty()) return Done{};
    TRY(text, read_text(path));
    std::map<std::string, ReferenceRow> found;
    for (CsvLines csv(*text); csv.next();) {
        const auto cells = csv_fields(csv.line, '\t').value_or(std::vector<std::string>());
        const auto error = cells.size() == 3 ? parse_number(cells[1]) : std::nullopt,
                   bound = cells.size() == 3 ? parse_number(cells[2]) : std::nullopt;
        if (!error || !bound)
            return bad_input(
                fmt::format("{}:{}: expected a name, an error and a bound in px, tabs between them", path, csv.number));
        found[cells[0]] = {*error, *bound};
    }
    for (HardRow& row : rows)
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

void print_hard(const std::vector<HardRow>& rows) {
    std::string headings = "| case | why it is hard | bound px | reference |", line = "\n|---|---|---|---|";
    for (const Implementation& by : implementations()) headings += fmt::format(" {} |", by.heading), line += "---|";
    fmt::print("{}{}\n", headings, line);
    for (const HardRow& row : rows) {
        const bool disc = row.hard->scene.disc.has_value();
        const HardBound bound = hard_bound(row.hard->scene, row.exact);
        fmt::print(
            "| {} | {} | {} | {} |", row.hard->name, row.hard->why, pair_text(bound.sky, bound.place, disc),
            row.reference ? fmt::format("{:.0e} of {:.0e}", row.reference->error_px, row.reference->bound_px) : "-");
        for (const auto& m : row.by) fmt::print(" {} |", cell(m, disc));
        fmt::print("\n");
    }
    const auto within = std::ranges::count_if(rows, &HardRow::within);
    fmt::print("\n{} of {} rows within their bounds; largest error over bound:", within, rows.size());
    for (std::size_t i = 0; i < implementations().size(); ++i) {
        double most = -1;
        for (const HardRow& row : rows)
            if (row.by[i]) most = std::max(most, row.by[i]->over_bound());
        if (most >= 0) fmt::print(" {} {:.2f}", implementations()[i].heading, most);
    }
    fmt::print("\n");
}

Json hard_json(const HardBound& b) {
    return {{"sky_px", b.sky}, {"place_px", b.place}, {"swept_px", b.swept}, {"g_px", b.g}};
}

Json hard_json(const HardRow& row) {
    Json o{{"case", row.hard->name}, {"why", row.hard->why}};
    if (row.reference) o["reference"] = {{"sky_px", row.reference->error_px}, {"bound_px", row.reference->bound_px}};
    for (std::size_t i = 0; i < implementations().size(); ++i) {
        if (!row.by[i]) continue;
        const Measured& m = *row.by[i];
        o[implementations()[i].name] = {{"bound", hard_json(m.bound)},
                                        {"error", hard_json(m.error)},
                                        {"fate_errors", m.fate_errors},
                                        {"not_finite", m.not_finite},
                                        {"error_over_bound", m.over_bound()}};
    }
    o["within"] = row.within();
    return o;
}

Result<int> run_hard(const HardBench& options) {
    std::vector<HardRow> rows;
    for (const HardCase& hard : hard_cases())
        if (hard.name.find(options.only) != std::string::npos) rows.emplace_back().hard = &hard;
    if (rows.empty()) return bad_input(fmt::format("no hard case has \"{}\" in its name", options.only));
    TRY(read, read_reference(options.reference, rows));
    TRY(on_cpu, measure_on_cpu(rows));
    for (std::size_t at = 0; at < implementations().size(); ++at) {
        if (implementations()[at].context.empty()) continue;
        TRY(on_gpu, measure_on_gpu(rows, at));
    }
    print_hard(rows);
    Json objects = Json::array();
    for (const HardRow& row : rows) objects.push_back(hard_json(row));
    TRY(written, write_json(options.json, objects));
    return std::ranges::all_of(rows, &HardRow::within) ? 0 : 1;
}

}  // namespace

void add_bench_hard(Command& bench) {
    auto [command, options] = add_command<HardBench>(
        bench, "hard", "Error of every implementation in each hard case, with its bound; status 1 if one exceeds it",
        run_hard);
    command.add_option("--json", &options.json, "Write the rows to this file");
    command.add_option("--reference", &options.reference,
                       "File with the errors of the reference, written by proof_tests (reports/hard-reference.tsv)");
    command.add_option("--only", &options.only, "Only cases whose name contains this text");
}

}  // namespace nullscope::cli
