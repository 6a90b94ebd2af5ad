// Result<T>: a value, or the reason why there is none. Bad input is a value, never an exception.
#pragma once
#include <string>
#include <utility>
#include <variant>

namespace nullscope {

// Who can mend it: kBadInput (exit status 2: usage or scene) or kFailed (exit status 1: it could not be done).
enum class ErrorKind { kFailed = 1, kBadInput = 2 };

// What is known of it, part by part; all but `what` may be empty.
struct Error {
    ErrorKind kind = ErrorKind::kFailed;
    std::string what;       // is wrong: "5 is out of range"
    std::string allowed{};  // instead: "[0, 1]"
    std::string key{};      // of a scene file, column of a table, option: "camera.r"
    std::string file{};
    int line = 0;                 // in the file, from 1; 0: of the whole file
    std::string message() const;  // one line, "FILE:LINE: KEY: WHAT; allowed: ALLOWED" of the parts that are there
};

inline Error failed(std::string what) { return {ErrorKind::kFailed, std::move(what)}; }
inline Error bad_input(std::string what, std::string allowed = {}) {
    return {ErrorKind::kBadInput, std::move(what), std::move(allowed)};
}
inline Error bad_key(std::string key, std::string what, std::string allowed) {
    return {ErrorKind::kBadInput, std::move(what), std::move(allowed), std::move(key)};
}
// The error of a key of a section: "radius" of "ball[2]".
inline Error within(const std::string& section, Error error) {
    error.key = error.key.empty() ? section : section + "." + error.key;
    return error;
}

template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: implicit on purpose
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit on purpose
    explicit operator bool() const { return state_.index() == 0; }
    T& operator*() { return std::get<0>(state_); }
    const T& operator*() const { return std::get<0>(state_); }
    T* operator->() { return &std::get<0>(state_); }
    const T* operator->() const { return &std::get<0>(state_); }
    const Error& error() const { return std::get<1>(state_); }

private:
    std::variant<T, Error> state_;
};

struct Done {};
using Status = Result<Done>;

// Declares `name`, the Result of an expression; where that is an error, the function returns it.
#define TRY(name, ...)       \
    auto name = __VA_ARGS__; \
    if (!name) return name.error()

}  // namespace nullscope
