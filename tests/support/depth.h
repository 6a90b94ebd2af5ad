// How much a test measures.
//
// The environment variable NULLSCOPE_TESTS says it:
//   quick        what every change must pass: each promise on the cases that show its breach. scripts/test.sh
//   all          the same promises on every case, and on both contexts what a context may change. scripts/test.sh --all,
//                continuous integration
//   everything   every pixel of every frame, too: hours
// Unset or another word: quick. (NULLSCOPE_EVERYTHING, set to anything, means everything.)
#pragma once
#include <cstdlib>
#include <string_view>

namespace nullscope::test {

enum class Depth { kQuick, kAll, kEverything };

inline Depth depth() {
    const auto word = [](const char* name) {  // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody sets it meanwhile
        const char* value = std::getenv(name);
        return std::string_view(value != nullptr ? value : "");
    };
    if (!word("NULLSCOPE_EVERYTHING").empty() || word("NULLSCOPE_TESTS") == "everything") return Depth::kEverything;
    return word("NULLSCOPE_TESTS") == "all" ? Depth::kAll : Depth::kQuick;
}

// One of three numbers, by depth.
template <class T>
T by_depth(T quick, T all, T everything) {
    return depth() == Depth::kQuick ? quick : depth() == Depth::kAll ? all : everything;
}

// Which cases of a list a test measures: all; at quick depth every step-th, the first among them.
class Selection {
public:
    explicit Selection(int quick_step) : step_(by_depth(quick_step, 1, 1)) {}
    bool takes_next() { return number_++ % step_ == 0; }

private:
    int step_, number_ = 0;
};

inline bool everything_asked() { return depth() == Depth::kEverything; }

}  // namespace nullscope::test
