// nullscope manual: man pages and the completion of a shell, as packages install them.
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "base/manual.h"
#include "cli/command.h"

namespace nullscope::cli {
namespace {

struct ManualOptions {
    std::string folder;
};

Status write_manual(const Command& program, const std::filesystem::path& folder) {
    TRY(written, nullscope::write_manual(program, "nullscope scenes | cut -d\" \" -f1", folder));
    fmt::print("{0}: man pages (man -l {0}/man1/nullscope.1), and for bash: source {0}/nullscope.bash\n",
               folder.string());
    return Done{};
}

}  // namespace

void add_manual(Command& parent) {
    auto [command, options] = add_command<ManualOptions>(
        parent, "manual", "Write man pages of all commands, and a bash completion script, into a folder",
        [&parent](const ManualOptions& given) { return write_manual(parent, given.folder); });
    required_option(command, "folder", options.folder, "Folder to write to");
}

}  // namespace nullscope::cli
