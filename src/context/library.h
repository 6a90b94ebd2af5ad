// A shared library opened at run time, kept until the program ends (drivers do not survive being closed).
#pragma once
#include <dlfcn.h>

#include <initializer_list>

namespace nullscope {

inline void* open_library(std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
    return nullptr;
}

template <class F>
bool load_symbol(void* library, const char* name, F& function) {
    function = reinterpret_cast<F>(dlsym(library, name));
    return function != nullptr;
}

}  // namespace nullscope
