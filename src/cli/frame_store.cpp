#include "cli/frame_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <thread>

#include "base/atomic_file.h"

namespace nullscope::cli {
namespace {

namespace fs = std::filesystem;

Error system_error(const std::string& file, int number) {
    return failed(fmt::format("{}: {}", file, std::generic_category().message(number)));
}

// A stamp is removed with a film's folder: a lock on a file that has lost its name holds nothing.
bool is_named(int descriptor, const std::string& file) {
    struct stat open {
    }, named{};
    return ::fstat(descriptor, &open) == 0 && ::stat(file.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
           open.st_dev == named.st_dev;
}

bool is_picture_of_film(const fs::path& file) {
    const std::string stem = file.stem().string();
    return file.extension() == ".png" && stem.size() >= 5 && stem.find_first_not_of("0123456789") == std::string::npos;
}

// Byte 0 of the stamp file stands for the stamp, byte 1 + N for frame N; they need not exist to be locked. A lock of the
// descriptor's own is converted in one step. 0, or the error's number.
int set_lock(int descriptor, short type, long long byte, bool wait = false) {
    struct flock range {};
    range.l_type = type;
    range.l_whence = SEEK_SET;
    range.l_start = byte;
    range.l_len = 1;
    while (::fcntl(descriptor, wait ? F_OFD_SETLKW : F_OFD_SETLK, &range) != 0)
        if (errno != EINTR) return errno == EACCES ? EAGAIN : errno;
    return 0;
}

constexpr long long kStampByte = 0;
long long byte_of(int frame) { return 1LL + frame; }

// How many there were.
Result<int> remove_pictures(const std::string& folder) {
    int count = 0;
    std::error_code error;
    for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error))
        if (is_picture_of_film(i->path()) && fs::remove(i->path(), error)) ++count;
    if (error) return failed(fmt::format("{}: {}", folder, error.message()));
    return count;
}

}  // namespace

FrameStore::FrameStore(FrameNames names, std::string stamp_file, int descriptor)
    : names_(std::move(names)), stamp_file_(std::move(stamp_file)), descriptor_(descriptor) {}

// A stamp stays that other runs draw under, or have drawn under.
FrameStore::~FrameStore() {
    if (descriptor_ < 0) return;
    const bool alone =
        new_ && set_lock(descriptor_, F_WRLCK, kStampByte) == 0 && (!shared_ || names_.on_disk().empty());
    if (alone && is_named(descriptor_, stamp_file_)) ::unlink(stamp_file_.c_str());
    ::close(descriptor_);  // which frees the locks
}

// The descriptor is inherited by ffmpeg on purpose: an encoder that outlives a killed run keeps the pictures locked.
Result<std::unique_ptr<FrameStore>> FrameStore::lock(const FrameNames& names, const std::string& stamp_file,
                                                     const std::string& what, Lock kind, double patience_s) {
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::duration<double>(patience_s);
    for (;;) {
        const int descriptor = ::open(stamp_file.c_str(), O_RDWR | O_CREAT, 0666);
        if (descriptor < 0) return system_error(stamp_file, errno);
        std::unique_ptr<FrameStore> store(new FrameStore(names, stamp_file, descriptor));
        const int error = set_lock(descriptor, kind == Lock::kShared ? F_RDLCK : F_WRLCK, kStampByte);
        if (error == 0 && is_named(descriptor, stamp_file)) return store;
        if (error == 0) continue;
        if (error != EAGAIN)
            return failed(fmt::format("{}: cannot be locked: {}", stamp_file, std::generic_category().message(error)));
        if (Clock::now() >= deadline)
            return failed(fmt::format("{}: another run is drawing it; wait for it to end, or choose another -o", what));
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

// Into the file that is locked: no other takes its name.
Status FrameStore::write(const std::string& stamp) const {
    std::ofstream file(stamp_file_, std::ios::binary | std::ios::trunc);
    if (file << stamp << std::flush) return Done{};
    return system_error(stamp_file_, errno);
}

Result<std::unique_ptr<FrameStore>> FrameStore::open_film(const std::string& folder, const std::string& stamp) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return failed(fmt::format("{}: {}", folder, error.message()));
    auto store = lock(FrameNames::in_folder(folder), folder + "/stamp", folder, Lock::kExclusive, 0);
    if (!store) return store;
    TRY(before, read_text(folder + "/stamp"));
    if (*before == stamp) return store;
    TRY(removed, remove_pictures(folder));
    if (*removed > 0)
        fmt::print(stderr, "{}: starting over, {} pictures of an interrupted run do not match: {}\n", folder, *removed,
                   stamp_difference(*before, stamp));
    (*store)->new_ = before->empty();
    TRY(written, (*store)->write(stamp));
    return store;
}

// before: the stamp that is there.
Status FrameStore::check_no_picture(const std::string& before, const std::string& stamp) const {
    const std::size_t there = names_.on_disk().size();
    if (there == 0) return Done{};
    return bad_input(fmt::format("{} pictures of {} are there that do not match: {}", there, names_.pattern(),
                                 stamp_difference(before, stamp)),
                     "another -o, or to start over: without --resume, or with these removed");
}

// To resume, a run holds the exclusive lock only while it writes the stamp: others that begin at the same time wait.
Result<std::unique_ptr<FrameStore>> FrameStore::open_sequence(const FrameNames& names, const std::string& stamp,
                                                              bool resume) {
    constexpr double kPatience_s = 2;
    const std::string stamp_file = names.stamp_file();
    if (resume) {
        auto store = lock(names, stamp_file, names.pattern(), Lock::kShared, kPatience_s);
        if (!store) return store;
        TRY(now, read_text(stamp_file));
        if (*now == stamp) return store;
        if (!now->empty()) {
            TRY(none, (*store)->check_no_picture(*now, stamp));
        }
    }
    auto store = lock(names, stamp_file, names.pattern(), Lock::kExclusive, resume ? kPatience_s : 0);
    if (!store) return store;
    TRY(before, read_text(stamp_file));
    (*store)->new_ = before->empty();
    if (resume && *before != stamp) {
        TRY(none, (*store)->check_no_picture(*before, stamp));
    }
    if (!resume || *before != stamp) {
        // What is there must be older than the stamp by the file system's clock, which goes in steps of up to 10 ms.
        if (!names.on_disk().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        TRY(written, (*store)->write(stamp));
    }
    if (!resume) return store;
    (*store)->shared_ = true;
    if (const int error = set_lock((*store)->descriptor_, F_RDLCK, kStampByte)) return system_error(stamp_file, error);
    return store;
}

Result<bool> FrameStore::reserve(int frame, bool wait) const {
    const int error = set_lock(descriptor_, F_WRLCK, byte_of(frame), wait);
    if (error != 0 && error != EAGAIN) return system_error(stamp_file_, error);
    return error == 0;
}

Status FrameStore::reopen() {
    const int own = ::open(stamp_file_.c_str(), O_RDWR | O_CLOEXEC);
    if (own < 0) return system_error(stamp_file_, errno);
    descriptor_ = own;  // the one before stays open, and with it the run's lock
    return Done{};
}

void FrameStore::release(int frame) const { set_lock(descriptor_, F_UNLCK, byte_of(frame)); }

bool FrameStore::has(int frame) const {
    struct stat picture {
    }, stamp{};
    if (::stat(file(frame).c_str(), &picture) != 0 || ::fstat(descriptor_, &stamp) != 0) return false;
    const auto time = [](const struct stat& s) { return std::pair(s.st_mtim.tv_sec, s.st_mtim.tv_nsec); };
    return time(picture) >= time(stamp);
}

}  // namespace nullscope::cli
