#include "module/call.h"

#include <nanobind/stl/string.h>

#include <algorithm>
#include <string_view>

#include "base/text.h"

namespace nullscope::python {
namespace {

constexpr std::chrono::milliseconds kBetweenCalls{50};

struct Stopped : std::exception {};  // of another thread than the caller's

}  // namespace

Refused::Refused(const Error& error) : std::runtime_error(without_controls(error.message())) {}

Error error_of(const std::exception& exception) { return failed(exception.what()); }

bool is_boolean(nb::handle argument) {
    if (PyBool_Check(argument.ptr()) != 0) return true;
    if (!nb::hasattr(argument, "dtype")) return false;
    const nb::object dtype = argument.attr("dtype");
    return std::string_view(nb::str(nb::handle(dtype)).c_str()) == "bool";
}

double number_of(const char* name, const nb::object& argument) {
    double number = 0;
    if (!is_boolean(argument) && nb::try_cast(argument, number)) return number;
    throw Refused(bad_key(name, std::string(Py_TYPE(argument.ptr())->tp_name) + " is of another kind", "a number"));
}

std::string text_of(const char* name, const nb::object& argument) {
    std::string text;
    if (nb::try_cast(argument, text)) return text;
    throw Refused(bad_key(name, std::string(Py_TYPE(argument.ptr())->tp_name) + " is of another kind", "text"));
}

Watch::Watch(nb::object callback) : callback_(std::move(callback)) {
    if (!callback_.is_none() && PyCallable_Check(callback_.ptr()) == 0)
        throw Refused(bad_input("progress: not a function", "None, or a function of two numbers, done and total"));
}

cli::Listener Watch::listener() {
    cli::Listener listener;
    listener.progress = [this](const std::string&, long long total) -> Advance {
        done_ = 0, total_ = total;
        return [this](long long units) { advance(units); };
    };
    listener.note = [this](const std::string& line) {
        const std::lock_guard lock(notes_mutex_);
        notes_.push_back(line);
    };
    return listener;
}

void Watch::advance(long long units) {
    done_ += units;
    if (stop_) throw Stopped();
    if (std::this_thread::get_id() != caller_ || std::chrono::steady_clock::now() - told_ < kBetweenCalls) return;
    const nb::gil_scoped_acquire locked;
    try {
        if (PyErr_CheckSignals() != 0) throw nb::python_error();
        tell();
    } catch (...) {
        raised_ = std::current_exception();
        stop_ = true;
        throw Stopped();
    }
    told_ = std::chrono::steady_clock::now();
}

void Watch::tell() {
    if (!callback_.is_none()) callback_(std::min(done_.load(), total_.load()), total_.load());
}

void Watch::finish() {
    total_ = std::max(total_.load(), 1LL);
    done_ = total_.load();
    tell();
    for (const std::string& note : notes_)
        if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 2) != 0) throw nb::python_error();
}

}  // namespace nullscope::python
