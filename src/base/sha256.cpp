#include "base/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace nullscope {
namespace {

namespace fs = std::filesystem;

Result<std::string> sha256_now(const fs::path& file) {
    const auto unreadable = [&] { return bad_input(fmt::format("cannot read '{}'", file.string())); };
    std::ifstream in(file, std::ios::binary);
    if (!in) return unreadable();
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> hash(EVP_MD_CTX_new(), EVP_MD_CTX_free);
    bool good = hash != nullptr && EVP_DigestInit_ex(hash.get(), EVP_sha256(), nullptr) == 1;
    std::vector<char> bytes(1u << 20);
    while (good && (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())), in.gcount() > 0))
        good = EVP_DigestUpdate(hash.get(), bytes.data(), static_cast<std::size_t>(in.gcount())) == 1;
    if (in.bad()) return unreadable();
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned size = 0;
    if (!good || EVP_DigestFinal_ex(hash.get(), digest.data(), &size) != 1)
        return failed(fmt::format("SHA-256 of '{}': libcrypto fails", file.string()));
    std::string text;
    for (unsigned i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
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
    static std::map<std::string, KnownHash> known;
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
