// Options reach their targets, and wrong words give one line with the option, the value and what is allowed.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/command_line.h"

using namespace nullscope;

namespace {

// A program with every kind of option in its command "draw", and a command "list" without any.
struct Program {
    Command command{"prog", "A program."};
    std::string scene, kind = "red";
    int count = 3;
    unsigned seed = 7;
    double step = 0.5;
    std::optional<double> time;
    std::optional<int> limit;
    std::vector<std::string> names = {"a", "b"};
    std::vector<int> region;
    bool quick = false;

    Program() {
        command.set_version("1.2.3");
        Command& draw = command.add_command("draw", "Draws.");
        draw.add_option("scene", &scene, "What is drawn").required();
        draw.add_option("-k,--kind", &kind, "Its colour").one_of({"red", "blue"}).show_default();
        draw.add_option("--count", &count, "How many").in_range(1, 20).show_default();
        draw.add_option("--seed", &seed, "Chance").in_range(0, 4294967295.0);
        draw.add_option("--step", &step, "Step").needs("--quick").show_default();
        draw.add_option("--time", &time, "Time").in_range(-1e9, 1e9);
        draw.add_option("--limit", &limit, "Limit");
        draw.add_option("--names", &names, "Names").show_default();
        draw.add_option("--region", &region, "Region").count(4);
        draw.add_flag("--quick", &quick, "Quickly");
        draw.on_run([] { return 5; });
        command.add_command("list", "Lists.").on_run([] { return 6; });
    }

    Result<Asked> parse(std::vector<const char*> words) {
        words.insert(words.begin(), "prog");
        return parse_command_line(command, static_cast<int>(words.size()), words.data());
    }
    std::string error(std::vector<const char*> words) {
        const auto asked = parse(std::move(words));
        return asked ? "no error" : asked.error().message();
    }
};

}  // namespace

TEST_CASE("values of a command line reach their targets, what is not given keeps its default") {
    Program all;
    const auto asked =
        all.parse({"draw",   "x.toml",   "-k",     "blue", "--count=20", "--seed", "4294967295", "--quick",
                   "--step", "1e-3",     "--time", "-5.5", "--limit",    "9",      "--names",    "c",
                   "d",      "--region", "1",      "-2",   "3",          "4"});
    REQUIRE_MESSAGE(asked, asked.error().message());
    CHECK(asked->text.empty());
    CHECK(*asked->run() == 5);
    CHECK(all.scene == "x.toml");
    CHECK(all.kind == "blue");
    CHECK(all.count == 20);
    CHECK(all.seed == 4294967295u);
    CHECK(all.step == 1e-3);
    CHECK(all.time == -5.5);
    CHECK(all.limit == 9);
    CHECK(all.names == std::vector<std::string>{"c", "d"});
    CHECK(all.region == std::vector<int>{1, -2, 3, 4});
    CHECK(all.quick);

    Program none;
    REQUIRE(none.parse({"draw", "x.toml"}));
    CHECK(none.kind == "red");
    CHECK(none.count == 3);
    CHECK_FALSE(none.time);
    CHECK_FALSE(none.limit);
    CHECK(none.names.size() == 2);
    CHECK_FALSE(none.quick);
    CHECK(*none.parse({"list"})->run() == 6);
}

TEST_CASE("wrong words of a command line give one line with option, value and what is allowed") {
    const struct {
        std::vector<const char*> words;
        const char* message;
    } cases[] = {
        {{"drow"}, "drow: no such command; allowed: draw, list (nearest: draw) (see: prog --help)"},
        {{"draw"}, "scene is required (see: prog draw --help)"},
        {{"draw", "x", "y", "z"}, "y: not expected here (see: prog draw --help)"},
        {{"draw", "x", "--cuont", "3"}, "--cuont: no such option (nearest: --count) (see: prog draw --help)"},
        {{"draw", "--cuont", "3"}, "--cuont: no such option (nearest: --count) (see: prog draw --help)"},
        {{"draw", "x", "--count", "21"},
         "--count 21: out of range; allowed: whole numbers from 1 to 20 (see: prog draw --help)"},
        {{"draw", "x", "--count", "2.5"},
         "--count 2.5: not a whole number; allowed: whole numbers from 1 to 20 (see: prog draw --help)"},
        {{"draw", "x", "--count", "many"},
         "--count many: not a number; allowed: whole numbers from 1 to 20 (see: prog draw --help)"},
        {{"draw", "x", "--count"}, "--count: a value is missing (see: prog draw --help)"},
        {{"draw", "x", "--count", "2", "--count", "2"}, "--count: given more than once (see: prog draw --help)"},
        {{"draw", "x", "--time", "nan"},
         "--time nan: not a number; allowed: numbers from -1e+09 to 1e+09 (see: prog draw --help)"},
        {{"draw", "x", "--limit", "1e10"},
         "--limit 1e10: out of range; allowed: whole numbers (see: prog draw --help)"},
        {{"draw", "x", "-k", "bleu"},
         "--kind bleu: unknown; allowed: red, blue (nearest: blue) (see: prog draw --help)"},
        {{"draw", "x", "--step", "1"}, "--step: only with --quick (see: prog draw --help)"},
        {{"draw", "x", "--region", "1", "2"}, "--region: takes 4 values (see: prog draw --help)"},
        {{"draw", "x", "--quick=3"}, "--quick: takes no value (see: prog draw --help)"},
    };
    for (const auto& [words, message] : cases) {
        Program program;
        CHECK(program.error(words) == message);
    }
}

TEST_CASE("help of a command line lists commands, options, defaults and ranges") {
    Program program;
    const auto all = program.parse({"--help"}), one = program.parse({"draw", "--help"}),
               version = program.parse({"--version"});
    REQUIRE(all);
    REQUIRE(one);
    REQUIRE(version);
    CHECK(version->text == "1.2.3\n");
    CHECK(program.parse({})->text == all->text);
    CHECK(program.parse({"help"})->text == all->text);
    CHECK(program.parse({"help", "draw"})->text == one->text);
    CHECK(one->text.find("Usage: prog draw") != std::string::npos);
    CHECK(program.error({"help", "drow"}) ==
          "drow: no such command; allowed: draw, list (nearest: draw) (see: prog --help)");
    for (const char* word : {"A program.", "draw", "Draws.", "list"}) CHECK(all->text.find(word) != std::string::npos);
    const auto has = [&](const std::string& word) { return one->text.find(word) != std::string::npos; };
    for (const char* word : {"-k,--kind", "{red,blue}", "INT in [1 - 20]", "[a,b]", "only with --quick"})
        CHECK(has(word));
    // Defaults: as CLI11 2.2 writes them, or 2.4.
    CHECK((has("{red,blue}=red") || has("{red,blue} [red]")));
    CHECK((has("[1 - 20]=3") || has("[1 - 20] [3]")));
}
