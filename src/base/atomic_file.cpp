#include "base/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <vector>

#include "base/text.h"
#include "platform/endings.h"
#include "platform/process.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kReadChunk = 1u << 20;  // bytes; also bounds what a pipe can make us hold beyond max_bytes

// A name in the same directory (so that rename stays within one file system), unique to this process and call. The
// extension stays last, because some writers choose the format by it.
fs::path temporary_beside(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    const std::string name = fmt::format(".{}.{}-{}.tmp{}", target.stem().string(), platform::process_id(), ++counter,
                                         target.extension().string());
    return target.parent_path() / name;
}

// The names that a signal handler must remove: it may read no string that another thread could be changing. A slot
// holds a pointer to a TemporaryFile's own name, or null.
std::array<std::atomic<const char*>, 16> unfinished{};

void remove_unfinished() {
    for (const auto& name : unfinished)
        if (const char* path = name.load()) platform::remove_file_at_end(path);
}

// Removes the file on scope exit, also when the writer throws, and when a signal ends the process.
class TemporaryFile {
public:
    explicit TemporaryFile(fs::path path) : path_(std::move(path)), name_(path_.string()) {
        for (auto& slot : unfinished) {
            const char* none = nullptr;
            if (!slot.compare_exchange_strong(none, name_.c_str())) continue;
            slot_ = &slot;
            break;
        }
    }
    ~TemporaryFile() {
        std::error_code ignored;
        fs::remove(path_, ignored);
        if (slot_ != nullptr) *slot_ = nullptr;
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const fs::path& path() const { return path_; }

private:
    const fs::path path_;
    const std::string name_;
    std::atomic<const char*>* slot_ = nullptr;  // null if all are taken: then a signal may leave the file
};

// Renaming over a device or a pipe (/dev/null, /dev/stdout) would destroy it: these are written in place.
bool is_special(const fs::path& path) {
    std::error_code ignored;
    return fs::is_character_file(path, ignored) || fs::is_fifo(path, ignored) || fs::is_block_file(path, ignored);
}

}  // namespace

void clean_up_on_signals() {
    static_assert(std::atomic<const char*>::is_always_lock_free, "the handler may not wait");
    platform::make_size_limits_errors();
    platform::before_ending(remove_unfinished);
}

Status write_atomically(const fs::path& target, const std::function<Status(const fs::path&)>& write) {
    if (!target.has_filename()) return bad_input(fmt::format("cannot write '{}': not a file name", target.string()));
    if (is_special(target)) return write(target);
    std::error_code error;
    const fs::path real = fs::is_symlink(target, error) ? fs::weakly_canonical(target, error) : target;
    if (error && error != std::errc::no_such_file_or_directory)
        return failed(fmt::format("cannot write '{}': {}", target.string(), error.message()));
    if (fs::is_directory(real, error))
        return failed(fmt::format("cannot write '{}': it is a directory", real.string()));
    const TemporaryFile temporary(temporary_beside(real));
    Status written = write(temporary.path());
    if (!written) return written;
    fs::rename(temporary.path(), real, error);
    if (error) return failed(fmt::format("cannot write '{}': {}", target.string(), error.message()));
    return Done{};
}

Status write_stream_atomically(const fs::path& target, const std::function<Status(std::ostream&)>& write) {
    return write_atomically(target, [&](const fs::path& path) -> Status {
        errno = 0;
        std::ofstream file(path, std::ios::binary);
        Status written = file ? write(file) : Done{};
        if (file) file.close();
        if (file) return written;
        const std::error_code reason(errno, std::generic_category());
        return failed(fmt::format("cannot write '{}': {}", target.string(), errno ? reason.message() : "write error"));
    });
}

Status write_text_atomically(const fs::path& target, std::string_view text) {
    return write_stream_atomically(target, [&](std::ostream& file) -> Status {
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        return Done{};
    });
}

Result<std::string> read_text(const fs::path& path, std::size_t max_bytes) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) return bad_input(fmt::format("cannot read '{}': no such file", path.string()));
    if (fs::is_directory(status)) return bad_input(fmt::format("cannot read '{}': it is a directory", path.string()));
    const Error too_large = bad_input(fmt::format("cannot read '{}': larger than {} bytes", path.string(), max_bytes));
    const std::uintmax_t announced = fs::is_regular_file(status) ? fs::file_size(path, error) : 0;
    if (!error && announced > max_bytes) return too_large;
    std::ifstream file(path, std::ios::binary);
    if (!file) return bad_input(fmt::format("cannot read '{}': it cannot be opened", path.string()));
    std::string text;
    if (!error) text.reserve(static_cast<std::size_t>(announced));
    while (file) {
        const std::size_t before = text.size();
        text.resize(before + kReadChunk);
        file.read(text.data() + before, static_cast<std::streamsize>(kReadChunk));
        text.resize(before + static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
        if (text.size() > max_bytes) return too_large;
    }
    if (file.bad()) return bad_input(fmt::format("cannot read '{}': read error", path.string()));
    return text;
}

std::string contents_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return "unreadable";
    std::uint64_t hash = fnv1a(""), size = 0;
    std::vector<char> bytes(1u << 20);
    while (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())), in.gcount() > 0) {
        hash = fnv1a({bytes.data(), static_cast<std::size_t>(in.gcount())}, hash);
        size += static_cast<std::uint64_t>(in.gcount());
    }
    return fmt::format("{} bytes, {:016x}", size, hash);
}

}  // namespace nullscope
