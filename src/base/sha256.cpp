#include "base/sha256.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <map>
#include <mutex>
#include <vector>

#include "platform/sha256.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

Result<std::string> sha256_now(const fs::path& file) {
    const auto unreadable = [&] { return bad_input(fmt::format("cannot read '{}'", file.string())); };
    std::ifstream in(file, std::ios::binary);
    if (!in) return unreadable();
    platform::Sha256 hash;
    std::vector<char> bytes(1u << 20);
    while (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())), in.gcount() > 0)
        hash.add({bytes.data(), static_cast<std::size_t>(in.gcount())});
    if (in.bad()) return unreadable();
    const auto digest = hash.digest();
    if (!digest) return failed(fmt::format("SHA-256 of '{}' cannot be computed", file.string()));
    std::string text;
    for (const unsigned char byte : *digest) text += fmt::format("{:02x}", byte);
    return text;
}

struct KnownHash {
    fs::file_time_type time;
    std::uintmax_t size = 0;
    std::string hash;
};

}  // namespace

Result<std::string> sha256_of(const fs::path& file) {
    static std::mutex mutex;
    static std::map<fs::path::string_type, KnownHash> known;
    constexpr std::size_t kMostKept = 1000;
    std::error_code none;
    const auto time = fs::last_write_time(file, none);
    const auto size = fs::file_size(file, none);
    const std::lock_guard lock(mutex);
    const auto found = known.find(file.native());
    if (found != known.end() && found->second.time == time && found->second.size == size) return found->second.hash;
    TRY(hash, sha256_now(file));
    if (known.size() >= kMostKept) known.clear();
    known.insert_or_assign(file.native(), KnownHash{time, size, *hash});
    return hash;
}

}  // namespace nullscope
