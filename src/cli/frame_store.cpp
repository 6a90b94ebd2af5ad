#include "cli/frame_store.h"

#include <fmt/format.h>

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

using LockKind = platform::LockFile::Kind;

Error system_error(const std::string& file, const std::error_code& error) {
    return failed(fmt::format("{}: {}", file, error.message()));
}

bool is_picture_of_film(const fs::path& file) {
    const std::string stem = file.stem().string();
    return file.extension() == ".png" && stem.size() >= 5 && stem.find_first_not_of("0123456789") == std::string::npos;
}

std::string stamp_of_film(const std::string& folder) { return folder + "/stamp"; }

// Byte 0 of the stamp file stands for the stamp, byte 1 + N for frame N.
constexpr long long kStampByte = 0;
long long byte_of(int frame) { return 1LL + frame; }

bool is_taken(const std::error_code& error) { return error == std::errc::resource_unavailable_try_again; }

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

FrameStore::FrameStore(FrameNames names, std::string stamp_file, platform::LockFile locks)
    : names_(std::move(names)), stamp_file_(std::move(stamp_file)), locks_(std::move(locks)) {}

// A stamp stays that other runs draw under, or have drawn under.
FrameStore::~FrameStore() {
    if (!locks_.is_open()) return;
    const bool alone = new_ && !locks_.set(LockKind::kExclusive, kStampByte) && (!shared_ || names_.on_disk().empty());
    if (alone) locks_.remove_and_close();
}

// Programs keep the locks too, which is for ffmpeg: an encoder that outlives a killed run keeps the pictures locked.
Result<std::unique_ptr<FrameStore>> FrameStore::lock(const FrameNames& names, const std::string& stamp_file,
                                                     const std::string& what, Lock kind, double patience_s) {
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::duration<double>(patience_s);
    for (;;) {
        platform::LockFile locks;
        if (const auto error = locks.open(stamp_file, platform::LockFile::Kept::kLeft))
            return system_error(stamp_file, error);
        const auto error = locks.set(kind == Lock::kShared ? LockKind::kShared : LockKind::kExclusive, kStampByte);
        const bool named = locks.has_its_name();  // a stamp is removed with a film's folder
        if (!error && named) return std::unique_ptr<FrameStore>(new FrameStore(names, stamp_file, std::move(locks)));
        if (!error) continue;
        if (!is_taken(error)) return failed(fmt::format("{}: cannot be locked: {}", stamp_file, error.message()));
        if (Clock::now() >= deadline)
            return failed(fmt::format("{}: another run is drawing it; wait for it to end, or choose another -o", what));
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

// Into the file that is locked: no other takes its name.
Status FrameStore::write(const std::string& stamp) const {
    std::ofstream file(stamp_file_, std::ios::binary | std::ios::trunc);
    if (file << stamp << std::flush) return Done{};
    return system_error(stamp_file_, {errno, std::generic_category()});
}

Result<std::unique_ptr<FrameStore>> FrameStore::open_film(const std::string& folder, const std::string& stamp) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return failed(fmt::format("{}: {}", folder, error.message()));
    auto store = lock(FrameNames::in_folder(folder), stamp_of_film(folder), folder, Lock::kExclusive, 0);
    if (!store) return store;
    TRY(before, read_text(stamp_of_film(folder)));
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
    if (const auto error = (*store)->locks_.set(LockKind::kShared, kStampByte)) return system_error(stamp_file, error);
    return store;
}

Result<std::unique_ptr<FrameStore>> FrameStore::join(const FrameNames& names, const std::string& stamp_file) {
    std::unique_ptr<FrameStore> store(new FrameStore(names, stamp_file, {}));
    TRY(own, store->reopen());
    return store;
}

Result<std::unique_ptr<FrameStore>> FrameStore::join_film(const std::string& folder) {
    return join(FrameNames::in_folder(folder), stamp_of_film(folder));
}

Result<std::unique_ptr<FrameStore>> FrameStore::join_sequence(const FrameNames& names) {
    return join(names, names.stamp_file());
}

Result<bool> FrameStore::reserve(int frame, bool wait) const {
    const auto error = locks_.set(LockKind::kExclusive, byte_of(frame), wait);
    if (error && !is_taken(error)) return system_error(stamp_file_, error);
    return !error;
}

Status FrameStore::reopen() {
    platform::LockFile own;
    if (const auto error = own.open(stamp_file_, platform::LockFile::Kept::kHere))
        return system_error(stamp_file_, error);
    locks_.forget();  // the one before stays open, and with it the run's lock
    locks_ = std::move(own);
    return Done{};
}

void FrameStore::release(int frame) const { locks_.set(LockKind::kNone, byte_of(frame)); }

bool FrameStore::has(int frame) const { return locks_.is_as_old_as(file(frame)); }

}  // namespace nullscope::cli
