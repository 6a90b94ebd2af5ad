// What is said of a film that is being drawn.
#include <doctest/doctest.h>

#include "studio/film_export.h"

namespace {

TEST_CASE("film export: the frame and the time that is left, in words") {
    using nullscope::viewer::film_words;
    CHECK(film_words(0.0, 150, std::nullopt) == "150 frames");
    CHECK(film_words(0.2, 150, std::nullopt) == "frame 30 of 150");
    CHECK(film_words(0.2, 150, 120.0) == "frame 30 of 150, 2 min left");
    CHECK(film_words(1.0, 150, 0.2) == "frame 150 of 150, 0 s left");
    CHECK(film_words(0.5, 1000, 59.0) == "frame 500 of 1000, 59 s left");
    CHECK(film_words(0.01, 1000, 9000.0) == "frame 10 of 1000, 2.5 h left");
}

}  // namespace
