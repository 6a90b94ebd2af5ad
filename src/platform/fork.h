// Work in processes of their own that go on from here, as copies of this one. Windows has none (can_fork()): there a crew consists of this program,
// started anew.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace nullscope::platform {

bool can_fork();

// A process that runs `run` and ends with the status that it returns. It ends (SIGTERM) when this one does, however that
// ends. -1: none could be made (errno). Where this process has threads, `run` may call only what a signal handler may.
long fork_child(const std::function<int()>& run);

// Waits for its end. Empty: status 0; else "exit status 3" or "Killed", the signal's name.
std::string end_of_child(long child);

// All of it, however often that takes; nothing where nobody reads any more.
void write_all(int descriptor, std::string_view bytes);

// What a child wrote before it ended, and how that was: as end_of_child, or "no end within 60 s".
struct ChildAnswer {
    std::string bytes, end;
};

// Runs `run` in a process of its own, which writes to the descriptor that it is given, and waits for it, at most limit_s seconds: then it is
// killed. For work that may take its process with it. Where no process can be forked it runs in a thread here: what takes its process with it
// takes this one, and the limit is none. Errors: no process could be made.
std::error_code answer_of_child(const std::function<int(int pipe)>& run, double limit_s, ChildAnswer& answer);

// Several such processes, which tell this one something. While there is one, the signals SIGINT, SIGTERM and SIGHUP are held back from this
// process, those that are not ignored, and are news.
class Crew {
public:
    Crew();
    ~Crew();  // ends them, those that are stopped too, and waits for it
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    // `run` in `count` processes, which end with the status that it returns and when this one does, however that ends. Where none can be forked each
    // is this program with its own command line, silent until it has come to this place by the same way: there it runs `run`, and start() does
    // not return. What it meets on its way must be as the first found it, and must be left so: is_member(). Errors: no process could be made.
    std::error_code start(int count, const std::function<int(int pipe)>& run);
    static bool is_member();  // this process is on that way
    struct News {
        std::size_t worker;
        std::string bytes;                 // that it wrote
        std::optional<std::string> end{};  // it ended: as end_of_child
    };
    // Waits until one has said something, or has ended, or a signal has come: its number then, and nothing else.
    std::optional<int> wait(std::vector<News>& news);
    int left() const;  // that have not ended
    void end();

private:
    struct Members;
    std::unique_ptr<Members> members_;
};

}  // namespace nullscope::platform
