// A process of Windows that ends with this one.
#pragma once
#include <windows.h>

#include <string>
#include <vector>

namespace nullscope::platform {

struct StartedProcess {
    HANDLE process = nullptr;
    DWORD error = 0;  // of the system; then there is no process
};

// program: its file; null: the first word of `line`, its command line, says it, by PATH too. output, errors: what it writes to, null: nowhere; it
// reads nothing. more: other handles that it has under the same numbers; it has none besides. It is in a job that is killed with the last handle
// to it, which is this process's own: it ends when this process does, however that ends.
StartedProcess start_process(const wchar_t* program, std::wstring line, HANDLE output, HANDLE errors,
                             const std::vector<HANDLE>& more = {});

}  // namespace nullscope::platform
