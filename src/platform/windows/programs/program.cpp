// nullscope.exe and nullscope-viewer.exe: both programs are in one library beside them, which is half of what two whole ones take. This file is
// compiled for each of them; NULLSCOPE_RUN is the name under which the library has its main().
#include <windows.h>

#include <cstdio>

__declspec(dllimport) int NULLSCOPE_RUN(int count, char** words);

// What the library holds at its end is not taken apart: Windows would do so after it has ended all threads but this one, and what waits for
// another would wait for ever.
int main(int count, char** words) {
    const int status = NULLSCOPE_RUN(count, words);
    std::fflush(nullptr);
    ::TerminateProcess(::GetCurrentProcess(), static_cast<UINT>(status));
    return status;
}
