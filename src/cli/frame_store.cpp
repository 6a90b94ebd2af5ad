#include "cli/frame_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/atomic_file.h"
#include "cli/frame_stamp.h"

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

FrameStore::FrameStore(FrameStore&& other) noexcept
    : names_(std::move(other.names_)),
      stamp_file_(std::move(other.stamp_file_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      new_(other.new_) {}

FrameStore::~FrameStore() {
    if (descriptor_ < 0) return;
    if (new_ && is_named(descriptor_, stamp_file_)) ::unlink(stamp_file_.c_str());
    ::close(descriptor_);  // which frees the lock
}

// The descriptor is inherited by ffmpeg on purpose: an encoder that outlives a killed run keeps the pictures locked.
Result<FrameStore> FrameStore::lock(const FrameNames& names, const std::string& stamp_file, const std::string& what) {
    for (;;) {
        const int descriptor = ::open(stamp_file.c_str(), O_RDWR | O_CREAT, 0666);
        if (descriptor < 0) return system_error(stamp_file, errno);
        FrameStore store(names, stamp_file, descriptor);
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            if (errno == EWOULDBLOCK)
                return failed(fmt::format("{}: another run is drawing it; wait for that, or choose another -o", what));
            return failed(fmt::format("{}: cannot be locked: {}", stamp_file, std::generic_category().message(errno)));
        }
        if (is_named(descriptor, stamp_file)) return store;
    }
}

Result<std::string> FrameStore::read() const { return read_text(stamp_file_); }

Status FrameStore::write(const std::string& stamp) const {
    if (::ftruncate(descriptor_, 0) != 0) return system_error(stamp_file_, errno);
    for (std::size_t done = 0; done < stamp.size();) {
        const ssize_t n = ::pwrite(descriptor_, stamp.data() + done, stamp.size() - done, static_cast<off_t>(done));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return system_error(stamp_file_, errno);
        done += static_cast<std::size_t>(n);
    }
    return Done{};
}

Result<FrameStore> FrameStore::open_film(const std::string& folder, const std::string& stamp) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return failed(fmt::format("{}: {}", folder, error.message()));
    auto store = lock(FrameNames::in_folder(folder), folder + "/stamp", folder);
    if (!store) return store;
    const auto before = store->read();
    if (!before) return before.error();
    if (*before == stamp) return store;
    const auto removed = remove_pictures(folder);
    if (!removed) return removed.error();
    if (*removed > 0)
        fmt::print(stderr, "{}: drawn anew, {} pictures of a stopped run do not fit: {}\n", folder, *removed,
                   stamp_difference(*before, stamp));
    store->new_ = before->empty();
    if (Status written = store->write(stamp); !written) return written.error();
    return store;
}

Result<FrameStore> FrameStore::open_sequence(const FrameNames& names, Frames frames, const std::string& stamp,
                                             bool resume) {
    const std::string stamp_file = names.stamp_file();
    auto store = lock(names, stamp_file, names.pattern());
    if (!store) return store;
    const auto before = store->read();
    if (!before) return before.error();
    if (resume && *before == stamp) return store;
    int there = 0;
    for (int frame = frames.first; resume && frame < frames.end; ++frame) there += fs::exists(names.of(frame));
    if (there > 0) {
        store->new_ = before->empty();
        return bad_input(fmt::format(
            "--resume: {} pictures of {} do not fit: {}; start afresh without --resume, or choose another -o", there,
            names.pattern(), stamp_difference(*before, stamp)));
    }
    store->new_ = before->empty();
    if (Status written = store->write(stamp); !written) return written.error();
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
