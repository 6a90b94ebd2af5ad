#include "cli/bench.h"

namespace nullscope::cli {

void add_bench(Command& parent) {
    Command& bench = parent.add_command("bench", "Measure what things cost and how exact they are");
    for (const auto add :
         {add_bench_frames, add_bench_accuracy, add_bench_hard, add_bench_soak, add_bench_metrics, add_bench_spin})
        add(bench);
}

}  // namespace nullscope::cli
