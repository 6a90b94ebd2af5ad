// SHA-256 of bytes (FIPS 180-4): libcrypto's; on Windows the system's own.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string_view>

namespace nullscope::platform {

class Sha256 {
public:
    using Digest = std::array<unsigned char, 32>;
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;
    void add(std::string_view bytes);
    std::optional<Digest> digest();  // of all of them, once; nothing: the library has failed

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace nullscope::platform
