#include "gl/driver_death.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <initializer_list>

namespace nullscope::gl {
namespace {

constexpr std::array<int, 5> kDeaths = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};

const char* program_name = "";
std::array<char, 200> driver{};  // empty: none is in use

// A signal handler may call little: write() is of that.
void say(const char* text) { [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text)); }

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
    if (driver[0] != '\0') {
        for (const char* part : std::initializer_list<const char*>{
                 program_name, ": ended by ", words_of(signal), " while the OpenGL driver was in use: ", driver.data(),
                 "; nullscope devices --measure tries every driver here\n"})
            say(part);
    }
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

}  // namespace

void remember_driver(const char* renderer, const char* version) {
    std::snprintf(driver.data(), driver.size(), "%s, OpenGL %s", renderer, version);
}

void name_driver_at_death(const char* program) {
    program_name = program;
#ifndef NULLSCOPE_SANITIZED
    for (const int signal : kDeaths) std::signal(signal, speak_and_die);
#endif
}

void leave_death_unnamed() {
    for (const int signal : kDeaths) std::signal(signal, SIG_DFL);
}

}  // namespace nullscope::gl
