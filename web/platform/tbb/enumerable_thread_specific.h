// One thread: its own copy is the only one.
#pragma once
namespace tbb {

template <class Value>
class enumerable_thread_specific {
public:
    Value& local() { return value_; }

private:
    Value value_;
};

}  // namespace tbb
