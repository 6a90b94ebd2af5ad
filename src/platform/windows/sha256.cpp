#include "platform/sha256.h"

#include <windows.h>
// Behind windows.h, whose types it needs.
#include <bcrypt.h>

namespace nullscope::platform {

struct Sha256::State {
    State() {
        good = BCRYPT_SUCCESS(::BCryptOpenAlgorithmProvider(&algorithm, BCRYPT_SHA256_ALGORITHM, nullptr, 0)) &&
               BCRYPT_SUCCESS(::BCryptCreateHash(algorithm, &hash, nullptr, 0, nullptr, 0, 0));
    }
    ~State() {
        if (hash != nullptr) ::BCryptDestroyHash(hash);
        if (algorithm != nullptr) ::BCryptCloseAlgorithmProvider(algorithm, 0);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    BCRYPT_ALG_HANDLE algorithm = nullptr;
    BCRYPT_HASH_HANDLE hash = nullptr;
    bool good = false;
};

Sha256::Sha256() : state_(std::make_unique<State>()) {}
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
    auto* const data = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));  // it only reads them
    state_->good =
        state_->good && BCRYPT_SUCCESS(::BCryptHashData(state_->hash, data, static_cast<ULONG>(bytes.size()), 0));
}

std::optional<Sha256::Digest> Sha256::digest() {
    Digest digest{};
    if (!state_->good ||
        !BCRYPT_SUCCESS(::BCryptFinishHash(state_->hash, digest.data(), static_cast<ULONG>(digest.size()), 0)))
        return std::nullopt;
    return digest;
}

}  // namespace nullscope::platform
