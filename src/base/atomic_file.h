// A file appears under its name only when it is complete.
#pragma once
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

#include "base/result.h"

namespace nullscope {

// For main(): when the process is asked to end (SIGINT, SIGTERM, SIGHUP), the files that write_atomically has not
// finished are removed first; the process then ends by that signal, as it would have without. A signal that is ignored
// stays so. A file that grows beyond a limit (SIGXFSZ) becomes an error of writing. SIGKILL leaves the unfinished file,
// under its temporary name: ".NAME.PROCESS-NUMBER.tmp.EXTENSION".
void clean_up_on_signals();

// Calls write(temporary path beside target); on success renames it to target, otherwise removes it.
Status write_atomically(const std::filesystem::path& target,
                        const std::function<Status(const std::filesystem::path&)>& write);

// The same into a stream. Errors: what the system says of it, before what `write` returns.
Status write_stream_atomically(const std::filesystem::path& target, const std::function<Status(std::ostream&)>& write);

// The same for text.
Status write_text_atomically(const std::filesystem::path& target, std::string_view text);

// The whole file; error if it cannot be read or is larger than max_bytes.
Result<std::string> read_text(const std::filesystem::path& path, std::size_t max_bytes = 64u << 20);

// Size and FNV-1a hash of a file's bytes: what depends on what is in a file, not on where it lies.
std::string contents_of(const std::filesystem::path& file);

}  // namespace nullscope
