#include "platform/windows/utf8.h"

#include <cerrno>
#include <cwchar>

namespace {

constexpr std::size_t kInvalid = static_cast<std::size_t>(-1), kIncomplete = static_cast<std::size_t>(-2);
constexpr unsigned kLastOfOne = 0xffff;  // beyond it a character is two of UTF-16

std::size_t invalid() {
    errno = EILSEQ;
    return kInvalid;
}

// How many bytes a character with this one at its front has; 0: none has.
std::size_t length_by(unsigned char first) {
    return first < 0x80 ? 1 : first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
}

// state: the second half of a character of which the first was given, or 0.
std::size_t take(wchar_t* to, const char* from, std::size_t count, std::mbstate_t& state) {
    if (count == 0) return kIncomplete;
    if (state != 0) {
        if (to != nullptr) *to = static_cast<wchar_t>(state);
        state = 0;
        return 1;  // the last byte, left for it
    }
    const std::size_t length = length_by(static_cast<unsigned char>(*from));
    if (length == 0) return invalid();
    if (count < length) return kIncomplete;
    unsigned character = static_cast<unsigned char>(*from) & (length == 1 ? 0x7fu : 0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((static_cast<unsigned char>(from[i]) & 0xc0) != 0x80) return invalid();
        character = character << 6 | (static_cast<unsigned char>(from[i]) & 0x3f);
    }
    const bool two = character > kLastOfOne;
    if (two) state = static_cast<std::mbstate_t>(0xdc00 + (character & 0x3ff));
    if (to != nullptr) *to = static_cast<wchar_t>(two ? 0xd7c0 + (character >> 10) : character);
    return character == 0 ? 0 : two ? length - 1 : length;
}

// state: the first half of a character of which the second comes, or 0.
std::size_t put(char* to, wchar_t from, std::mbstate_t& state) {
    unsigned character = from;
    if (state != 0) {
        if ((character & 0xfc00) != 0xdc00) return invalid();
        character = 0x10000 + ((static_cast<unsigned>(state) & 0x3ff) << 10) + (character & 0x3ff);
        state = 0;
    } else if ((character & 0xfc00) == 0xd800) {
        state = static_cast<std::mbstate_t>(character);
        return 0;
    }
    if (character < 0x80) return *to = static_cast<char>(character), 1;
    const std::size_t length = character < 0x800 ? 2 : character <= kLastOfOne ? 3 : 4;
    for (std::size_t i = length - 1; i > 0; --i, character >>= 6) to[i] = static_cast<char>(0x80 | (character & 0x3f));
    *to = static_cast<char>((0xf00u >> length & 0xf0) | character);
    return length;
}

std::mbstate_t& kept(std::mbstate_t* state) {
    static thread_local std::mbstate_t own = 0;
    return state != nullptr ? *state : own;
}

}  // namespace

extern "C" {

std::size_t mbrtowc(wchar_t* to, const char* from, std::size_t count, std::mbstate_t* state) {
    return from == nullptr ? (kept(state) = 0, 0) : take(to, from, count, kept(state));
}

std::size_t mbrlen(const char* from, std::size_t count, std::mbstate_t* state) {
    return mbrtowc(nullptr, from, count, state);
}

std::size_t mbsrtowcs(wchar_t* to, const char** from, std::size_t count, std::mbstate_t* state) {
    for (std::size_t made = 0;; ++made) {
        if (to != nullptr && made == count) return made;
        wchar_t next = 0;
        const std::size_t taken = take(&next, *from, 4, kept(state));
        if (taken == kInvalid || taken == kIncomplete) return invalid();
        if (to != nullptr) to[made] = next;
        if (taken == 0) return (to != nullptr ? *from = nullptr : *from), made;
        *from += taken;
    }
}

std::size_t wcrtomb(char* to, wchar_t from, std::mbstate_t* state) {
    return to == nullptr ? (kept(state) = 0, 1) : put(to, from, kept(state));
}

std::size_t wcsrtombs(char* to, const wchar_t** from, std::size_t count, std::mbstate_t* state) {
    char bytes[4] = {};
    for (std::size_t made = 0;; ++*from) {
        const std::size_t length = put(bytes, **from, kept(state));
        if (length == kInvalid) return kInvalid;
        if (to != nullptr && made + length > count) return made;
        for (std::size_t i = 0; to != nullptr && i < length; ++i) to[made + i] = bytes[i];
        if (**from == L'\0') return (to != nullptr ? *from = nullptr : *from), made;
        made += length;
    }
}

// The most bytes that a character has: msvcrt says 1, and libstdc++ gives wcrtomb() no more room than by this.
static int most_bytes() { return 4; }
extern int (*const __imp____mb_cur_max_func)();
int (*const __imp____mb_cur_max_func)() = most_bytes;  // where a caller of a DLL looks for its address

}  // extern "C"

namespace nullscope::platform {

void use_utf8() {}

}  // namespace nullscope::platform
