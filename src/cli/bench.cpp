#include "cli/bench.h"

namespace nullscope::cli {

Command add_bench(CLI::App& parent) {
    CLI::App* bench = parent.add_subcommand("bench", "Measure what things cost and how exact they are");
    bench->require_subcommand(1);
    const Command frames = add_bench_frames(*bench), accuracy = add_bench_accuracy(*bench);
    return {bench, [frames, accuracy] { return frames.app->parsed() ? frames.run() : accuracy.run(); }};
}

}  // namespace nullscope::cli
