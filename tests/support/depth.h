// How much a test measures. Depth belongs to a test's file.
//
// The environment variable NULLSCOPE_TESTS says it:
//   quick             what every change must pass: each promise on the cases that show its breach, of costly ones an eighth. scripts/test.sh
//   all               the same promises on every case. scripts/test.sh --all
//   everything        every pixel of every frame, too: hours
//   gpu/test_a.cpp,cli/test_b.py   these files as with all, the others quick. scripts/test.sh --turn (tests/turn.py)
// Unset: quick. (NULLSCOPE_EVERYTHING, set to anything, means everything.) tests/depth.py is the same for Python.
#pragma once
#include <cstdlib>
#include <string>
#include <string_view>

namespace nullscope::test {

enum class Depth { kQuick, kAll, kEverything };

inline std::string_view environment_word(const char* name) {
    const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets it meanwhile
    return value != nullptr ? value : "";
}

// Whether a list with commas names a file: by its folder and name, the end of the file's path.
inline bool lists(std::string_view names, std::string_view file) {
    while (!names.empty()) {
        const std::string_view name = names.substr(0, names.find(','));
        if (!name.empty() && file.ends_with(name) &&
            (file.size() == name.size() || file[file.size() - name.size() - 1] == '/'))
            return true;
        names.remove_prefix(name.size() == names.size() ? name.size() : name.size() + 1);
    }
    return false;
}

// That of the file that asks. Helpers in headers take their caller's.
inline Depth depth(const char* file = __builtin_FILE()) {
    const std::string_view asked = environment_word("NULLSCOPE_TESTS");
    if (!environment_word("NULLSCOPE_EVERYTHING").empty() || asked == "everything") return Depth::kEverything;
    return asked == "all" || lists(asked, file) ? Depth::kAll : Depth::kQuick;
}

// One of three numbers, by depth.
template <class T>
T by_depth(T quick, T all, T everything, const char* file = __builtin_FILE()) {
    const Depth asked = depth(file);
    return asked == Depth::kQuick ? quick : asked == Depth::kAll ? all : everything;
}

// Costly cases take more than some 0.7 base seconds at quick depth. That depth runs an eighth of them, chosen by NULLSCOPE_RUN, which in
// continuous integration is the number of the turn: eight turns run each. Without NULLSCOPE_RUN all are run.
inline constexpr int kCostlyParts = 8;

// number: of the program's costly cases.
inline bool is_of_another_run(int number, std::string_view run) {
    return !run.empty() && number % kCostlyParts != std::atoll(std::string(run).c_str()) % kCostlyParts;
}

inline bool left_to_another_run(const char* file) {
    static int number = 0;
    const int own = number++;
    return depth(file) == Depth::kQuick && is_of_another_run(own, environment_word("NULLSCOPE_RUN"));
}

// Which cases of a list a test measures: all; at quick depth every step-th, the first among them.
class Selection {
public:
    explicit Selection(int quick_step, const char* file = __builtin_FILE()) : step_(by_depth(quick_step, 1, 1, file)) {}
    bool takes_next() { return number_++ % step_ == 0; }

private:
    int step_, number_ = 0;
};

inline bool everything_asked() { return depth() == Depth::kEverything; }

}  // namespace nullscope::test
