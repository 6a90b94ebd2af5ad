#include "image/fits_input.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "base/atomic_file.h"
#include "base/text.h"

namespace nullscope {
namespace {

constexpr std::size_t kFitsBlock = 2880, kFitsCard = 80, kValueAt = 10;

Error fits_fault(const std::string& name, const std::string& card, std::string_view what,
                 std::string_view allowed = {}) {
    return {ErrorKind::kBadInput, without_controls(std::string(what)), std::string(allowed), card, name};
}

// Of a card "KEYWORD = value / comment".
std::string card_value(std::string_view card) {
    const std::string_view rest = card.substr(kValueAt);
    const std::size_t quote = rest.find_first_not_of(' ');
    if (quote == std::string_view::npos || rest[quote] != '\'') return trim(rest.substr(0, rest.find('/')));
    std::string text;
    for (std::size_t i = quote + 1; i < rest.size(); ++i) {
        if (rest[i] == '\'' && (i + 1 == rest.size() || rest[++i] != '\'')) break;  // '' stands for one
        text += rest[i];
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

// Where the numbers begin.
Result<std::size_t> read_cards(std::string_view bytes, const std::string& name, FitsPicture& picture) {
    if (!bytes.starts_with("SIMPLE  ="))
        return fits_fault(name, "SIMPLE", "no FITS file", "SIMPLE = T at its beginning");
    for (std::size_t at = 0; at + kFitsCard <= bytes.size(); at += kFitsCard) {
        const std::string_view card = bytes.substr(at, kFitsCard);
        if (card.starts_with("END     ")) return (at / kFitsBlock + 1) * kFitsBlock;
        if (card.substr(8, 2) == "= ") picture.cards.emplace(trim(card.substr(0, 8)), card_value(card));
    }
    return fits_fault(name, "END", "the header has no end");
}

Result<int> side_of(const FitsPicture& picture, const std::string& name, const std::string& card, int most) {
    const auto side = picture.number(card);
    if (side && *side >= 1 && *side <= most && *side == std::floor(*side)) return static_cast<int>(*side);
    return fits_fault(name, card, side ? fmt::format("{} is out of range", *side) : "this card is missing or no number",
                      fmt::format("a whole number, [1, {}]", most));
}

struct FitsShape {
    int width = 0, height = 0, planes = 1, bits = 0;
};

Result<FitsShape> shape_of(const FitsPicture& picture, const std::string& name) {
    FitsShape shape;
    const double bits = picture.number("BITPIX").value_or(0);
    if (bits != -32 && bits != -64)
        return fits_fault(name, "BITPIX", fmt::format("{} is not read", in_quotes(picture.text("BITPIX"))), "-32, -64");
    shape.bits = bits == -32 ? 32 : 64;
    constexpr int kMostAxes = 9, kMostSide = 32768;
    TRY(axes, side_of(picture, name, "NAXIS", kMostAxes));
    if (*axes < 2) return fits_fault(name, "NAXIS", "1 axis is no picture", "2 or more");
    TRY(width, side_of(picture, name, "NAXIS1", kMostSide));
    TRY(height, side_of(picture, name, "NAXIS2", kMostSide));
    shape.width = *width, shape.height = *height;
    for (int axis = 3; axis <= *axes; ++axis) {
        const std::string card = fmt::format("NAXIS{}", axis);
        TRY(side, side_of(picture, name, card, kMostSide));
        const bool stokes = picture.text(fmt::format("CTYPE{}", axis)) == "STOKES";
        if (*side == 4 && stokes && shape.planes == 1)
            shape.planes = 4;
        else if (*side != 1)
            return fits_fault(name, card, fmt::format("{} planes", *side), "1, or 4 of an axis STOKES");
    }
    if (shape.planes == 4) {
        const int axis = picture.text("CTYPE3") == "STOKES" ? 3 : 4;
        if (picture.number(fmt::format("CRVAL{}", axis)).value_or(1) != 1 ||
            picture.number(fmt::format("CDELT{}", axis)).value_or(1) != 1)
            return fits_fault(name, fmt::format("CRVAL{}", axis), "the planes are not I, Q, U, V", "CRVAL 1, CDELT 1");
    }
    return shape;
}

double number_at(const char* at, int bits) {
    std::uint64_t value = 0;
    for (int i = 0; i < bits / 8; ++i) value = value << 8 | static_cast<unsigned char>(at[i]);
    return bits == 32 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(value)))
                      : std::bit_cast<double>(value);
}

}  // namespace

std::optional<double> FitsPicture::number(const std::string& keyword) const {
    const auto found = cards.find(keyword);
    if (found == cards.end()) return std::nullopt;
    std::string text = found->second;
    for (char& c : text)
        if (c == 'D' || c == 'd') c = 'e';  // Fortran's
    return parse_number(text);
}

std::string FitsPicture::text(const std::string& keyword) const {
    const auto found = cards.find(keyword);
    return found == cards.end() ? "" : found->second;
}

Result<FitsPicture> parse_fits(std::string_view bytes, const std::string& name) {
    FitsPicture picture;
    TRY(begin, read_cards(bytes, name, picture));
    TRY(shape, shape_of(picture, name));
    const auto size = static_cast<std::size_t>(shape->bits / 8);
    const std::size_t count = static_cast<std::size_t>(shape->width) * static_cast<std::size_t>(shape->height) *
                              static_cast<std::size_t>(shape->planes);
    if (*begin > bytes.size() || (bytes.size() - *begin) / size < count)
        return fits_fault(name, "NAXIS1", "the file is cut off", fmt::format("{} numbers behind the header", count));
    const double scale = picture.number("BSCALE").value_or(1), zero = picture.number("BZERO").value_or(0);
    picture.planes = Image<double>(shape->width, shape->height, shape->planes);
    const char* at = bytes.data() + *begin;
    for (int plane = 0; plane < shape->planes; ++plane)
        for (int y = shape->height - 1; y >= 0; --y)
            for (int x = 0; x < shape->width; ++x, at += size) {
                const double value = zero + scale * number_at(at, shape->bits);
                if (!std::isfinite(value))
                    return fits_fault(name, "",
                                      fmt::format("column {}, row {} from below: {}", x + 1, shape->height - y, value),
                                      "finite numbers");
                picture.planes.at(x, y)[plane] = value;
            }
    return picture;
}

Result<FitsPicture> load_fits(const std::filesystem::path& path) {
    TRY(bytes, read_text(path, kLargestFits));
    return parse_fits(*bytes, path.string());
}

}  // namespace nullscope
