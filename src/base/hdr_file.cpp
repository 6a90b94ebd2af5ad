// The Radiance half of base/image_file.h. Not by stb, whose decoder loops forever on some cut files (CVE-2021-42715).
// Format: Ward, "Real Pixels", Graphics Gems II (1991), and the Radiance reference manual: RGBE scanlines, plain or
// run-length coded by component; "-Y height +X width" only, which is what every writer produces.
#include "base/hdr_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace nullscope {
namespace {

constexpr int kMinCodedWidth = 8, kMaxCodedWidth = 0x7fff;  // scanlines outside are always plain
constexpr int kExponentBias = 128 + 8;                      // mantissas are integers of 8 bits

using Rgbe = std::array<unsigned char, 4>;

class Bytes {
public:
    explicit Bytes(std::string_view rest) : rest_(rest) {}
    bool empty() const { return rest_.empty(); }
    bool starts_with(std::string_view text) const { return rest_.starts_with(text); }
    std::string_view rest() const { return rest_; }
    unsigned char next() {
        const auto value = static_cast<unsigned char>(rest_.front());
        rest_.remove_prefix(1);
        return value;
    }
    std::string line() {
        const std::size_t end = rest_.find('\n');
        std::string text(rest_.substr(0, end));
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        return text;
    }

private:
    std::string_view rest_;
};

bool read_plain(Bytes& bytes, std::vector<Rgbe>& row) {
    for (Rgbe& pixel : row)
        for (unsigned char& component : pixel) {
            if (bytes.empty()) return false;
            component = bytes.next();
        }
    return true;
}

// A count above 128 repeats one value count - 128 times, any other copies that many. False if cut or inconsistent.
bool read_coded(Bytes& bytes, std::vector<Rgbe>& row) {
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t x = 0; x < row.size();) {
            if (bytes.empty()) return false;
            const int code = bytes.next();
            const bool run = code > 128;
            const auto count = static_cast<std::size_t>(run ? code - 128 : code);
            if (count == 0 || count > row.size() - x || bytes.rest().size() < (run ? 1 : count)) return false;
            const unsigned char value = run ? bytes.next() : static_cast<unsigned char>(0);
            for (std::size_t i = 0; i < count; ++i) row[x++][c] = run ? value : bytes.next();
        }
    return true;
}

bool read_scanline(Bytes& bytes, std::vector<Rgbe>& row) {
    const int width = static_cast<int>(row.size());
    const std::array<char, 4> mark{2, 2, static_cast<char>(width >> 8), static_cast<char>(width & 0xff)};
    if (width < kMinCodedWidth || width > kMaxCodedWidth || !bytes.starts_with({mark.data(), mark.size()}))
        return read_plain(bytes, row);
    for (int i = 0; i < 4; ++i) bytes.next();
    return read_coded(bytes, row);
}

}  // namespace

bool is_hdr(std::string_view bytes) { return bytes.starts_with("#?RADIANCE\n") || bytes.starts_with("#?RGBE\n"); }

Result<Image<float>> decode_hdr(std::string_view file, long long max_pixels) {
    Bytes bytes(file);
    for (std::string line = bytes.line(); !line.empty(); line = bytes.line())
        if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
            return bad_input(fmt::format("unsupported HDR {}", line));
    int width = 0, height = 0;
    if (std::sscanf(bytes.line().c_str(), "-Y %9d +X %9d", &height, &width) != 2 || width <= 0 || height <= 0)
        return bad_input("HDR size is not '-Y height +X width'");
    if (static_cast<long long>(width) * height > max_pixels)
        return bad_input(fmt::format("{} x {} pixels, at most {} are allowed", width, height, max_pixels));
    if (!plausible_size(3LL * width * height, file.size()))
        return bad_input(fmt::format("{} x {} pixels are not in {} bytes", width, height, file.size()));
    Image<float> image(width, height, 3);
    std::vector<Rgbe> row(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        if (!read_scanline(bytes, row)) return bad_input("HDR data are cut off or damaged");
        float* out = image.at(0, y);
        for (const Rgbe& pixel : row) {
            const float scale = pixel[3] ? std::ldexp(1.0f, pixel[3] - kExponentBias) : 0.0f;
            for (std::size_t c = 0; c < 3; ++c) *out++ = scale * static_cast<float>(pixel[c]);
        }
    }
    return image;
}

}  // namespace nullscope
