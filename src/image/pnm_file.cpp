// Netpbm's grey and coloured pictures (PGM and PPM, man 5 pgm and ppm) as bytes, P5 and P6, or as text, P2 and P3. Their numbers go from 0 to a
// largest one that the head names, of one byte or two, the higher first; sRGB-encoded, as programs of today write them.
#include <fmt/format.h>

#include <array>
#include <charconv>

#include "image/image_file.h"
#include "image/image_formats.h"

namespace nullscope {
namespace {

constexpr std::string_view kPnmBlanks = " \t\n\v\f\r";
constexpr int kMostPnmSide = 1'000'000, kMostPnmCode = 65535;

// The next number of a head or text; comments go from # to the line's end.
std::optional<int> next_number(std::string_view& bytes) {
    while (!bytes.empty() && (bytes.front() == '#' || kPnmBlanks.find(bytes.front()) != std::string_view::npos)) {
        const std::size_t line = bytes.front() == '#' ? bytes.find_first_of("\n\r") : 0;
        bytes.remove_prefix(std::min(line, bytes.size() - 1) + 1);
    }
    int number = 0;
    const auto [end, error] = std::from_chars(bytes.data(), bytes.data() + bytes.size(), number);
    if (error != std::errc()) return {};
    bytes.remove_prefix(static_cast<std::size_t>(end - bytes.data()));
    return number;
}

}  // namespace

bool is_pnm(std::string_view bytes) {
    return bytes.size() > 1 && bytes[0] == 'P' && std::string_view("2356").find(bytes[1]) != std::string_view::npos;
}

Result<WholePicture> decode_pnm(std::string_view bytes, long long max_pixels) {
    const bool is_text = bytes[1] < '5';
    const std::size_t channels = bytes[1] == '6' || bytes[1] == '3' ? 3 : 1;
    const std::size_t file_bytes = bytes.size();
    bytes.remove_prefix(2);
    std::array<std::optional<int>, 3> head;
    for (auto& number : head) number = next_number(bytes);
    const auto [width, height, most] = std::array{head[0].value_or(0), head[1].value_or(0), head[2].value_or(0)};
    if (width < 1 || height < 1 || most < 1 || width > kMostPnmSide || height > kMostPnmSide || most > kMostPnmCode)
        return bad_input("PNM's head is not width, height and largest number",
                         fmt::format("[1, {}] px a side, [1, {}]", kMostPnmSide, kMostPnmCode));
    const long long pixels = static_cast<long long>(width) * height;
    if (pixels > max_pixels)
        return bad_input(fmt::format("{} x {} pixels, at most {} are allowed", width, height, max_pixels));
    // A single blank follows the head; as text each number has one before it.
    const std::size_t size = most > 255 || is_text ? 2 : 1, samples = static_cast<std::size_t>(pixels) * channels;
    if (bytes.size() < samples * size + (is_text ? 0 : 1))
        return bad_input(fmt::format("{} x {} pixels are not in {} bytes", width, height, file_bytes));
    if (!is_text) bytes.remove_prefix(1);
    std::vector<float> light(static_cast<std::size_t>(most) + 1);
    for (std::size_t code = 0; code < light.size(); ++code)
        light[code] = linear_from_srgb(static_cast<float>(code) / static_cast<float>(most));
    WholePicture picture{Image<float>(width, height, 3)};
    for (std::size_t i = 0; i < samples; ++i) {
        const std::optional<int> code =
            is_text ? next_number(bytes) : static_cast<int>(big_endian(bytes.substr(i * size, size)));
        if (!code) return bad_input(fmt::format("PNM's number {} of {} is missing", i + 1, samples));
        if (*code < 0 || *code > most)
            return bad_input(fmt::format("a PNM number of {}", *code), fmt::format("[0, {}]", most));
        for (std::size_t same = 0; same < 3 / channels; ++same)
            picture.image.data[i * (3 / channels) + same] = light[static_cast<std::size_t>(*code)];
    }
    return picture;
}

}  // namespace nullscope
