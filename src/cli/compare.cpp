#include "cli/command.h"
namespace nullscope::cli {
Command add_compare(CLI::App& parent) { return {parent.add_subcommand("compare"), [] { return 1; }}; }
}
