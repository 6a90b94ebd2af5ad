// Drivers run in the program's own process: where one fails in itself, the program ends by a signal. This says a word before it does.
#pragma once

namespace nullscope::gl {

// For main(): where the process dies by a fault of memory, of arithmetic or by abort(), standard error gets a line with the driver that was
// in use (that of the last load_functions()), before it ends as it would have. Without a driver, and under sanitizers, nothing is changed.
// program: stays valid.
void name_driver_at_death(const char* program);
void leave_death_unnamed();  // of a process whose parent says it

// What desktop.cpp tells it. Cut off after 200 bytes.
void remember_driver(const char* renderer, const char* version);

}  // namespace nullscope::gl
