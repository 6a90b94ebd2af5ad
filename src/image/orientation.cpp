#include "image/orientation.h"

#include <cstddef>
#include <cstdint>

namespace nullscope {
namespace {

constexpr std::uint32_t kOrientationTag = 0x0112, kShort = 3;
constexpr std::size_t kEntryBytes = 12;

// Numbers of a TIFF's byte order; 0 beyond its end.
class TiffNumbers {
public:
    explicit TiffNumbers(std::string_view bytes) : bytes_(bytes), little_(bytes.starts_with("II")) {}
    std::uint32_t at(std::size_t place, std::size_t size) const {
        std::uint32_t number = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t from = place + (little_ ? size - 1 - i : i);
            number = number << 8 | (from < bytes_.size() ? static_cast<unsigned char>(bytes_[from]) : 0u);
        }
        return number;
    }

private:
    std::string_view bytes_;
    bool little_;
};

}  // namespace

int exif_orientation(std::string_view tiff) {
    const TiffNumbers numbers(tiff);
    if ((!tiff.starts_with("II") && !tiff.starts_with("MM")) || numbers.at(2, 2) != 42) return 1;
    const std::size_t directory = numbers.at(4, 4), entries = numbers.at(directory, 2);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + i * kEntryBytes;
        if (entry + kEntryBytes > tiff.size()) return 1;
        if (numbers.at(entry, 2) != kOrientationTag || numbers.at(entry + 2, 2) != kShort) continue;
        const std::uint32_t found = numbers.at(entry + 8, 2);
        return found >= 1 && found <= 8 ? static_cast<int>(found) : 1;
    }
    return 1;
}

Image<float> turned(const Image<float>& image, int orientation) {
    const int w = image.width, h = image.height;
    Image<float> out = orientation >= 5 ? Image<float>(h, w, image.channels) : Image<float>(w, h, image.channels);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int along = orientation >= 5 ? y : x, down = orientation >= 5 ? x : y;
            const bool left = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8,
                       up = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
            const float* from = image.at(left ? w - 1 - along : along, up ? h - 1 - down : down);
            std::copy_n(from, image.channels, out.at(x, y));
        }
    return out;
}

}  // namespace nullscope
