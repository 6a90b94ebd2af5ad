# Writes OUTPUT, the C++ file behind version.h, unless it says so already. VERSION; SOURCE: the source tree, a repository or not.
set(text ${VERSION})
find_package(Git QUIET)
if(GIT_FOUND AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} rev-parse --short=12 HEAD
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} --no-optional-locks status --porcelain --untracked-files=no
                  OUTPUT_VARIABLE changed ERROR_QUIET)
  if(commit AND changed)
    string(APPEND commit ", changed")
  endif()
  if(commit)
    set(text "${VERSION} (${commit})")
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[
#include "version/version.h"

namespace nullscope {

const char* const kVersion = "@VERSION@";
const char* const kVersionText = "@text@";

}  // namespace nullscope
]] @ONLY)
