// A shared library opened at run time, kept until the program ends (drivers do not survive being closed).
#pragma once
#include <initializer_list>

namespace nullscope::platform {

void* open_library(std::initializer_list<const char*> names);  // the first that there is; null: none
void* symbol_of(void* library, const char* name);              // null: it has none of that name

template <class F>
bool load_symbol(void* library, const char* name, F& function) {
    function = reinterpret_cast<F>(symbol_of(library, name));
    return function != nullptr;
}

}  // namespace nullscope::platform
