// libc++ for wasm32 has no threads. What src/ names of them: locks hold nobody up, and a task is done when its result is
// wanted.
// Included before every file (web/CMakeLists.txt).
#pragma once
#ifdef __cplusplus
#include <functional>
#include <future>
#include <mutex>
#include <utility>

_LIBCPP_BEGIN_NAMESPACE_STD

class mutex {
public:
    void lock() {}
    void unlock() {}
};

template <class Mutex>
class unique_lock {
public:
    unique_lock(Mutex&, try_to_lock_t) {}
    explicit operator bool() const { return true; }
};

enum class launch { async };

template <class Value>
class future {
public:
    explicit future(std::function<Value()> task) : task_(std::move(task)) {}
    Value get() { return task_(); }

private:
    std::function<Value()> task_;
};

template <class Task>
auto async(launch, Task task) {
    return future<decltype(task())>(std::move(task));
}

_LIBCPP_END_NAMESPACE_STD
#endif
