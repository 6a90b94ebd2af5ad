#include "platform/endings.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace nullscope::platform {
namespace {

constexpr std::array<int, 5> kFaults = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};

std::atomic<void (*)()> clean_up_at_end{nullptr};
std::atomic<void (*)(const char*)> say_fault{nullptr};
static_assert(std::atomic<void (*)()>::is_always_lock_free, "a handler may not wait");

// Not by SA_RESETHAND: a second signal, to another thread, would end the process before it is cleaned up.
void end_by(int signal) {
    std::signal(signal, SIG_DFL);
    ::raise(signal);  // the process ends by the signal itself once the handler returns
}

extern "C" void clean_up_and_end(int signal) {
    if (auto* const clean_up = clean_up_at_end.load()) clean_up();
    end_by(signal);
}

const char* words_of(int signal) {
    switch (signal) {
        case SIGSEGV: return "a segmentation fault";
        case SIGBUS: return "a bus error";
        case SIGILL: return "an illegal instruction";
        case SIGFPE: return "an arithmetic fault";
        default: return "abort()";
    }
}

extern "C" void speak_and_die(int signal) {
    if (auto* const say = say_fault.load()) say(words_of(signal));
    end_by(signal);
}

}  // namespace

void before_ending(void (*clean_up)()) {
    clean_up_at_end = clean_up;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action {};
        if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
        action.sa_handler = clean_up_and_end;
        ::sigaction(signal, &action, nullptr);
    }
}

void remove_file_at_end(const char* path) { ::unlink(path); }

void make_size_limits_errors() { std::signal(SIGXFSZ, SIG_IGN); }

void before_faults(void (*say)(const char*)) {
    say_fault = say;
    for (const int signal : kFaults) std::signal(signal, speak_and_die);
}

void leave_faults() {
    for (const int signal : kFaults) std::signal(signal, SIG_DFL);
}

void end_at_once(int status) {
    std::fflush(nullptr);
    std::_Exit(status);
}

bool threads_end_together() { return true; }

}  // namespace nullscope::platform
