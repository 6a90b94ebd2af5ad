// What the reference said is said again only for the same question, by the same code, from a file that is whole.
#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "scene/ray.h"
#include "support/folders.h"
#include "support/reference_memory.h"

using namespace nullscope;
using namespace nullscope::test;

TEST_CASE("reference memory: kept by question and code, never from a damaged file") {
    const std::filesystem::path top = reports_folder() / "reference-memory-test";
    std::filesystem::remove_all(top);
    int computed = 0;
    const auto compute = [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));  // worth keeping
        std::vector<RayPixel> pixels(3);
        pixels[1].g = ++computed;
        return pixels;
    };
    const auto ask = [&](const char* code, const std::string& question) {
        return ReferenceMemory(top / code).answer<RayPixel>(question, compute)[1].g;
    };
    CHECK(ask("a", "one") == 1);
    CHECK(ask("a", "one") == 1);
    CHECK(ask("a", "other") == 2);
    CHECK(ask("a", "one") == 1);
    int damaged = 0;
    for (const auto& file : std::filesystem::directory_iterator(top / "a")) {
        std::fstream bytes(file.path(), std::ios::in | std::ios::out | std::ios::binary);
        bytes.seekp(40 + damaged++);
        bytes.put('x');
    }
    CHECK(damaged == 2);
    CHECK(ask("a", "one") == 3);
    for (const auto& file : std::filesystem::directory_iterator(top / "a"))
        std::filesystem::resize_file(file.path(), std::filesystem::file_size(file.path()) - 1);
    CHECK(ask("a", "one") == 4);
    CHECK(ask("b", "one") == 5);  // other code, and what the first said is gone
    CHECK_FALSE(std::filesystem::exists(top / "a"));
    CHECK(ReferenceMemory({}).answer<RayPixel>("one", compute)[1].g == 6);  // nothing is kept
    std::filesystem::remove_all(top);
}
