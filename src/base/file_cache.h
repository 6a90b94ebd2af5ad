// What was read from a file, or why it could not be, kept for as long as the file does not change. Thread-safe.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "base/atomic_file.h"
#include "base/result.h"

namespace nullscope {

template <class T>
class FileCache {
public:
    using Answer = Result<std::shared_ptr<const T>>;

    // most: files that are kept; one more, and all but that one are let go.
    FileCache(std::size_t most, std::size_t largest_file) : most_(most), largest_(largest_file) {}

    // parse(std::string_view bytes, const std::string& name): Result<T>. fresh: set where the file was read now.
    template <class Parse>
    Answer get(const std::filesystem::path& file, Parse parse, bool* fresh = nullptr) {
        std::error_code none;
        const auto time = std::filesystem::last_write_time(file, none);
        const auto size = std::filesystem::file_size(file, none);
        const std::lock_guard lock(mutex_);
        if (const auto found = kept_.find(file.native());
            found != kept_.end() && found->second.time == time && found->second.size == size)
            return found->second.value;
        if (kept_.size() >= most_) kept_.clear();
        Answer value = read(file, parse);
        if (fresh != nullptr) *fresh = static_cast<bool>(value);
        kept_.insert_or_assign(file.native(), Kept{value, time, size});
        return value;
    }

    // What was read last from the file, which is not looked at; nullptr: nothing.
    std::shared_ptr<const T> known(const std::filesystem::path& file) const {
        const std::lock_guard lock(mutex_);
        const auto found = kept_.find(file.native());
        return found != kept_.end() && found->second.value ? *found->second.value : nullptr;
    }

private:
    template <class Parse>
    Answer read(const std::filesystem::path& file, Parse parse) const {
        TRY(text, read_text(file, largest_));
        TRY(value, parse(*text, file.string()));
        return std::make_shared<const T>(std::move(*value));
    }
    struct Kept {
        Answer value;
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
    };
    std::size_t most_, largest_;
    mutable std::mutex mutex_;
    std::map<std::filesystem::path::string_type, Kept> kept_;
};

}  // namespace nullscope
