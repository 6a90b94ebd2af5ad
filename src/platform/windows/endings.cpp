#include "platform/endings.h"

#include <windows.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace nullscope::platform {
namespace {

std::atomic<void (*)()> clean_up_at_end{nullptr};
std::atomic<void (*)(const char*)> say_fault{nullptr};

BOOL WINAPI clean_up_and_end(DWORD) {
    if (auto* const clean_up = clean_up_at_end.load()) clean_up();
    return FALSE;  // the system's own handler ends the process
}

const char* words_of(DWORD fault) {
    switch (fault) {
        case EXCEPTION_ACCESS_VIOLATION: return "a segmentation fault";
        case EXCEPTION_STACK_OVERFLOW: return "a stack overflow";
        case EXCEPTION_ILLEGAL_INSTRUCTION: return "an illegal instruction";
        default: return "a fault";
    }
}

LONG WINAPI speak_and_die(EXCEPTION_POINTERS* fault) {
    if (auto* const say = say_fault.load()) say(words_of(fault->ExceptionRecord->ExceptionCode));
    return EXCEPTION_CONTINUE_SEARCH;
}

extern "C" void speak_at_abort(int) {
    if (auto* const say = say_fault.load()) say("abort()");
}

}  // namespace

void before_ending(void (*clean_up)()) {
    clean_up_at_end = clean_up;
    ::SetConsoleCtrlHandler(clean_up_and_end, TRUE);
}

void remove_file_at_end(const char* path) { std::remove(path); }

void make_size_limits_errors() {}  // there are none

void before_faults(void (*say)(const char*)) {
    say_fault = say;
    ::SetUnhandledExceptionFilter(speak_and_die);
    std::signal(SIGABRT, speak_at_abort);
}

void leave_faults() {
    say_fault = nullptr;
    std::signal(SIGABRT, SIG_DFL);
}

void end_at_once(int status) {
    std::fflush(nullptr);
    ::TerminateProcess(::GetCurrentProcess(), static_cast<UINT>(status));
    std::abort();  // it does not come back
}

bool threads_end_together() { return false; }

}  // namespace nullscope::platform
