# CMake's toolchain for Windows, from another machine: scripts/windows.sh. NULLSCOPE_WINDOWS_PREFIX in the environment: where its libraries lie.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_PREFIX_PATH $ENV{NULLSCOPE_WINDOWS_PREFIX})
set(CMAKE_FIND_ROOT_PATH ${CMAKE_PREFIX_PATH} /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)   # programs are this machine's
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(PKG_CONFIG_ARGN --static)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)       # no DLL but the system's, and one of ours
set(CMAKE_SHARED_LINKER_FLAGS_INIT -static)
# The constants of <math.h> that C++ of no dialect leaves out there; Windows 10; windows.h without macros for common words.
set(system_definitions "-D_USE_MATH_DEFINES -D_WIN32_WINNT=0x0A00 -DNOMINMAX -DWIN32_LEAN_AND_MEAN")
set(CMAKE_C_FLAGS_INIT ${system_definitions})
# For Windows g++ takes the inline function that it sees for the one that will be linked, and keeps values in registers that this one leaves
# alone; the linker may choose another file's, compiled with other options, which does not. fmt's integers were written so with wrong digits.
set(CMAKE_CXX_FLAGS_INIT "${system_definitions} -fno-ipa-ra")
set(CMAKE_CROSSCOMPILING_EMULATOR env WINEDEBUG=-all wine)   # the build's own generator of code
