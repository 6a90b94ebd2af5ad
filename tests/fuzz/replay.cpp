// main() of a fuzz target in an ordinary build: runs every file of the folders and files named, once each.
#include <filesystem>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "fuzz.h"

int main(int argc, char** argv) {
    namespace fs = std::filesystem;
    std::vector<fs::path> files;
    for (int i = 1; i < argc; ++i) {
        if (!fs::is_directory(argv[i]))
            files.emplace_back(argv[i]);
        else
            for (const auto& entry : fs::recursive_directory_iterator(argv[i]))
                if (entry.is_regular_file()) files.push_back(entry.path());
    }
    for (const fs::path& file : files) {
        const auto bytes = nullscope::read_text(file);
        if (!bytes) return std::fprintf(stderr, "replay: %s\n", bytes.error().message().c_str()), 1;
        std::printf("%s\n", file.c_str());
        std::fflush(stdout);  // the last line names the file that broke
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size());
    }
    std::printf("%zu files\n", files.size());
    return files.empty() ? 1 : 0;  // a corpus that is not there is a failure
}
