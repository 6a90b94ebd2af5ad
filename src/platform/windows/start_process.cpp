#include "platform/windows/start_process.h"

#include <algorithm>
#include <cstddef>

namespace nullscope::platform {
namespace {

HANDLE own_job() {
    static const HANDLE job = [] {
        const HANDLE made = ::CreateJobObjectW(nullptr, nullptr);
        JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
        limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
        ::SetInformationJobObject(made, JobObjectExtendedLimitInformation, &limits, sizeof limits);
        return made;
    }();
    return job;
}

// Names the handles that a process inherits, and no others: what is open here for writing would stay open there.
class Inherited {
public:
    explicit Inherited(std::vector<HANDLE> handles) : handles_(std::move(handles)) {
        std::ranges::sort(handles_);
        handles_.erase(std::unique(handles_.begin(), handles_.end()), handles_.end());
        for (const HANDLE handle : handles_) ::SetHandleInformation(handle, HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT);
        SIZE_T size = 0;
        ::InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
        room_.resize(size);
        ::InitializeProcThreadAttributeList(list(), 1, 0, &size);
        ::UpdateProcThreadAttribute(list(), 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, handles_.data(),
                                    handles_.size() * sizeof(HANDLE), nullptr, nullptr);
    }
    ~Inherited() { ::DeleteProcThreadAttributeList(list()); }
    Inherited(const Inherited&) = delete;
    Inherited& operator=(const Inherited&) = delete;
    LPPROC_THREAD_ATTRIBUTE_LIST list() { return reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(room_.data()); }

private:
    std::vector<HANDLE> handles_;
    std::vector<std::byte> room_;
};

}  // namespace

StartedProcess start_process(const wchar_t* program, std::wstring line, HANDLE output, HANDLE errors,
                             const std::vector<HANDLE>& more) {
    const HANDLE nothing = ::CreateFileW(L"NUL", GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE,
                                         nullptr, OPEN_EXISTING, 0, nullptr);
    STARTUPINFOEXW begin{};
    STARTUPINFOW& streams = begin.StartupInfo;
    streams.cb = sizeof begin;
    streams.dwFlags = STARTF_USESTDHANDLES;
    streams.hStdInput = nothing;
    streams.hStdOutput = output != nullptr ? output : nothing;
    streams.hStdError = errors != nullptr ? errors : nothing;
    std::vector<HANDLE> handles{nothing, streams.hStdOutput, streams.hStdError};
    handles.insert(handles.end(), more.begin(), more.end());
    Inherited inherited(std::move(handles));
    begin.lpAttributeList = inherited.list();
    PROCESS_INFORMATION made{};
    const BOOL runs = ::CreateProcessW(program, line.data(), nullptr, nullptr, TRUE,
                                       CREATE_NO_WINDOW | CREATE_SUSPENDED | EXTENDED_STARTUPINFO_PRESENT, nullptr,
                                       nullptr, &streams, &made);
    const DWORD error = runs != 0 ? 0 : ::GetLastError();
    ::CloseHandle(nothing);
    if (runs == 0) return {nullptr, error};
    const bool ends_with_this = ::AssignProcessToJobObject(own_job(), made.hProcess) != 0;
    const DWORD why_not = ends_with_this ? 0 : ::GetLastError();
    if (ends_with_this)
        ::ResumeThread(made.hThread);
    else
        ::TerminateProcess(made.hProcess, 1), ::CloseHandle(made.hProcess);
    ::CloseHandle(made.hThread);
    return {ends_with_this ? made.hProcess : nullptr, why_not};
}

}  // namespace nullscope::platform
