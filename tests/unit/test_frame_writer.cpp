// command/frame_writer.h: what is written at once, in what order it is told, and what an error does.
#include "command/frame_writer.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

using namespace nullscope;
using cli::FrameWriter;

namespace {

void wait_a_little(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

TEST_CASE("frame writer: frames are told in their order, and no more are written at once than asked for") {
    std::atomic<int> writing = 0, most = 0;
    std::vector<int> told;
    {
        FrameWriter writer(2);
        for (int frame = 0; frame < 7; ++frame)
            CHECK(writer.add(
                [&, frame] {
                    most = std::max(most.load(), ++writing);
                    wait_a_little(frame % 2 == 0 ? 8 : 1);  // later ones are ready first
                    --writing;
                    return Status(Done{});
                },
                [&, frame] { told.push_back(frame); }));
        CHECK(writer.finish());
    }
    CHECK(told == std::vector{0, 1, 2, 3, 4, 5, 6});
    CHECK(most.load() == 2);
}

TEST_CASE("frame writer: what cannot be written ends the sequence, and is not told as done") {
    std::vector<int> told;
    std::atomic<int> written = 0;
    FrameWriter writer(2);
    Status added = Done{};
    int frame = 0;
    for (; added && frame < 9; ++frame)
        added = writer.add(
            [&, frame]() -> Status {
                ++written;
                if (frame == 2) return failed("disk full");
                return Done{};
            },
            [&, frame] { told.push_back(frame); });
    REQUIRE_FALSE(added);
    CHECK(added.error().what == "disk full");
    CHECK(told == std::vector{0, 1});
    CHECK(writer.finish());  // frame 3 was begun before the error was known
    CHECK(written.load() == 4);
    CHECK(frame == 5);  // the fifth was refused
}

TEST_CASE("frame writer: memory bounds how many are written at once") {
    CHECK(cli::pictures_written_at_once(1, 1e12) == 1);
    CHECK(cli::pictures_written_at_once(1000, 1.0) == 1);
    CHECK(cli::pictures_written_at_once(1, 1.0) <= std::max(1u, std::thread::hardware_concurrency() / 2));
}

}  // namespace
