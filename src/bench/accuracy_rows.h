// The rows of nullscope bench accuracy: what is measured, of which cameras, and how.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "compare/ray_metrics.h"
#include "spacetime/spacetime.h"

namespace nullscope::cli {

inline constexpr double k4kWidth = 3840;
inline constexpr int kTimeWidth = 1280, kTimeHeight = 720;

struct AccuracyRow {
    std::string name;
    Method method;
    std::vector<float> screen, forward, disc,
        near;  // per pixel; near: of cameras next to the horizon, which are not in screen
    long long fate_errors = 0, near_fate_errors = 0;
    long long steps = 0, rays = 0;  // of methods that count them
    int most_steps = 0;
    std::size_t bytes = 0;
    double build_ms = 0;
    Samples cost, floor;  // a frame's, as if it were drawn whole, and the same in flat space, drawn in turn
    Samples whole;        // the same where all methods are drawn in turn, whole frames of each
    int part = 1;         // of a frame's rows that `cost` drew, 1/part
    Spread screen_px, forward_rad, disc_px, near_px;  // on the sky; places on the disc; on the sky of near cameras
    bool on_frontier = false;

    double core_s() const { return median(cost.core_s); }
    double floor_ratio() const { return core_s() / median(floor.core_s); }
    double mean_steps() const { return static_cast<double>(steps) / static_cast<double>(rays); }
    bool is_default() const { return method == Method{} || method == Method{.kind = MethodKind::kMino}; }
};

// Those that the metric has, the default first.
Result<std::vector<AccuracyRow>> accuracy_rows(const Spacetime& spacetime);

// A camera, and its exact rays, each traced once.
struct ErrorView {
    Scene scene;
    ExactTrace exact;
    bool near;  // next to the horizon
};
std::vector<ErrorView> error_views(const SpacetimeSpec& spec, const Spacetime& spacetime);

// done: called behind each view.
Status measure_errors(Renderer& renderer, const std::vector<ErrorView>& views, AccuracyRow& row,
                      const std::function<void()>& done);

// The bench's other renderer draws the floor, the scene in flat space; both are prepared. A method that takes long draws every `part`th band
// of rows, and so does the floor beside it: what does not depend on rays counts once.
Status measure_cost(const Bench& bench, const Scene& scene, int frames, AccuracyRow& row);

// `whole` of all rows: drawn in turn with each other, whole frames, however long they take.
Status measure_whole_frames(const Bench& bench, const Scene& scene, int frames, std::vector<AccuracyRow>& rows);

}  // namespace nullscope::cli
