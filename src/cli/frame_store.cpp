#include "cli/frame_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

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

FrameStore::~FrameStore() {
    if (descriptor_ < 0) return;
    if (new_ && is_named(descriptor_, stamp_file_)) ::unlink(stamp_file_.c_str());
    ::close(descriptor_);  // which frees the lock
}

// The descriptor is inherited by ffmpeg on purpose: an encoder that outlives a killed run keeps the pictures locked.
Result<std::unique_ptr<FrameStore>> FrameStore::lock(const FrameNames& names, const std::string& stamp_file,
                                                     const std::string& what) {
    for (;;) {
        const int descriptor = ::open(stamp_file.c_str(), O_RDWR | O_CREAT, 0666);
        if (descriptor < 0) return system_error(stamp_file, errno);
        std::unique_ptr<FrameStore> store(new FrameStore(names, stamp_file, descriptor));
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            if (errno == EWOULDBLOCK)
                return failed(
                    fmt::format("{}: another run is drawing it; wait for it to end, or choose another -o", what));
            return failed(fmt::format("{}: cannot be locked: {}", stamp_file, std::generic_category().message(errno)));
        }
        if (is_named(descriptor, stamp_file)) return store;
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
    auto store = lock(FrameNames::in_folder(folder), folder + "/stamp", folder);
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

Result<std::unique_ptr<FrameStore>> FrameStore::open_sequence(const FrameNames& names, Frames frames,
                                                              const std::string& stamp, bool resume) {
    const std::string stamp_file = names.stamp_file();
    auto store = lock(names, stamp_file, names.pattern());
    if (!store) return store;
    TRY(before, read_text(stamp_file));
    if (resume && *before == stamp) return store;
    (*store)->new_ = before->empty();
    int there = 0;
    for (int frame = frames.first; resume && frame < frames.end; ++frame) there += fs::exists(names.of(frame));
    if (there > 0)
        return bad_input(fmt::format(
            "--resume: {} pictures of {} do not match: {}; start over without --resume, or choose another -o", there,
            names.pattern(), stamp_difference(*before, stamp)));
    TRY(written, (*store)->write(stamp));
    return store;
}

bool FrameStore::has(int frame) const {
    struct stat picture {
    }, stamp{};
    if (::stat(file(frame).c_str(), &picture) != 0 || ::fstat(descriptor_, &stamp) != 0) return false;
    const auto time = [](const struct stat& s) { return std::pair(s.st_mtim.tv_sec, s.st_mtim.tv_nsec); };
    return time(picture) >= time(stamp);
}

}  // namespace nullscope::cli
