#include "studio/method_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/assets.h"

namespace nullscope::viewer {

MethodTable shipped_methods() {
    auto measured = load_frontier(assets_directory() / "frontier.csv");
    return measured ? MethodTable{std::move(*measured), ""} : MethodTable{{}, measured.error().message()};
}

const MeasuredMethod* row_of(const std::vector<MeasuredMethod>& measured, const Method& method,
                             const std::string& metric) {
    const auto found = std::ranges::find_if(
        measured, [&](const MeasuredMethod& row) { return row.metric == metric && row.method == method; });
    return found == measured.end() ? nullptr : &*found;
}

MethodChoice method_choice(const std::vector<MeasuredMethod>& measured, const MethodWish& wish, const Scene& scene) {
    const std::string& metric = scene.spacetime.metric;
    if (!wish.automatic) {
        const MeasuredMethod* row = row_of(measured, wish.method, metric);
        if (row == nullptr)
            return {wish.method, true, fmt::format("{}: chosen by hand; not measured here", method_name(wish.method))};
        const double error = error_in_frame(*row, scene);
        const bool kept = error <= wish.max_error_px;
        return {wish.method, kept,
                fmt::format("{}: chosen by hand; at most {:.2g} px on the sky here{}, {:.2f} times flat space",
                            method_name(wish.method), error,
                            kept ? "" : fmt::format(", more than {:.2g} px", wish.max_error_px), row->floor_ratio)};
    }
    const auto choice = choose_method(measured, scene, wish.max_error_px);
    if (choice && (choice->error_px == 0.0 || choice->says))  // nothing to choose from
        return {choice->method, true, choice->reason};
    if (choice) {
        const MeasuredMethod* row = row_of(measured, choice->method, metric);
        return {
            choice->method, true,
            fmt::format(
                "{}, the fastest method below {:.2g} px: at most {:.2g} px on the sky here, {:.2f} times flat space",
                method_name(choice->method), wish.max_error_px, choice->error_px, row->floor_ratio)};
    }
    const MeasuredMethod* best = most_exact(measured, metric);
    if (best == nullptr) {  // about a rotating hole, next to its ring
        const Choice only = default_method(measured, scene);
        return {only.method, false, only.reason};
    }
    return {best->method, false,
            fmt::format("No method is known to stay below {:.2g} px in this frame. The lowest error, {:.2g} px, is "
                        "that of {}, which is used.",
                        wish.max_error_px, error_in_frame(*best, scene), method_name(best->method))};
}

}  // namespace nullscope::viewer
