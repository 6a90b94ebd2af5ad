// What is asked of the system, on this one.
#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <thread>

#include "platform/file_lock.h"
#include "platform/places.h"
#include "platform/process.h"
#include "platform/sha256.h"
#include "platform/usage.h"
#include "support/temporary_folder.h"

using namespace nullscope;
using platform::LockFile;
using Kind = platform::LockFile::Kind;

TEST_CASE("platform: locks of two that have one file open keep each other out, byte by byte") {
    const TemporaryFolder folder("platform");
    const std::string file = (folder.path / "stamp").string();
    LockFile first, second;
    REQUIRE(!first.open(file, LockFile::Kept::kLeft));
    REQUIRE(!second.open(file, LockFile::Kept::kHere));
    REQUIRE(!first.set(Kind::kExclusive, 0));
    CHECK(second.set(Kind::kShared, 0) == std::errc::resource_unavailable_try_again);
    CHECK(!second.set(Kind::kExclusive, 7));
    REQUIRE(!first.set(Kind::kShared, 0));
    CHECK(!second.set(Kind::kShared, 0));
    CHECK(first.set(Kind::kExclusive, 0) == std::errc::resource_unavailable_try_again);
    second.close();
    CHECK(!first.set(Kind::kExclusive, 0));
    std::ofstream(file, std::ios::trunc) << "text under a lock";
    CHECK(first.is_as_old_as(file));
    CHECK_FALSE(first.is_as_old_as(file + "-not-there"));
    CHECK(first.has_its_name());
    first.remove_and_close();
    CHECK_FALSE(std::ifstream(file).good());
}

TEST_CASE("platform: a program that is not there cannot be run, this one is") {
    CHECK_FALSE(platform::run_program({"no-such-program-of-anybody"}).found);
    const std::string self = platform::program_file().string();
    REQUIRE_FALSE(self.empty());
    const platform::Ran ran =
        platform::run_program({self, "--no-version", "--list-test-cases", "-tc=no such \"case\""});
    CHECK(ran.found);
    CHECK(ran.how.empty());
    platform::Program program;
    REQUIRE(program.start({self, "--no-version", "--count", "-tc=no such case"}).empty());
    std::optional<int> status;
    while (!(status = program.poll())) std::this_thread::yield();
    CHECK(*status == 0);
    CHECK(program.read().find("[doctest]") != std::string::npos);
    CHECK(platform::is_running(platform::process_id()));
}

TEST_CASE("platform: SHA-256 of \"abc\" is that of FIPS 180-4, processor time passes") {
    platform::Sha256 hash;
    hash.add("a"), hash.add("bc");
    const auto digest = hash.digest();
    REQUIRE(digest);
    CHECK((*digest)[0] == 0xba);
    CHECK((*digest)[1] == 0x78);
    CHECK((*digest)[31] == 0xad);
    const double before = platform::thread_cpu_seconds();
    while (platform::thread_cpu_seconds() < before + 1e-3) {
    }
    CHECK(platform::process_cpu_seconds() >= platform::thread_cpu_seconds());
    CHECK(platform::process_seconds() > 0);
    CHECK(platform::resident_bytes() > 1e6);
}
