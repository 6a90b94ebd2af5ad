// How the page calls: numbers as they are; text as a place and a size in the module's memory; text comes back as the answer, which the next
// call that has one replaces.
#pragma once
#include <string>
#include <string_view>

#include "base/result.h"

#ifdef __wasm__
#define NULLSCOPE_EXPORT(name) extern "C" __attribute__((export_name(#name)))
#else
#define NULLSCOPE_EXPORT(name) extern "C"  // for tests, which compare with this machine's own answers
#endif

namespace nullscope::web {

std::string& answer();
bool answer(std::string text);               // true
bool answer(const Status& status);           // nothing; true, or its error's line; false
std::string in_json(std::string_view text);  // as JSON has it

}  // namespace nullscope::web
