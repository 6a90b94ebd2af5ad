// What the fuzz targets share. A target reads one input, and aborts when what came of it breaks the reader's contract:
// so a fuzzer finds wrong answers too, not only crashes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "base/result.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace nullscope::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

inline void must(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "fuzz: broken: %s\n", what);
    std::abort();
}

// An error is one line that a terminal can print, and blames the input.
inline void must_be_a_good_error(const Error& error) {
    must(error.kind == ErrorKind::kBadInput, "an error of bad input has that kind");
    must(!error.message().empty(), "an error says something");
    for (const char c : error.message())
        must(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f, "an error is one line without control characters");
}

}  // namespace nullscope::fuzz
