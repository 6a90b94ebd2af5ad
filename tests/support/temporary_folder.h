// A folder that exists while the object does.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

struct TemporaryFolder {
    std::filesystem::path path;

    explicit TemporaryFolder(const std::string& name)
        : path(std::filesystem::temp_directory_path() / ("nullscope-" + name + "-" + std::to_string(::getpid()))) {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    long files() const {
        return std::distance(std::filesystem::directory_iterator(path), std::filesystem::directory_iterator());
    }
};
