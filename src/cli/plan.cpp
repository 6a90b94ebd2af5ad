#include "cli/command.h"
namespace nullscope::cli {
Command add_plan(CLI::App& parent) { return {parent.add_subcommand("plan"), [] { return 1; }}; }
}
