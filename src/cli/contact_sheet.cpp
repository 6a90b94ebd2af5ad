#include "cli/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "annotate/lettering.h"
#include "image/image_file.h"
#include "image/large_image.h"

namespace nullscope::cli {
namespace {

constexpr int kWidest = 8192, kHighest = 16384, kLargestTile = 240, kLeastTile = 64, kGap = 8;  // px
constexpr double kLetters = 13.0;                                                               // px
constexpr unsigned char kGround = 14, kInk = 220;                                               // of grey

// Linear light between each two values of 8 bits: to find the value among them takes less than to compute it.
std::array<float, 255> light_between_values() {
    std::array<float, 255> between{};
    for (std::size_t i = 0; i < between.size(); ++i)
        between[i] = linear_from_srgb((static_cast<float>(i) + 0.5f) / 255.0f);
    return between;
}

Image<unsigned char> displayed(const Image<float>& light) {
    static const std::array<float, 255> between = light_between_values();
    Image<unsigned char> picture(light.width, light.height, 3);
    std::ranges::transform(light.data, picture.data.begin(), [](float value) {
        return static_cast<unsigned char>(std::ranges::upper_bound(between, value) - between.begin());
    });
    return picture;
}

void lay(const Image<unsigned char>& tile, int left, int top, Image<unsigned char>& sheet) {
    for (int y = 0; y < tile.height; ++y) std::copy_n(tile.at(0, y), 3 * tile.width, sheet.at(left, top + y));
}

// Cut where it is wider than its tile.
void letter(const Image<unsigned char>& line, int left, int top, int width, Image<unsigned char>& sheet) {
    for (int y = 0; y < line.height; ++y)
        for (int x = 0; x < std::min(line.width, width); ++x)
            for (int c = 0; c < 3; ++c)
                sheet.at(left + x, top + y)[c] =
                    static_cast<unsigned char>(kGround + (kInk - kGround) * *line.at(x, y) / 255);
}

}  // namespace

Status write_contact_sheet(const std::filesystem::path& file, const std::vector<SheetTile>& tiles, int columns) {
    const int rows = (static_cast<int>(tiles.size()) + columns - 1) / columns;
    const auto lettering = Lettering::open(kLetters);
    const int label = lettering ? lettering->height() + kGap / 2 : 0;
    const int side =
        std::min({kLargestTile, (kWidest - kGap) / columns - kGap, (kHighest - kGap) / rows - kGap - label});
    if (side < kLeastTile) return bad_input(fmt::format("{} x {} pictures are too many for one sheet", columns, rows));
    std::vector<Image<unsigned char>> pictures;
    int width = 0, height = 0;
    for (const SheetTile& tile : tiles) {
        TRY(fitted, load_fitted_image(tile.picture, {.max_side = side, .alpha = Alpha::kOnBlack}));
        pictures.push_back(displayed(fitted->image));
        width = std::max(width, pictures.back().width), height = std::max(height, pictures.back().height);
    }
    Image<unsigned char> sheet(kGap + columns * (width + kGap), kGap + rows * (height + label + kGap), 3);
    std::ranges::fill(sheet.data, kGround);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
        const int left = kGap + column * (width + kGap), top = kGap + row * (height + label + kGap);
        lay(pictures[i], left, top, sheet);
        if (lettering) letter(lettering->line(tiles[i].label), left, top + height + kGap / 4, width, sheet);
    }
    return save_png(file, sheet);
}

}  // namespace nullscope::cli
