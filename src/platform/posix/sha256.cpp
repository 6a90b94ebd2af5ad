#include "platform/sha256.h"

#include <openssl/evp.h>

namespace nullscope::platform {

struct Sha256::State {
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> hash{EVP_MD_CTX_new(), EVP_MD_CTX_free};
    bool good = hash != nullptr && EVP_DigestInit_ex(hash.get(), EVP_sha256(), nullptr) == 1;
};

Sha256::Sha256() : state_(std::make_unique<State>()) {}
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
    state_->good = state_->good && EVP_DigestUpdate(state_->hash.get(), bytes.data(), bytes.size()) == 1;
}

std::optional<Sha256::Digest> Sha256::digest() {
    Digest digest{};
    unsigned size = 0;
    if (!state_->good || EVP_DigestFinal_ex(state_->hash.get(), digest.data(), &size) != 1) return std::nullopt;
    return digest;
}

}  // namespace nullscope::platform
