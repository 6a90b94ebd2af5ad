// No process goes on from where another is: what may run here as well does so.
#include "platform/fork.h"

#include <fcntl.h>
#include <io.h>

#include <array>
#include <cerrno>
#include <thread>

namespace nullscope::platform {

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

struct Crew::Members {};
Crew::Crew() = default;
Crew::~Crew() = default;
std::error_code Crew::start(int, const std::function<int(int)>&) {
    return std::make_error_code(std::errc::function_not_supported);
}
std::optional<int> Crew::wait(std::vector<News>& news) { return news.clear(), std::nullopt; }
int Crew::left() const { return 0; }
void Crew::end() {}

}  // namespace nullscope::platform
