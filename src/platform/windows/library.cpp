#include "platform/library.h"

#include <windows.h>

namespace nullscope::platform {

void* open_library(std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (HMODULE library = ::LoadLibraryA(name)) return library;
    return nullptr;
}

void* symbol_of(void* library, const char* name) {
    return reinterpret_cast<void*>(::GetProcAddress(static_cast<HMODULE>(library), name));
}

}  // namespace nullscope::platform
