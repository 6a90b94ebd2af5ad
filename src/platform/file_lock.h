// Locks on parts of a file, by which processes that share a folder agree on who does what. The system frees them when the process ends,
// however it ends.
#pragma once
#include <string>
#include <system_error>

namespace nullscope::platform {

// A file that is open for its locks. Two of them in one process are as strange to each other as those of two processes.
class LockFile {
public:
    LockFile() = default;
    LockFile(LockFile&& other) noexcept;
    LockFile& operator=(LockFile&& other) noexcept;
    LockFile(const LockFile&) = delete;
    LockFile& operator=(const LockFile&) = delete;
    ~LockFile() { close(); }

    // kLeft: programs that this one starts hold the locks too, until they end (POSIX alone), and an empty file is made where there is none.
    enum class Kept { kHere, kLeft };
    std::error_code open(const std::string& file, Kept kept);
    bool is_open() const;
    void close();             // frees the locks
    void forget();            // it stays open, with its locks, until the process ends
    void remove_and_close();  // the file too, if it still has its name
    bool has_its_name()
        const;  // no other file, and not none, has taken it: a lock on a file without a name holds nothing

    enum class Kind { kNone, kShared, kExclusive };
    // Of one byte by its number, from 0 on; it need not exist. On POSIX systems one kind is turned into another in one step. Errors: another
    // holds a lock that this one cannot be beside (resource_unavailable_try_again; `wait`: waits for it instead), what the system says.
    std::error_code set(Kind kind, long long byte, bool wait = false) const;

    // Whether there is such a file, not older than this one.
    bool is_as_old_as(const std::string& file) const;

private:
    std::string name_;
    long long handle_ = -1;  // the system's
};

}  // namespace nullscope::platform
