// Processor time, memory and priority of this process.
#pragma once

namespace nullscope::platform {

double
process_seconds();  // since the process began, by a clock that never stands still; where the system does not say: since the first call
double process_cpu_seconds();  // of all threads
double thread_cpu_seconds();
double resident_bytes();  // of the process, in memory
void give_way();  // this thread runs after others; the rest of the process too where threads have no priority of their own
// One heap that gives back what is free, so that resident_bytes() is what is held, not where a heap of several threads has its gaps.
void tighten_heap();

}  // namespace nullscope::platform
