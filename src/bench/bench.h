// What the benches share: options, a context with renderers and a target, timing in turn, medians; and the subcommands.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "command/options.h"
#include "command/session.h"
#include "gl/gl.h"
#include "plan/effects.h"

namespace nullscope::cli {

void add_bench(Command& parent);  // with all of the following
void add_bench_frames(Command& bench);
void add_bench_accuracy(Command& bench);
void add_bench_hard(Command& bench);
void add_bench_soak(Command& bench);
void add_bench_metrics(Command& bench);
void add_bench_pictures(Command& bench);
void add_bench_spin(Command& bench);
void add_bench_rays(Command& bench);
void add_bench_arithmetic(Command& bench);

struct BenchOptions {
    std::vector<std::string> scenes;
    std::string size = "1280x720", json;
    ContextChoice context;
    int frames = 21;
};
void size_option(Command& command, BenchOptions& options);
void json_option(Command& command, BenchOptions& options);
void draw_options(Command& command, BenchOptions& options, int least_frames);  // size, context and frames

struct Samples {
    std::vector<double> wall_ms, core_s, gpu_ms;
};
using Draws = std::vector<std::function<void()>>;
// Wall, processor and GPU time of one draw.
void time_one(Samples& samples, const std::function<void()>& draw);

// Two renderers, of what is measured and of what it is measured against, on one context.
struct Bench {
    Session session;
    std::unique_ptr<Renderer> other;
    gl::Target target;

    Renderer& renderer() const { return *session.renderer; }
    void draw(Renderer& by) const { by.draw(target.framebuffer.id(), target.width, target.height, Output::kDisplay); }
    Status prepare(const Scene& scene, const Scene& other_scene) const;
    std::string driver() const { return renderer().info().renderer; }
    // What the two renderers have prepared, and `more`: each is drawn once untimed, which compiles, and then in turn
    // (A B A B ...), so that a noisy machine does not decide. after_round is called behind every turn.
    std::vector<Samples> time_in_turn(
        int frames, const Draws& more = {}, const std::function<void()>& after_round = [] {}) const;
};
Result<Bench> open_bench(const ContextChoice& context, int width, int height);
Result<Bench> open_bench(const BenchOptions& options);

double median(std::vector<double> values);

// Core-seconds of a frame with an effect, without it, and of the empty scene's.
struct EffectCost {
    Effect effect;
    double with_s, without_s, floor_s;
    double refined = 0.0;  // of kRefine: part of the pixels that it draws again
    double over_floor() const { return (with_s - without_s) / floor_s; }
};

// Of each effect of a scene that can go alone, at the scene's size. Errors: no context, what prepare() says.
Result<std::vector<EffectCost>> effect_costs(const Scene& scene, const ContextChoice& context, int frames);

// nullscope bench frames --effects: prints one line an effect and writes the rows. Every effect is drawn in turn with
// the scene without it. Errors: no context, a file that cannot be written.
Status bench_effects(const BenchOptions& options);

// The work-precision diagram of nullscope bench accuracy: screen error against cost, both logarithmic, as SVG.
struct PlotPoint {
    std::string label;
    Method method;
    double cost, error;  // core-seconds; px of a 4K frame, maximum
    bool on_frontier, is_default;
};

std::string accuracy_svg(const std::vector<PlotPoint>& points, double floor_cost, const std::string& subtitle);

}  // namespace nullscope::cli
