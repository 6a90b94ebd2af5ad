#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "base/progress.h"
#include "support/temporary_folder.h"

using namespace nullscope;
namespace fs = std::filesystem;

namespace {

// Limits the size of the files this process may write: the disk-full of a unit test.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int);
};

}  // namespace

TEST_CASE("text files: round trip, replacement, the temporary name lies beside the target") {
    const TemporaryFolder folder("files");
    const fs::path file = folder.path / "a.txt";
    const std::string text("one\0two\r\n", 9);
    REQUIRE(write_text_atomically(file, text));
    CHECK(*read_text(file) == text);
    REQUIRE(write_text_atomically(file, ""));
    CHECK(read_text(file)->empty());
    fs::path seen;
    REQUIRE(write_atomically(file, [&](const fs::path& path) -> Status {
        seen = path;
        std::ofstream(path) << "new";
        CHECK(read_text(file)->empty());  // still the old one
        return Done{};
    }));
    CHECK(seen.parent_path() == folder.path);
    CHECK(seen.extension() == ".txt");
    CHECK(*read_text(file) == "new");
    CHECK(folder.files() == 1);
}

TEST_CASE("a failing writer leaves the old file and nothing else") {
    const TemporaryFolder folder("failing");
    const fs::path file = folder.path / "a.txt";
    REQUIRE(write_text_atomically(file, "old"));
    const Status status = write_atomically(file, [](const fs::path& path) -> Status {
        std::ofstream(path) << "half";
        return failed("no more ink");
    });
    REQUIRE_FALSE(status);
    CHECK(status.error().message() == "no more ink");
    CHECK_FALSE(write_atomically(file, [](const fs::path&) -> Status { return Done{}; }));  // wrote nothing at all
    CHECK_THROWS(static_cast<void>(write_atomically(file, [](const fs::path& path) -> Status {
        std::ofstream(path) << "half";
        throw std::runtime_error("writer threw");
    })));
    {
        const FileSizeLimit limit(4096);
        const Status full = write_text_atomically(file, std::string(1 << 20, 'x'));
        REQUIRE_FALSE(full);
        CHECK(full.error().kind == ErrorKind::kFailed);
    }
    CHECK(*read_text(file) == "old");
    CHECK(folder.files() == 1);
}

TEST_CASE("a signal that ends the process removes the unfinished file first, and one that is ignored does not end it") {
    const TemporaryFolder folder("signals");
    const fs::path target = folder.path / "a.txt";
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        CAPTURE(number);
        for (const bool ignored : {false, true}) {
            const pid_t child = ::fork();
            if (child == 0) {
                std::signal(number, ignored ? SIG_IGN : SIG_DFL);
                clean_up_on_signals();
                const Status done = write_atomically(target, [&](const fs::path& path) -> Status {
                    std::ofstream(path) << "half" << std::flush;
                    if (!fs::exists(path)) ::_exit(2);
                    ::raise(number);
                    return Done{};
                });
                ::_exit(done ? 0 : 1);
            }
            int status = 0;
            REQUIRE(::waitpid(child, &status, 0) == child);
            if (ignored) {
                CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
                CHECK(fs::remove(target));
            } else {
                CHECK((WIFSIGNALED(status) && WTERMSIG(status) == number));
            }
            CHECK(folder.files() == 0);
        }
    }
}

TEST_CASE("targets that cannot be written are errors") {
    const TemporaryFolder folder("unwritable");
    REQUIRE(write_text_atomically(folder.path / "file", "x"));
    fs::create_directory(folder.path / "directory");
    CHECK_FALSE(write_text_atomically(folder.path / "missing" / "a.txt", "x"));
    CHECK_FALSE(write_text_atomically(folder.path / "file" / "a.txt", "x"));
    CHECK_FALSE(write_text_atomically(folder.path / "directory", "x"));
    CHECK_FALSE(write_text_atomically(folder.path / "directory" / "", "x"));
    CHECK_FALSE(write_text_atomically("", "x"));
    CHECK(folder.files() == 2);
}

TEST_CASE("links are followed and devices survive") {
    const TemporaryFolder folder("links");
    REQUIRE(write_text_atomically(folder.path / "real", "old"));
    fs::create_symlink("real", folder.path / "link");
    REQUIRE(write_text_atomically(folder.path / "link", "new"));
    CHECK(fs::is_symlink(folder.path / "link"));
    CHECK(*read_text(folder.path / "real") == "new");
    CHECK(write_text_atomically("/dev/null", "x"));
    CHECK(fs::is_character_file("/dev/null"));
    CHECK_FALSE(write_text_atomically("/dev/full", "x"));
}

TEST_CASE("read_text refuses what is missing, a directory or too large") {
    const TemporaryFolder folder("read");
    REQUIRE(write_text_atomically(folder.path / "a", "12345"));
    CHECK(read_text(folder.path / "a", 5));
    CHECK_FALSE(read_text(folder.path / "a", 4));
    CHECK_FALSE(read_text(folder.path / "b"));
    CHECK_FALSE(read_text(folder.path));
    CHECK_FALSE(read_text("/dev/zero", 1000));
}

TEST_CASE("assets_directory obeys the environment and finds the source tree otherwise") {
    const char* before = std::getenv("NULLSCOPE_ASSETS");
    const std::string kept = before ? before : "";
    ::setenv("NULLSCOPE_ASSETS", "/somewhere", 1);
    CHECK(assets_directory() == "/somewhere");
    ::unsetenv("NULLSCOPE_ASSETS");
    CHECK(fs::is_directory(assets_directory()));
    if (before) ::setenv("NULLSCOPE_ASSETS", kept.c_str(), 1);
}

TEST_CASE("short progress is silent and never divides by zero") {
    Progress none("nothing", 0);
    none.advance();
    Progress some("something", 10);
    for (int i = 0; i < 20; ++i) some.advance();
}
