// Images that are read row by row: the same numbers as whole ones, means of areas in linear light, and refusals.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "base/atomic_file.h"
#include "image/area_filter.h"
#include "image/image_file.h"
#include "image/large_image.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace nullscope;
namespace fs = std::filesystem;

namespace {

constexpr float kLargeImageRounding = 2e-6f;  // sums of up to some hundred floats of at most 1

Image<unsigned char> speckled(int width, int height, int channels) {
    Image<unsigned char> image(width, height, channels);
    unsigned state = 1;
    for (unsigned char& value : image.data)
        value = static_cast<unsigned char>((state = state * 1664525u + 1013904223u) >> 24);
    return image;
}

double mean_of(const Image<float>& image, int channel) {
    double sum = 0.0;
    for (std::size_t i = static_cast<std::size_t>(channel); i < image.data.size();
         i += static_cast<std::size_t>(image.channels))
        sum += image.data[i];
    return sum * image.channels / static_cast<double>(image.data.size());
}

}  // namespace

TEST_CASE("rows of a PNG are those of the whole PNG") {
    const TemporaryFolder folder("rows");
    for (const int channels : {3, 4}) {
        const fs::path file = folder.path / "a.png";
        REQUIRE(save_png(file, speckled(131, 57, channels)));
        const auto whole = load_image(file);
        const auto rows = load_fitted_image(file, {.whole_pixels = 0});
        REQUIRE(whole);
        REQUIRE(rows);
        CHECK_FALSE(rows->reduced());
        REQUIRE(rows->image.data.size() == whole->data.size());
        float worst = 0.0f;
        for (std::size_t i = 0; i < whole->data.size(); ++i)
            if (channels == 3 || whole->data[i | 3] > 0.0f)
                worst = std::max(worst, std::fabs(whole->data[i] - rows->image.data[i]));
        CHECK(worst <= 1e-7f);  // colours are multiplied by alpha and divided again
    }
}

TEST_CASE("a smaller picture has the mean of the areas that its pixels stand for, in linear light") {
    const TemporaryFolder folder("smaller");
    const fs::path file = folder.path / "a.png";
    Image<unsigned char> board(64, 32, 3);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c) board.at(x, y)[c] = (x + y) % 2 == 0 ? 255 : 0;
    REQUIRE(save_png(file, board));
    for (const long long whole_pixels : {0LL, 1LL << 30}) {  // by rows and at once
        const auto half = load_fitted_image(file, {.max_side = 32, .whole_pixels = whole_pixels});
        REQUIRE(half);
        CHECK(half->reduced());
        CHECK((half->image.width == 32 && half->image.height == 16));
        for (const float value : half->image.data)
            CHECK(std::fabs(value - 0.5f) <= kLargeImageRounding);  // not 0.5 of the code values: 0.21
        CHECK(reduction_words("a.png", *half, "so") == "'a.png': 64x32 px, read as 32x16 px: so");
    }
    REQUIRE(save_png(file, speckled(331, 127, 3)));
    const auto whole = load_image(file),
               odd = Result<Image<float>>(load_fitted_image(file, {.max_side = 100, .whole_pixels = 0})->image);
    REQUIRE(odd);
    CHECK((odd->width == 100 && odd->height == 38));
    for (int c = 0; c < 3; ++c) CHECK(std::fabs(mean_of(*whole, c) - mean_of(*odd, c)) <= kLargeImageRounding);
    // One pixel, by hand: columns [16.55, 19.86), rows [10.03, 13.37) of the old one.
    double sum = 0.0, area = 0.0;
    for (int y = 0; y < whole->height; ++y)
        for (int x = 0; x < whole->width; ++x) {
            const double w = std::max(0.0, std::min(x + 1.0, 6 * 3.31) - std::max(x + 0.0, 5 * 3.31));
            const double h = std::max(0.0, std::min(y + 1.0, 4 * 127.0 / 38) - std::max(y + 0.0, 3 * 127.0 / 38));
            sum += w * h * static_cast<double>(whole->at(x, y)[1]), area += w * h;
        }
    CHECK(std::fabs(static_cast<double>(odd->at(5, 3)[1]) - sum / area) <= kLargeImageRounding);
}

TEST_CASE("colours behind nothing do not bleed into a smaller picture") {
    AreaFilter filter(2, 1, 4, 1, 1);
    const float row[8] = {1, 0, 0, 1, 0, 1, 0, 0};  // red, and a green that is not to be seen
    filter.add_row(row);
    const Image<float> one = filter.take();
    CHECK(one.data == std::vector<float>{1, 0, 0, 0.5f});
}

TEST_CASE("by rows, JPEG is read to within a code value of the whole, and what needs the whole is refused") {
    const fs::path corpus = test::data_folder() / "fuzz" / "corpus" / "picture";
    int read = 0;
    for (const auto& entry : fs::directory_iterator(corpus)) {
        const auto bytes = read_text(entry.path());
        REQUIRE(bytes);
        CAPTURE(entry.path().filename().string());
        const auto whole = decode_image(*bytes, "x", 1 << 20);
        const auto rows = decode_fitted_image(*bytes, "x", {.whole_pixels = 0, .max_pixels = 1 << 20});
        if (!rows) CHECK(rows.error().message().starts_with("cannot read image 'x': "));
        if (!whole || !rows || !bytes->starts_with("\xff\xd8")) continue;
        ++read;
        CHECK((rows->image.width == whole->width && rows->image.height == whole->height));
    }
    CHECK(read > 0);
    const auto progressive = read_text(corpus / "progressive-444.jpg");
    REQUIRE(progressive);
    const auto refused = decode_fitted_image(*progressive, "x", {.whole_pixels = 0});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message().find("progressive") != std::string::npos);
    const auto hostile = read_text(corpus / "huge-header.png");
    REQUIRE(hostile);
    const auto huge = decode_fitted_image(*hostile, "x", {});
    REQUIRE_FALSE(huge);
    CHECK(huge.error().message() == "cannot read image 'x': 10000 x 10000 pixels are not in 69 bytes");
}

TEST_CASE("a large picture that is cut off is an error") {
    const TemporaryFolder folder("cut");
    const fs::path file = folder.path / "a.png";
    REQUIRE(save_png(file, speckled(64, 64, 3)));
    const auto bytes = read_text(file);
    REQUIRE(bytes);
    for (std::size_t size = 40; size + 400 < bytes->size(); size += 997) {
        const auto cut = decode_fitted_image(bytes->substr(0, size), "x", {.whole_pixels = 0});
        REQUIRE_FALSE(cut);
        CHECK(cut.error().message().starts_with("cannot read image 'x': "));
    }
}
