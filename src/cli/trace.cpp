#include "cli/command.h"
namespace nullscope::cli {
Command add_trace(CLI::App& parent) { return {parent.add_subcommand("trace"), [] { return 1; }}; }
}
