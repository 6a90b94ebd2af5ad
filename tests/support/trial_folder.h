// A folder of its own, for as long as it lives.
#pragma once
#include <cstdlib>
#include <filesystem>
#include <string>

namespace nullscope::test {

class TrialFolder {
public:
    TrialFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "nullscope-test-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) std::abort();
        path_ = name;
    }
    TrialFolder(const TrialFolder&) = delete;
    TrialFolder& operator=(const TrialFolder&) = delete;
    ~TrialFolder() { std::filesystem::remove_all(path_); }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace nullscope::test
