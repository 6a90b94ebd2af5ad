// How a process ends that does not return from main().
#pragma once

namespace nullscope::platform {

// For main(), once: where the process is asked to end (SIGINT, SIGTERM, SIGHUP; on Windows Ctrl+C, a closed console, the end of the session),
// clean_up is called first, and the process ends as it would have without. A signal that is ignored stays so. clean_up: a signal handler's
// code (on Windows it runs in a thread of its own).
void before_ending(void (*clean_up)());

// For clean_up. Windows keeps a file that is still open.
void remove_file_at_end(const char* path);

// A file that grows beyond a limit of the system's becomes an error of writing.
void make_size_limits_errors();

// Where the process dies by a fault of memory, of arithmetic, or by abort(), say("a segmentation fault") is called before it ends as it would
// have. say: a signal handler's code.
void before_faults(void (*say)(const char* fault));
void leave_faults();  // no longer

// Without taking anything apart; what stdio holds is written first. On Windows threads and libraries are not asked either: after all threads but one have
// ended there, what waits for another would wait for ever.
[[noreturn]] void end_at_once(int status);

// Whether threads that end at one time always do. Not on Windows: the thread that has used TBB and TBB's own, which end with it, wait for each other, one with
// the lock of winpthreads' keys and one with the loader's. Who has nothing left to do ends at once there.
bool threads_end_together();

}  // namespace nullscope::platform
