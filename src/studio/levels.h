// How bright the pixels of a displayed picture are: what its histogram shows. Values are display-encoded, 0 to 255.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace nullscope::viewer {

struct PictureLevels {
    using Counts = std::array<std::size_t, 256>;     // pixels by value
    std::array<Counts, 3> colours{};                 // red, green, blue
    Counts luma{};                                   // 0.2126 R + 0.7152 G + 0.0722 B (Rec. 709), rounded
    std::size_t pixels = 0, clipped = 0, black = 0;  // clipped: one of its colours is 255

    // The least luma that no less than this share of the pixels does not exceed; share: 0 to 1.
    int luma_of(double share) const {
        std::size_t below = 0;
        for (std::size_t value = 0; value < luma.size(); ++value)
            if ((below += luma[value]) > 0 && static_cast<double>(below) >= share * static_cast<double>(pixels))
                return static_cast<int>(value);
        return 0;
    }
    // What a curve of the colours is drawn against: of values that are neither black nor clipped; at least 1.
    std::size_t most() const {
        std::size_t count = 1;
        for (const Counts& colour : colours)
            count = std::max(count, *std::max_element(colour.begin() + 1, colour.end() - 1));
        return count;
    }
};

// Of RGBA pixels.
inline PictureLevels picture_levels(std::span<const unsigned char> rgba) {
    PictureLevels levels;
    for (std::size_t i = 0; i + 4 <= rgba.size(); i += 4) {
        const unsigned red = rgba[i], green = rgba[i + 1], blue = rgba[i + 2];
        ++levels.colours[0][red], ++levels.colours[1][green], ++levels.colours[2][blue];
        ++levels.luma[(2126 * red + 7152 * green + 722 * blue + 5000) / 10000];
        ++levels.pixels;
        levels.clipped += std::max({red, green, blue}) == 255;
        levels.black += (red | green | blue) == 0;
    }
    return levels;
}

}  // namespace nullscope::viewer
