// Locks here keep others from reading and writing what is locked: the bytes are far behind any text.
#include "platform/file_lock.h"

#include <windows.h>

#include <filesystem>
#include <utility>

namespace nullscope::platform {
namespace {

constexpr long long kBehindTexts = 1LL << 40;

HANDLE handle_of(long long handle) { return reinterpret_cast<HANDLE>(handle); }

std::error_code last_error() {
    const DWORD error = ::GetLastError();
    if (error == ERROR_LOCK_VIOLATION || error == ERROR_IO_PENDING)
        return std::make_error_code(std::errc::resource_unavailable_try_again);
    return {static_cast<int>(error), std::system_category()};
}

OVERLAPPED place_of(long long byte) {
    OVERLAPPED place{};
    place.Offset = static_cast<DWORD>(kBehindTexts + byte);
    place.OffsetHigh = static_cast<DWORD>((kBehindTexts + byte) >> 32);
    return place;
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
    name_ = file;
    const HANDLE handle = ::CreateFileW(
        std::filesystem::path(file).c_str(), GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr,
        kept == Kept::kLeft ? OPEN_ALWAYS : OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
    handle_ = reinterpret_cast<long long>(handle);  // INVALID_HANDLE_VALUE is -1
    return handle == INVALID_HANDLE_VALUE ? last_error() : std::error_code();
}

bool LockFile::is_open() const { return handle_ != -1; }

void LockFile::close() {
    if (is_open()) ::CloseHandle(handle_of(std::exchange(handle_, -1)));
}

void LockFile::forget() { handle_ = -1; }

void LockFile::remove_and_close() {
    close();
    std::error_code others_have_it_open;
    std::filesystem::remove(name_, others_have_it_open);
}

bool LockFile::has_its_name() const { return is_open(); }  // what is open cannot be removed

std::error_code LockFile::set(Kind kind, long long byte, bool wait) const {
    OVERLAPPED place = place_of(byte);
    ::UnlockFileEx(handle_of(handle_), 0, 1, 0, &place);  // kinds are not turned into one another
    if (kind == Kind::kNone) return {};
    place = place_of(byte);
    const DWORD flags =
        (kind == Kind::kExclusive ? LOCKFILE_EXCLUSIVE_LOCK : 0) | (wait ? 0 : LOCKFILE_FAIL_IMMEDIATELY);
    return ::LockFileEx(handle_of(handle_), flags, 0, 1, 0, &place) != 0 ? std::error_code() : last_error();
}

bool LockFile::is_as_old_as(const std::string& file) const {
    FILETIME own{};
    WIN32_FILE_ATTRIBUTE_DATA other{};
    return ::GetFileTime(handle_of(handle_), nullptr, nullptr, &own) != 0 &&
           ::GetFileAttributesExW(std::filesystem::path(file).c_str(), GetFileExInfoStandard, &other) != 0 &&
           ::CompareFileTime(&other.ftLastWriteTime, &own) >= 0;
}

}  // namespace nullscope::platform
