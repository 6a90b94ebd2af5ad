// What a histogram counts, against pixels that are known.
#include <doctest/doctest.h>

#include <vector>

#include "studio/levels.h"

using namespace nullscope::viewer;

namespace {

void add_pixels(std::vector<unsigned char>& rgba, int count, unsigned char red, unsigned char green,
                unsigned char blue) {
    for (int i = 0; i < count; ++i) rgba.insert(rgba.end(), {red, green, blue, 255});
}

}  // namespace

TEST_CASE("levels: colours, luma, ends and shares of a picture are counted") {
    std::vector<unsigned char> rgba;
    add_pixels(rgba, 50, 0, 0, 0);
    add_pixels(rgba, 30, 100, 100, 100);
    add_pixels(rgba, 19, 0, 0, 255);
    add_pixels(rgba, 1, 255, 255, 255);
    const PictureLevels levels = picture_levels(rgba);
    CHECK(levels.pixels == 100);
    CHECK(levels.black == 50);
    CHECK(levels.clipped == 20);
    CHECK(levels.colours[0][100] == 30);
    CHECK(levels.colours[2][255] == 20);
    CHECK(levels.luma[18] == 19);  // 0.0722 * 255 = 18.4
    CHECK(levels.most() == 30);    // neither black nor clipped
    CHECK(levels.luma_of(0.0) == 0);
    CHECK(levels.luma_of(0.5) == 0);
    CHECK(levels.luma_of(0.51) == 18);
    CHECK(levels.luma_of(0.69) == 18);
    CHECK(levels.luma_of(0.7) == 100);
    CHECK(levels.luma_of(0.99) == 100);
    CHECK(levels.luma_of(1.0) == 255);
}

TEST_CASE("levels: a picture without pixels has none") {
    CHECK(picture_levels({}).luma_of(0.5) == 0);
    CHECK(picture_levels({}).most() == 1);
}
