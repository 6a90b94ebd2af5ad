#include "gl/driver_death.h"

#include <array>
#include <cstdio>
#include <initializer_list>

#include "platform/console.h"
#include "platform/endings.h"

namespace nullscope::gl {
namespace {

const char* program_name = "";
std::array<char, 200> driver{};  // empty: none is in use

void speak(const char* fault) {
    if (driver[0] == '\0') return;
    for (const char* part : std::initializer_list<const char*>{
             program_name, ": ended by ", fault, " while the OpenGL driver was in use: ", driver.data(),
             "; nullscope devices --measure tries every driver here\n"})
        platform::write_error(part);
}

}  // namespace

void remember_driver(const char* renderer, const char* version) {
    std::snprintf(driver.data(), driver.size(), "%s, OpenGL %s", renderer, version);
}

void name_driver_at_death(const char* program) {
    program_name = program;
#ifndef NULLSCOPE_SANITIZED
    platform::before_faults(speak);
#endif
}

void leave_death_unnamed() { platform::leave_faults(); }

}  // namespace nullscope::gl
