// FITS pictures that are read: those that are written here, others made card by card, and what is refused.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "image/fits_input.h"
#include "image/image_file.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;

// A file of these cards and big-endian numbers.
std::string fits_of(const std::vector<std::string>& cards, const std::vector<double>& values, int bits) {
    std::string file;
    for (const std::string& card : cards) file += fmt::format("{:<80}", card);
    file += fmt::format("{:<80}", "END");
    file.resize((file.size() + 2879) / 2880 * 2880, ' ');
    for (const double value : values) {
        const std::uint64_t whole = bits == 64 ? std::bit_cast<std::uint64_t>(value)
                                               : std::uint64_t{std::bit_cast<std::uint32_t>(static_cast<float>(value))};
        for (int at = bits - 8; at >= 0; at -= 8) file += static_cast<char>(whole >> at & 0xff);
    }
    return file;
}

std::vector<std::string> cards_of(int width, int height, int bits) {
    return {"SIMPLE  =                    T / a comment", fmt::format("BITPIX  = {:>20}", -bits),
            "NAXIS   =                    2", fmt::format("NAXIS1  = {:>20} / columns", width),
            fmt::format("NAXIS2  = {:>20}", height)};
}

TEST_CASE("fits input: what save_fits writes is read as it was") {
    const TemporaryFolder folder("fits-input");
    for (const int planes : {1, 4}) {
        Image<float> image(5, 3, planes);
        for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = 0.1f * static_cast<float>(i) - 1;
        FitsHeader header{.unit = "Jy/pixel", .unit_comment = "it's a comment"};
        header.cards = {
            {"CDELT1", -1.25e-10, ""}, {"OBJECT", std::string("O'Neill's"), "x / y"}, {"FREQ", 2.3e11, "Hz"}};
        REQUIRE(save_fits(folder.path / "a.fits", image, header));
        const auto read = load_fits(folder.path / "a.fits");
        REQUIRE_MESSAGE(read, read.error().message());
        CHECK(read->planes.width == 5);
        CHECK(read->planes.channels == planes);
        CHECK(read->planes.data == std::vector<double>(image.data.begin(), image.data.end()));
        CHECK(read->number("CDELT1") == -1.25e-10);
        CHECK(read->text("OBJECT") == "O'Neill's");
        CHECK(read->text("BUNIT") == "Jy/pixel");
        CHECK(read->number("NAXIS1") == 5);
        CHECK_FALSE(read->number("OBJECT"));
        CHECK_FALSE(read->number("CDELT9"));
    }
}

TEST_CASE("fits input: doubles, a scale, four axes, Fortran's exponents") {
    std::vector<std::string> cards = cards_of(2, 2, 64);
    cards[2] = "NAXIS   =                    4";
    for (const char* card : {"NAXIS3  =                    1", "NAXIS4  =                    1",
                             "BSCALE  =               0.5D0", "BZERO   =                  10"})
        cards.emplace_back(card);
    const auto read = parse_fits(fits_of(cards, {1, 2, 3, 4.5}, 64), "a.fits");
    REQUIRE_MESSAGE(read, read.error().message());
    CHECK(read->planes.data == std::vector<double>{11.5, 12.25, 10.5, 11});  // the file's bottom row comes first
}

TEST_CASE("fits input: what is no picture is refused by its card") {
    const auto said = [](std::vector<std::string> cards, std::vector<double> values, int bits = 32) {
        const auto read = parse_fits(fits_of(cards, values, bits), "a.fits");
        return read ? std::string("read") : read.error().message();
    };
    const std::vector<std::string> good = cards_of(2, 1, 32);
    CHECK(said(good, {1, 2}) == "read");
    const auto with = [&](std::size_t i, const char* card) {
        std::vector<std::string> cards = good;
        cards[i] = card;
        return cards;
    };
    CHECK(said(with(0, "SIMPLY  =                    T"), {1, 2}).starts_with("a.fits: SIMPLE: no FITS file"));
    CHECK(said(with(1, "BITPIX  =                   16"), {1, 2})
              .starts_with("a.fits: BITPIX: \"16\" is not read; allowed: -32, -64"));
    CHECK(said(with(2, "NAXIS   =                    1"), {1, 2}).starts_with("a.fits: NAXIS: 1 axis"));
    CHECK(said(with(3, "NAXIS1  =                  2.5"), {1, 2}).starts_with("a.fits: NAXIS1: 2.5 is out of range"));
    CHECK(said(with(3, "NAXIS1  =           1000000000"), {1, 2}).starts_with("a.fits: NAXIS1:"));
    CHECK(said(with(4, "NAXISX  =                    1"), {1, 2}).starts_with("a.fits: NAXIS2: this card is missing"));
    CHECK(said(with(3, "NAXIS1  =                32768"), {1, 2}).starts_with("a.fits: NAXIS1: the file is cut off"));
    CHECK(said(good, {1}).starts_with("a.fits: NAXIS1: the file is cut off"));
    CHECK(said(good, {1, std::numeric_limits<double>::infinity()})
              .starts_with("a.fits: column 2, row 1 from below: inf"));
    std::vector<std::string> cube = with(2, "NAXIS   =                    3");
    cube.emplace_back("NAXIS3  =                    3");
    CHECK(said(cube, {1, 2, 3, 4, 5, 6}).starts_with("a.fits: NAXIS3: 3 planes; allowed: 1, or 4"));
    cube.back() = "NAXIS3  =                    4";
    cube.emplace_back("CTYPE3  = 'STOKES  '");
    CHECK(said(cube, {1, 2, 3, 4, 5, 6, 7, 8}) == "read");
    cube.emplace_back("CDELT3  =                   -1");
    CHECK(said(cube, {1, 2, 3, 4, 5, 6, 7, 8}).starts_with("a.fits: CRVAL3: the planes are not I, Q, U, V"));
    const auto endless = parse_fits(std::string(160, ' ').replace(0, 30, "SIMPLE  =                    T"), "a.fits");
    CHECK_FALSE(endless);
    CHECK(endless.error().message() == "a.fits: END: the header has no end");
    CHECK_FALSE(parse_fits("", "a.fits"));
}

}  // namespace
