// What the C++ runtime asks of threads: a module's only one never ends.
extern "C" int __cxa_thread_atexit(void (*)(void*), void*, void*) { return 0; }
