// How Python calls what takes long: without the interpreter's lock, with progress, interruptible, errors as exceptions.
#pragma once
#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/result.h"
#include "command/draw_options.h"

namespace nullscope::python {

namespace nb = nanobind;

// Becomes nullscope.Error: one line.
struct Refused : std::runtime_error {
    explicit Refused(const Error& error);
};

// The value, or Refused.
template <class T>
T value_of(Result<T> result) {
    if (!result) throw Refused(result.error());
    return std::move(*result);
}

// bool, and NumPy's: no number here, as none in scene files.
bool is_boolean(nb::handle argument);

// What an argument is; else Refused, by its name.
double number_of(const char* name, const nb::object& argument);
std::string text_of(const char* name, const nb::object& argument);

// Of one call: hears of progress from any thread, tells the callback and looks for signals in the caller's.
class Watch {
public:
    // callback: None, or called with units done and in all, at most some 20 times a second.
    explicit Watch(nb::object callback);
    cli::Listener listener();
    void advance(long long units);  // throws what the callback throws, or KeyboardInterrupt
    bool stopped() const { return stop_; }
    [[noreturn]] void raise() const { std::rethrow_exception(raised_); }
    void finish();  // all is done: the last call of the callback, and notes as warnings. With the lock.

private:
    void tell();  // with the lock
    nb::object callback_;
    std::thread::id caller_ = std::this_thread::get_id();
    std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();
    std::atomic<long long> done_{0}, total_{0};
    std::atomic<bool> stop_{false};
    std::exception_ptr raised_;
    std::mutex notes_mutex_;
    std::vector<std::string> notes_;
};

// The one line of an exception that is not an Error.
Error error_of(const std::exception& exception);

// What work(watch), a Result, gives; without the lock, which it must not need.
template <class Work>
auto run(const nb::object& progress, const Work& work) {
    Watch watch(progress);
    auto result = [&]() -> decltype(work(watch)) {
        const nb::gil_scoped_release released;
        try {
            return work(watch);
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception& exception) {
            if (watch.stopped()) watch.raise();
            return error_of(exception);
        }
    }();
    auto value = value_of(std::move(result));
    watch.finish();
    return value;
}

}  // namespace nullscope::python
