#include "platform/process.h"

#include <windows.h>

#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include "platform/windows/start_process.h"

namespace nullscope::platform {
namespace {

HANDLE process_handle(long long handle) { return reinterpret_cast<HANDLE>(handle); }

// One command line, as the programs' runtime takes it apart again (Microsoft, "Parsing C command-line arguments").
std::wstring command_line(const std::vector<std::string>& words) {
    std::wstring line;
    for (const std::string& word : words) {
        line += line.empty() ? L"\"" : L" \"";
        std::size_t slashes = 0;
        for (const wchar_t c : std::filesystem::path(word).wstring()) {
            if (c == L'"') line.append(slashes + 1, L'\\');
            slashes = c == L'\\' ? slashes + 1 : 0;
            line += c;
        }
        line.append(slashes, L'\\');
        line += L'"';
    }
    return line;
}

// What it writes to standard error is read from `output`; to standard output too, or it is lost.
struct Watched {
    HANDLE process = nullptr, output = nullptr;
    DWORD error = 0;
};
Watched started(const std::vector<std::string>& words, bool text_too) {
    Watched result;
    HANDLE write = nullptr;
    if (::CreatePipe(&result.output, &write, nullptr, 0) == 0) return {nullptr, nullptr, ::GetLastError()};
    const StartedProcess now = start_process(nullptr, command_line(words), text_too ? write : nullptr, write);
    ::CloseHandle(write);
    if (now.error != 0) ::CloseHandle(result.output), result.output = nullptr;
    result.process = now.process, result.error = now.error;
    return result;
}

}  // namespace

int process_id() { return static_cast<int>(::GetCurrentProcessId()); }

bool is_running(int process) {
    const HANDLE handle = ::OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, static_cast<DWORD>(process));
    if (handle == nullptr) return ::GetLastError() == ERROR_ACCESS_DENIED;
    DWORD status = 0;
    const bool runs = ::GetExitCodeProcess(handle, &status) != 0 && status == STILL_ACTIVE;
    ::CloseHandle(handle);
    return runs;
}

std::string Program::start(std::vector<std::string> words) {
    end();
    said_.clear();
    const Watched now = started(words, true);
    if (now.error != 0) return words.front() + ": " + std::system_category().message(static_cast<int>(now.error));
    process_ = reinterpret_cast<long long>(now.process), output_ = reinterpret_cast<long long>(now.output);
    return "";
}

void Program::give_way() const { ::SetPriorityClass(process_handle(process_), BELOW_NORMAL_PRIORITY_CLASS); }

void Program::take_output() {
    std::array<char, 4096> bytes;
    for (DWORD there = 0, count = 0; output_ != -1; said_.append(bytes.data(), count))
        if (::PeekNamedPipe(process_handle(output_), nullptr, 0, nullptr, &there, nullptr) == 0 || there == 0 ||
            ::ReadFile(process_handle(output_), bytes.data(), static_cast<DWORD>(bytes.size()), &count, nullptr) == 0)
            return;
}

void Program::close_output() { ::CloseHandle(process_handle(std::exchange(output_, -1))); }

std::string Program::read() {
    take_output();
    return std::exchange(said_, {});
}

std::optional<int> Program::poll() {
    if (process_ == 0 || ::WaitForSingleObject(process_handle(process_), 0) != WAIT_OBJECT_0) return std::nullopt;
    DWORD status = 0;
    ::GetExitCodeProcess(process_handle(process_), &status);
    take_output();
    close_output();
    ::CloseHandle(process_handle(std::exchange(process_, 0)));
    return static_cast<int>(status);
}

void Program::end() {
    if (process_ == 0) return;
    ::TerminateProcess(process_handle(process_), 1);
    ::WaitForSingleObject(process_handle(process_), INFINITE);
    close_output();
    ::CloseHandle(process_handle(std::exchange(process_, 0)));
}

Ran run_program(std::vector<std::string> words) {
    const Watched now = started(words, false);
    if (now.error != 0)
        return {std::system_category().message(static_cast<int>(now.error)), "",
                now.error != ERROR_FILE_NOT_FOUND && now.error != ERROR_PATH_NOT_FOUND};
    std::string text;
    std::array<char, 4096> bytes;
    for (DWORD count = 0;
         ::ReadFile(now.output, bytes.data(), static_cast<DWORD>(bytes.size()), &count, nullptr) != 0 && count > 0;)
        if (text.find('\n') == std::string::npos) text.append(bytes.data(), count);
    ::CloseHandle(now.output);
    ::WaitForSingleObject(now.process, INFINITE);
    DWORD status = 0;
    ::GetExitCodeProcess(now.process, &status);
    ::CloseHandle(now.process);
    return {status == 0 ? "" : "exit status " + std::to_string(static_cast<int>(status)),
            text.substr(0, text.find('\n'))};
}

}  // namespace nullscope::platform
