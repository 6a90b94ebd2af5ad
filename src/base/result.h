// Result<T>: a value, or the reason why there is none. Bad input is a value, never an exception.
#pragma once
#include <string>
#include <utility>
#include <variant>

namespace nullscope {

// Who can mend it: kBadInput (exit status 2: usage or scene) or kFailed (exit status 1: it could not be done).
enum class ErrorKind { kFailed = 1, kBadInput = 2 };

struct Error {
    ErrorKind kind = ErrorKind::kFailed;
    std::string message;  // one line: file, line, key and allowed range where they exist
};

inline Error bad_input(std::string message) { return {ErrorKind::kBadInput, std::move(message)}; }
inline Error failed(std::string message) { return {ErrorKind::kFailed, std::move(message)}; }

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

}  // namespace nullscope
