// No process goes on from where another is: what may run here as well does so, and a crew's processes are this program, started anew.
#include "platform/fork.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cwchar>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "platform/endings.h"
#include "platform/windows/start_process.h"

namespace nullscope::platform {
namespace {

// In the environment of a crew's process: the handles that it writes to, the crew's pipe and standard error (0: none).
constexpr const wchar_t* kPartName = L"NULLSCOPE_CREW";

struct Part {
    HANDLE pipe, errors;
};

HANDLE handle_of(std::uint64_t number) { return reinterpret_cast<HANDLE>(static_cast<std::uintptr_t>(number)); }

std::wstring text_of(const Part& part) {
    const auto number = [](HANDLE handle) { return std::to_wstring(reinterpret_cast<std::uintptr_t>(handle)); };
    return number(part.pipe) + L" " + number(part.errors);
}

// What this process has been given. Programs that it starts are given none.
const std::optional<Part>& own_part() {
    static const std::optional<Part> part = [] {
        std::array<wchar_t, 64> text{};
        const DWORD length = ::GetEnvironmentVariableW(kPartName, text.data(), static_cast<DWORD>(text.size()));
        ::SetEnvironmentVariableW(kPartName, nullptr);
        if (length == 0 || length >= text.size()) return std::optional<Part>();
        wchar_t* rest = nullptr;
        const HANDLE pipe = handle_of(std::wcstoull(text.data(), &rest, 10));
        const HANDLE errors = handle_of(std::wcstoull(rest, nullptr, 10));
        return ::GetFileType(pipe) == FILE_TYPE_PIPE ? std::optional(Part{pipe, errors}) : std::nullopt;
    }();
    return part;
}

// Until here it was silent: what goes before is what the other process has said.
[[noreturn]] void do_part(const Part& part, const std::function<int(int pipe)>& run) {
    if (part.errors != nullptr)
        if (const int errors = _open_osfhandle(reinterpret_cast<std::intptr_t>(part.errors), _O_TEXT); errors >= 0)
            _dup2(errors, 2);
    const int status = run(_open_osfhandle(reinterpret_cast<std::intptr_t>(part.pipe), _O_BINARY));
    end_at_once(status);
}

std::wstring own_file() {
    std::wstring file(MAX_PATH, L'\0');
    for (;; file.resize(2 * file.size()))
        if (const DWORD length = ::GetModuleFileNameW(nullptr, file.data(), static_cast<DWORD>(file.size()));
            length < file.size()) {
            file.resize(length);
            return file;
        }
}

struct Anew {
    HANDLE process = nullptr, pipe = nullptr;
    DWORD error = 0;
};

// This program with its own command line. pipe: what it tells.
Anew started_anew() {
    Anew made;
    Part part{};
    if (::CreatePipe(&made.pipe, &part.pipe, nullptr, 0) == 0) return {nullptr, nullptr, ::GetLastError()};
    const HANDLE here = ::GetCurrentProcess(), errors = ::GetStdHandle(STD_ERROR_HANDLE);
    if (errors == nullptr || errors == INVALID_HANDLE_VALUE ||
        ::DuplicateHandle(here, errors, here, &part.errors, 0, TRUE, DUPLICATE_SAME_ACCESS) == 0)
        part.errors = nullptr;
    ::SetEnvironmentVariableW(kPartName, text_of(part).c_str());
    std::vector<HANDLE> handles{part.pipe};
    if (part.errors != nullptr) handles.push_back(part.errors);
    const StartedProcess now = start_process(own_file().c_str(), ::GetCommandLineW(), nullptr, nullptr, handles);
    ::SetEnvironmentVariableW(kPartName, nullptr);
    for (const HANDLE handle : handles) ::CloseHandle(handle);
    if (now.error != 0) return ::CloseHandle(made.pipe), Anew{nullptr, nullptr, now.error};
    made.process = now.process;
    return made;
}

}  // namespace

bool can_fork() { return false; }

long fork_child(const std::function<int()>&) {
    errno = ENOSYS;
    return -1;
}

std::string end_of_child(long) { return "no such process"; }

void write_all(int descriptor, std::string_view bytes) {
    constexpr std::size_t kMostAtOnce = 1u << 20;
    while (!bytes.empty()) {
        const int count = _write(descriptor, bytes.data(), static_cast<unsigned>(std::min(bytes.size(), kMostAtOnce)));
        if (count < 0) return;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

std::error_code answer_of_child(const std::function<int(int pipe)>& run, double, ChildAnswer& answer) {
    std::array<int, 2> ends{};
    if (_pipe(ends.data(), 1u << 16, _O_BINARY | _O_NOINHERIT) != 0) return {errno, std::generic_category()};
    std::thread reader([&] {
        std::array<char, 65536> bytes;
        for (int count = 0; (count = _read(ends[0], bytes.data(), static_cast<unsigned>(bytes.size()))) > 0;)
            answer.bytes.append(bytes.data(), static_cast<std::size_t>(count));
    });
    const int status = run(ends[1]);
    _close(ends[1]);
    reader.join();
    _close(ends[0]);
    if (status != 0) answer.end = "exit status " + std::to_string(status);
    return {};
}

bool Crew::is_member() { return own_part().has_value(); }

struct Crew::Members {
    struct Member {
        HANDLE process = nullptr, pipe = nullptr;  // closed in end()
        bool ended = false;
        std::thread reader{};
    };
    std::mutex mutex;  // of `news`
    std::condition_variable told;
    std::vector<News> news;
    std::vector<std::unique_ptr<Member>> all;

    void tell(News one) {
        const std::lock_guard lock(mutex);
        news.push_back(std::move(one));
        told.notify_one();
    }
    void listen(std::size_t number, const Member& member) {
        std::array<char, 4096> bytes;
        for (DWORD count = 0;
             ::ReadFile(member.pipe, bytes.data(), static_cast<DWORD>(bytes.size()), &count, nullptr) != 0;)
            tell({number, std::string(bytes.data(), count)});
        ::WaitForSingleObject(member.process, INFINITE);
        DWORD status = 0;
        ::GetExitCodeProcess(member.process, &status);
        tell({number, "", status == 0 ? "" : "exit status " + std::to_string(static_cast<int>(status))});
    }
};

Crew::Crew() : members_(std::make_unique<Members>()) {}
Crew::~Crew() { end(); }

std::error_code Crew::start(int count, const std::function<int(int pipe)>& run) {
    if (const auto part = own_part()) do_part(*part, run);
    for (int i = 0; i < count; ++i) {
        const Anew now = started_anew();
        if (now.error != 0) return {static_cast<int>(now.error), std::system_category()};
        auto& member = *members_->all.emplace_back(std::make_unique<Members::Member>());
        member.process = now.process, member.pipe = now.pipe;
        member.reader =
            std::thread([this, number = static_cast<std::size_t>(i), &member] { members_->listen(number, member); });
    }
    return {};
}

// No signal comes: Ctrl+C ends this process, and that those of the crew.
std::optional<int> Crew::wait(std::vector<News>& news) {
    std::unique_lock lock(members_->mutex);
    members_->told.wait(lock, [this] { return !members_->news.empty(); });
    news = std::exchange(members_->news, {});
    for (const News& one : news)
        if (one.end) members_->all[one.worker]->ended = true;
    return std::nullopt;
}

int Crew::left() const {
    return static_cast<int>(std::ranges::count_if(members_->all, [](const auto& m) { return !m->ended; }));
}

void Crew::end() {
    for (const auto& member : members_->all) ::TerminateProcess(member->process, 1);
    for (const auto& member : members_->all) {
        member->reader.join();
        ::CloseHandle(member->process), ::CloseHandle(member->pipe);
    }
    members_->all.clear();
    members_->news.clear();
}

}  // namespace nullscope::platform
