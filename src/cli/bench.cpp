#include "cli/bench.h"

namespace nullscope::cli {

Command add_bench(CLI::App& parent) {
    CLI::App* bench = parent.add_subcommand("bench", "Measure what things cost and how exact they are");
    bench->require_subcommand(1);
    const std::vector<Command> commands = {add_bench_frames(*bench), add_bench_accuracy(*bench), add_bench_hard(*bench),
                                          add_bench_soak(*bench), add_bench_metrics(*bench), add_bench_spin(*bench)};
    return {bench, [commands] {
                for (const Command& command : commands)
                    if (command.app->parsed()) return command.run();
                return 0;
            }};
}

}  // namespace nullscope::cli
