// Work in processes of their own: what they say, and how they end.
#include <doctest/doctest.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "command/child.h"

using namespace nullscope;
using namespace nullscope::cli;

TEST_CASE("child: what a process says arrives whole, and its end is known") {
    const std::string long_text(1 << 20, 'x');  // more than a pipe holds
    const auto said = answer_of_child([&](int pipe) { return write_all(pipe, long_text), 0; }, 60);
    REQUIRE(said);
    CHECK(said->bytes == long_text);
    CHECK(said->end.empty());
    const auto refused = answer_of_child([](int) { return 3; }, 60);
    REQUIRE(refused);
    CHECK(refused->end == "exit status 3");
}

TEST_CASE("child: one that dies or does not end takes nothing with it") {
    const auto died = answer_of_child(
        [](int pipe) {
            write_all(pipe, "begun");
            std::signal(SIGSEGV, SIG_DFL);  // sanitizers have their own
            ::raise(SIGSEGV);
            return 0;
        },
        60);
    REQUIRE(died);
    CHECK(died->bytes == "begun");
    CHECK(died->end == "Segmentation fault");
    const auto waits = answer_of_child([](int) { return static_cast<int>(::sleep(600)); }, 0.2);
    REQUIRE(waits);
    CHECK(waits->end == "no end within 0.2 s");
}
