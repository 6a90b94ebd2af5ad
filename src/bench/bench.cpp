#include "bench/bench.h"

#include <algorithm>
#include <ctime>

#include "base/stopwatch.h"
#include "command/arguments.h"

namespace nullscope::cli {
void add_bench(Command& parent) {
    Command& bench = parent.add_command("bench", "Measure time and accuracy");
    for (const auto add : {add_bench_frames, add_bench_accuracy, add_bench_hard, add_bench_soak, add_bench_metrics,
                           add_bench_pictures, add_bench_spin, add_bench_rays, add_bench_arithmetic})
        add(bench);
}

void size_option(Command& command, BenchOptions& options) {
    text_option(command, "--size", options.size, "Frame size, WIDTHxHEIGHT");
}
void json_option(Command& command, BenchOptions& options) {
    command.add_option("--json", &options.json, "Write the rows to this file");
}

void draw_options(Command& command, BenchOptions& options, int least_frames) {
    size_option(command, options);
    context_option(command, options.context);
    number_option(command, "--frames", options.frames, least_frames, 10000, "Frames of each kind");
}

Status Bench::prepare(const Scene& scene, const Scene& other_scene) const {
    if (Status ready = renderer().prepare(scene); !ready) return ready;
    return other->prepare(other_scene);
}

Result<Bench> open_bench(const ContextChoice& context, int width, int height) {
    TRY(session, open_session(context));
    return Bench{std::move(*session), std::make_unique<Renderer>(), gl::make_target(width, height, gl::Format::kRgba8)};
}

Result<Bench> open_bench(const BenchOptions& options) {
    TRY(size, parse_size(options.size));
    return open_bench(options.context, size->width, size->height);
}

void time_one(Samples& samples, const std::function<void()>& draw) {
    gl::finish();
    const std::clock_t core = std::clock();  // of all threads
    const Stopwatch watch;
    const gl::Query begin = gl::timestamp();
    draw();
    const gl::Query end = gl::timestamp();
    gl::finish();
    samples.wall_ms.push_back(watch.ms());
    samples.core_s.push_back(static_cast<double>(std::clock() - core) / CLOCKS_PER_SEC);
    samples.gpu_ms.push_back(gl::milliseconds(begin, end));
}

std::vector<Samples> Bench::time_in_turn(int frames, const Draws& more,
                                         const std::function<void()>& after_round) const {
    Draws draws{[this] { draw(renderer()); }, [this] { draw(*other); }};
    draws.insert(draws.end(), more.begin(), more.end());
    for (const auto& draw_it : draws) draw_it();
    std::vector<Samples> samples(draws.size());
    for (int i = 0; i < frames; ++i, after_round())
        for (std::size_t k = 0; k < draws.size(); ++k) time_one(samples[k], draws[k]);
    return samples;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

}  // namespace nullscope::cli
