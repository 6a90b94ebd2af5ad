#include "support/reference_memory.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "base/atomic_file.h"
#include "base/text.h"
#include "support/depth.h"

namespace nullscope::test {
namespace {

// A byte: less is read no faster than it is computed. (A pixel of some 100 bytes takes 1e-6 s by closed forms, 1e-4 s
// by steps about rotating holes.)
constexpr double kWorthKeeping_s = 5e-8;

// Of 128 bits: two hashes with different starts.
std::string name_of(std::string_view text) {
    std::string name;
    for (const std::uint64_t start : {14695981039346656037ull, 0x9e3779b97f4a7c15ull})
        name += fmt::format("{:016x}", fnv1a(text, start));
    return name;
}

// A file: the answers' bytes, then their name_of.
std::optional<std::string> read(const std::filesystem::path& path, std::size_t size) {
    auto text = read_text(path);
    if (!text || text->size() < 32 || (text->size() - 32) % size != 0) return {};
    const std::string_view all = *text, bytes = all.substr(0, all.size() - 32);
    if (name_of(bytes) != all.substr(bytes.size())) return {};
    text->resize(bytes.size());
    return std::move(*text);
}

std::filesystem::path folder_of_this_run() {
    const char *folder = std::getenv("NULLSCOPE_REFERENCE_MEMORY"), *mark = std::getenv("NULLSCOPE_REFERENCE_MARK");
    if (folder == nullptr || mark == nullptr || depth() != Depth::kQuick) return {};
    const auto code = read_text(mark);
    return code ? std::filesystem::path(folder) / name_of(*code) : std::filesystem::path();
}

}  // namespace

ReferenceMemory::ReferenceMemory(std::filesystem::path folder) : folder_(std::move(folder)) {
    if (folder_.empty()) return;
    std::error_code ignored;
    std::filesystem::create_directories(folder_, ignored);
    for (const auto& other : std::filesystem::directory_iterator(folder_.parent_path(), ignored))
        if (other.path() != folder_) std::filesystem::remove_all(other.path(), ignored);
}

const ReferenceMemory& ReferenceMemory::of_this_run() {
    static const ReferenceMemory memory(folder_of_this_run());
    return memory;
}

std::string ReferenceMemory::bytes_of(const std::string& question, std::size_t size,
                                      const std::function<std::string()>& compute) const {
    if (folder_.empty()) return compute();
    const std::filesystem::path path = folder_ / name_of(question);
    if (auto kept = read(path, size)) return std::move(*kept);
    const auto start = std::chrono::steady_clock::now();
    std::string bytes = compute();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    // What cannot be kept is computed again: no error.
    if (took.count() >= kWorthKeeping_s * static_cast<double>(bytes.size()))
        static_cast<void>(write_text_atomically(path, bytes + name_of(bytes)));
    return bytes;
}

}  // namespace nullscope::test
