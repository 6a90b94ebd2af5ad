#include "shaderlib/frontier.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/atomic_file.h"
#include "base/csv.h"
#include "base/text.h"
#include "observer/spin_ring.h"
#include "plan/effects.h"
#include "scene/projection.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

// What one pixel of the bench's 4K frame spans in the middle: its errors in px are at least forward errors over this.
constexpr double kBenchPixel_rad = 2.0 / 3840.0;
// A bound above this is not told: scaling takes the sky to move by no more than the pixel's own angle from one pixel to
// the next. Deep zooms look at a hole that moves it by millions of that, and err by as much less.
constexpr double kTellsNothing_px = 1.0;

// Of metrics that were not measured: a view next to the ring of a rotating hole, whose bounds are not of the bench (observer/spin_ring.h).
std::optional<Choice> next_to_ring(const Scene& scene) {
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    if (!spacetime || !(*spacetime)->rotates() || !effect_set(required_effects(scene)).contains(Effect::kSpinRing))
        return std::nullopt;
    if (is_hard_ring(**spacetime, scene.camera.r))
        return Choice{
            Method{}, kRingHardest_px,
            fmt::format("mino: next to the ring of so fast a hole, or so near to it, at most {} px across the "
                        "ring are guaranteed, and not which rays come out",
                        kRingHardest_px),
            true};
    return Choice{Method{}, kRingAcross_px,
                  fmt::format("mino: next to the ring at most {} px across it are guaranteed, and along it {} rad of "
                              "where the light ends",
                              kRingAcross_px, kRingAlong),
                  true};
}

}  // namespace

Result<std::vector<MeasuredMethod>> load_frontier(const std::filesystem::path& path) {
    TRY(text, read_text(path));
    std::vector<MeasuredMethod> methods;
    for (CsvLines csv(*text); csv.next();) {
        if (csv.line.starts_with("metric,")) continue;
        auto cells = csv_fields(csv.line).value_or(std::vector<std::string>());
        cells.resize(cells.size() == 5 ? 5 : 0);
        std::array<std::optional<double>, 3> numbers;
        for (std::size_t i = 0; i < numbers.size() && !cells.empty(); ++i) numbers[i] = parse_number(cells[i + 2]);
        const auto method = parse_method(cells.empty() ? "" : cells[1]);
        if (!numbers[0] || !numbers[1] || !numbers[2] || !method)
            return bad_input(fmt::format("{}:{}: expected metric,method,error_px,floor_ratio,disc_error_px",
                                         path.string(), csv.number));
        methods.push_back({cells[0], *method, *numbers[0], *numbers[1], *numbers[2]});
    }
    return methods;
}

std::string frontier_text(const std::vector<MeasuredMethod>& methods) {
    std::string out =
        "# Largest screen error on the sky and on a disc (px of a 4K frame over 90 degrees) and cost (over flat space) "
        "of each method:\n"
        "# made by nullscope bench accuracy --frontier, read by --method auto "
        "--max-error.\nmetric,method,error_px,floor_ratio,disc_error_px\n";
    for (const MeasuredMethod& m : methods)
        out += fmt::format("{},{},{:.4g},{:.4g},{:.4g}\n", m.metric, method_name(m.method), m.error_px, m.floor_ratio,
                           m.disc_error_px);
    return out;
}

double error_in_frame(const MeasuredMethod& method, const Scene& scene) {
    const double worst = scene.disc ? std::max(method.error_px, method.disc_error_px) : method.error_px;
    return worst * kBenchPixel_rad / smallest_pixel_angle(scene.camera);
}

bool is_dominated(const MeasuredMethod& method, const std::vector<MeasuredMethod>& methods) {
    return std::any_of(methods.begin(), methods.end(), [&](const MeasuredMethod& other) {
        return other.metric == method.metric && other.floor_ratio <= method.floor_ratio &&
               other.error_px <= method.error_px &&
               (other.floor_ratio < method.floor_ratio || other.error_px < method.error_px);
    });
}

const MeasuredMethod* most_exact(const std::vector<MeasuredMethod>& methods, const std::string& metric) {
    const MeasuredMethod* best = nullptr;
    for (const MeasuredMethod& m : methods)
        if (m.metric == metric && (best == nullptr || m.error_px < best->error_px)) best = &m;
    return best;
}

Result<Choice> choose_method(const std::vector<MeasuredMethod>& methods, const Scene& scene, double max_error_px) {
    const MeasuredMethod* best = nullptr;
    int known = 0;
    for (const MeasuredMethod& m : methods) {
        if (m.metric != scene.spacetime.metric) continue;
        ++known;
        if (error_in_frame(m, scene) <= max_error_px && (best == nullptr || m.floor_ratio < best->floor_ratio))
            best = &m;
    }
    const auto refused = [&](double least_px) {
        return bad_input(fmt::format("--max-error {}: no method is that accurate in this frame", max_error_px),
                         fmt::format("{:.2g} px and more", least_px));
    };
    if (known == 0) {
        if (const auto ring = next_to_ring(scene)) {
            if (ring->error_px <= max_error_px) return *ring;
            return refused(ring->error_px);
        }
        return Choice{
            Method{}, 0.0,
            fmt::format("{}: rays are straight or no method was measured; using the default", scene.spacetime.metric)};
    }
    if (best == nullptr) return refused(error_in_frame(*most_exact(methods, scene.spacetime.metric), scene));
    return Choice{
        best->method, error_in_frame(*best, scene),
        fmt::format(
            "{}: at most {:.2g} px here (limit {}), the fastest of {} measured methods, {:.2f} times flat space",
            method_name(best->method), error_in_frame(*best, scene), max_error_px, known, best->floor_ratio)};
}

Choice default_method(const std::vector<MeasuredMethod>& methods, const Scene& scene) {
    if (auto choice = choose_method(methods, scene, kDefaultMaxError_px)) return *choice;
    const MeasuredMethod* most = most_exact(methods, scene.spacetime.metric);
    if (most == nullptr) return *next_to_ring(scene);  // what choose_method refused
    const MeasuredMethod& best = *most;
    const double error = error_in_frame(best, scene);
    if (error > kTellsNothing_px)
        return {
            best.method, error,
            fmt::format(
                "{}: the most accurate method; its error was not measured for pixels as small as these ({:.2g} rad)",
                method_name(best.method), smallest_pixel_angle(scene.camera))};
    return {best.method, error,
            fmt::format("{}: the most accurate method for pixels as small as these; only at most {:.2g} px is "
                        "guaranteed, not the usual {}",
                        method_name(best.method), error, kDefaultMaxError_px)};
}

}  // namespace nullscope
