#include <doctest/doctest.h>

#include "base/text.h"

using namespace nullscope;

TEST_CASE("nearest_word finds misspellings and keeps quiet about strangers") {
    const std::vector<std::string> words{"schwarzschild", "kerr", "ellis", "minkowski"};
    CHECK(nearest_word("schwartzschild", words) == "schwarzschild");
    CHECK(nearest_word("ker", words) == "kerr");
    CHECK(nearest_word("minkovsky", words) == "minkowski");
    CHECK(nearest_word("kerr", words) == "kerr");
    CHECK(nearest_word("pancakes", words).empty());
    CHECK(nearest_word("", words).empty());
    CHECK(nearest_word("kerr", {}).empty());
    CHECK(nearest_word(std::string(1'000'000, 'x'), words).empty());
}

TEST_CASE("parse_number takes the whole text or nothing") {
    CHECK(parse_number("1.5").value() == 1.5);
    CHECK(parse_number(" \t-2e-3\r\n").value() == -2e-3);
    CHECK(parse_number("+7").value() == 7.0);
    CHECK(parse_number(".5").value() == 0.5);
    CHECK(parse_number("0.1").value() == 0.1);
    for (const char* text : {"", " ", "+", "-", "+-1", "--1", "1.5x", "1 2", "1,5", "0x10", "1e", "nan", "NaN", "-nan",
                             "inf", "infinity", "1e400", "-1e400", "one"})
        CHECK_FALSE_MESSAGE(parse_number(text).has_value(), text);
    using namespace std::string_view_literals;
    CHECK_FALSE(parse_number("1\0"sv).has_value());
}

TEST_CASE("split keeps empty parts, trim removes only the ends") {
    CHECK(split("a,,b", ',') == std::vector<std::string>{"a", "", "b"});
    CHECK(split("", ',') == std::vector<std::string>{""});
    CHECK(split(",", ',') == std::vector<std::string>{"", ""});
    CHECK(trim("  a b\t\n") == "a b");
    CHECK(trim(" \r\n ").empty());
}

TEST_CASE("without_controls leaves one line that moves no cursor") {
    CHECK(without_controls("a\nb\x1b[2J\x7f\t") == "a?b?[2J??");
    CHECK(without_controls("\xc2\x9b"
                           "31m \xc2\xa0 \xc3\xa9 \xc2") == "??31m \xc2\xa0 \xc3\xa9 \xc2");  // C1 go, letters stay
}
