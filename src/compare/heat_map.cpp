#include "compare/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace nullscope {
namespace {

using Colour = std::array<unsigned char, 3>;

constexpr std::array<Colour, 7> kRamp = {
    {{0, 0, 0}, {40, 20, 110}, {30, 100, 180}, {40, 170, 110}, {230, 210, 60}, {220, 60, 30}, {255, 255, 255}}};
constexpr Colour kNotFinite = {255, 0, 255}, kInk = {255, 255, 255}, kGround = {24, 24, 24};

// 3x5 letters, a row in three bits, top row first.
constexpr std::string_view kLetters = "0123456789e-";
constexpr std::array<std::uint16_t, 12> kGlyphs = {
    0b111101101101111, 0b010110010010111, 0b111001111100111, 0b111001111001111, 0b101101111001001, 0b111100111001111,
    0b111100111101111, 0b111001001001001, 0b111101111101111, 0b111101111001111, 0b111101111100111, 0b000000111000000};
constexpr int kLetterScale = 2, kLetterWidth = 4 * kLetterScale;

Colour ramp(double t) {
    const double at = std::clamp(t, 0.0, 1.0) * (kRamp.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), kRamp.size() - 2);
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = static_cast<unsigned char>(
            std::lround(kRamp[i][c] + (at - static_cast<double>(i)) * (kRamp[i + 1][c] - kRamp[i][c])));
    return colour;
}

void put(Image<unsigned char>& image, int x, int y, const Colour& colour) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
    std::copy(colour.begin(), colour.end(), image.at(x, y));
}

void write_letters(Image<unsigned char>& image, int x, int y, std::string_view text) {
    for (const char letter : text) {
        const auto glyph = kLetters.find(letter);
        for (int bit = 0; glyph != std::string_view::npos && bit < 15; ++bit) {
            if ((kGlyphs[glyph] >> (14 - bit) & 1) == 0) continue;
            for (int i = 0; i < kLetterScale * kLetterScale; ++i)
                put(image, x + bit % 3 * kLetterScale + i % kLetterScale, y + bit / 3 * kLetterScale + i / kLetterScale,
                    kInk);
        }
        x += kLetterWidth;
    }
}

void draw_legend(Image<unsigned char>& image, int top, HeatScale scale) {
    constexpr int kBar = 12;
    for (int x = 0; x < image.width; ++x)
        for (int y = top + 2; y < top + 2 + kBar; ++y)
            put(image, x, y, ramp(static_cast<double>(x) / (image.width - 1)));
    const double low = std::log10(scale.low), high = std::log10(scale.high);
    for (int decade = static_cast<int>(std::ceil(low - 1e-9)); decade <= high + 1e-9; ++decade) {
        const int x = static_cast<int>(std::lround((decade - low) / (high - low) * (image.width - 1)));
        for (int y = top + 2; y < top + 4 + kBar; ++y) put(image, x, y, kInk);
        const std::string label = fmt::format("1e{}", decade);
        const int length = static_cast<int>(label.size()) * kLetterWidth;
        write_letters(image, std::clamp(x - length / 2, 1, image.width - length - 1), top + 5 + kBar, label);
    }
}

}  // namespace

std::array<unsigned char, 3> heat_colour(double value, HeatScale scale) {
    if (!std::isfinite(value)) return kNotFinite;
    return ramp(value > 0 ? std::log(value / scale.low) / std::log(scale.high / scale.low) : 0);
}

Image<unsigned char> heat_map(const Image<float>& values, HeatScale scale) {
    Image<unsigned char> image(std::max(values.width, kHeatMapWidth), values.height + kLegendHeight, 3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) put(image, x, y, kGround);
    for (int y = 0; y < values.height; ++y)
        for (int x = 0; x < values.width; ++x) put(image, x, y, heat_colour(*values.at(x, y), scale));
    draw_legend(image, values.height, scale);
    return image;
}

}  // namespace nullscope
