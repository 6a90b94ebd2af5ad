// Open file description locks, which NFS passes on to its server.
#include "platform/file_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace nullscope::platform {
namespace {

std::error_code code_of(int number) { return {number, std::generic_category()}; }

short type_of(LockFile::Kind kind) {
    return kind == LockFile::Kind::kNone ? F_UNLCK : kind == LockFile::Kind::kShared ? F_RDLCK : F_WRLCK;
}

}  // namespace

LockFile::LockFile(LockFile&& other) noexcept
    : name_(std::move(other.name_)), handle_(std::exchange(other.handle_, -1)) {}

LockFile& LockFile::operator=(LockFile&& other) noexcept {
    std::swap(name_, other.name_), std::swap(handle_, other.handle_);
    return *this;
}

std::error_code LockFile::open(const std::string& file, Kept kept) {
    close();
    handle_ =
        kept == Kept::kLeft ? ::open(file.c_str(), O_RDWR | O_CREAT, 0666) : ::open(file.c_str(), O_RDWR | O_CLOEXEC);
    name_ = file;
    return handle_ < 0 ? code_of(errno) : std::error_code();
}

bool LockFile::is_open() const { return handle_ >= 0; }

void LockFile::close() {
    if (handle_ >= 0) ::close(static_cast<int>(std::exchange(handle_, -1)));
}

void LockFile::forget() { handle_ = -1; }

void LockFile::remove_and_close() {
    if (has_its_name()) ::unlink(name_.c_str());
    close();
}

bool LockFile::has_its_name() const {
    struct stat open {
    }, named{};
    return ::fstat(static_cast<int>(handle_), &open) == 0 && ::stat(name_.c_str(), &named) == 0 &&
           open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

std::error_code LockFile::set(Kind kind, long long byte, bool wait) const {
    struct flock range {};
    range.l_type = type_of(kind);
    range.l_whence = SEEK_SET;
    range.l_start = byte;
    range.l_len = 1;
    while (::fcntl(static_cast<int>(handle_), wait ? F_OFD_SETLKW : F_OFD_SETLK, &range) != 0)
        if (errno != EINTR) return code_of(errno == EACCES ? EAGAIN : errno);
    return {};
}

bool LockFile::is_as_old_as(const std::string& file) const {
    struct stat other {
    }, own{};
    if (::stat(file.c_str(), &other) != 0 || ::fstat(static_cast<int>(handle_), &own) != 0) return false;
    const auto time = [](const struct stat& s) { return std::pair(s.st_mtim.tv_sec, s.st_mtim.tv_nsec); };
    return time(other) >= time(own);
}

}  // namespace nullscope::platform
