// The Radiance half of image/image_file.h.
// Format: Ward, "Real Pixels", Graphics Gems II (1991), and the Radiance reference manual: RGBE scanlines, plain or
// run-length coded, by pixel or by component; rows first ("-Y height +X width" is what writers produce).
#include "image/colour_space.h"
#include "image/image_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace nullscope {
namespace {

constexpr int kMinCodedWidth = 8, kMaxCodedWidth = 0x7fff;  // scanlines outside are always plain
constexpr int kExponentBias = 128 + 8;                      // mantissas are integers of 8 bits

using Rgbe = std::array<unsigned char, 4>;

unsigned char next(std::string_view& bytes) {
    const auto value = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    return value;
}

std::string next_line(std::string_view& bytes) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    std::string text(bytes.substr(0, end));
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    return text;
}

// Pixel by pixel, or in the older runs: a pixel of (1, 1, 1, n) stands for n times the one before it; of several in a row each has the next
// eight bits of the count.
bool read_plain(std::string_view& bytes, std::vector<Rgbe>& row) {
    constexpr int kMostShift = 24;
    int shift = 0;
    for (std::size_t x = 0; x < row.size();) {
        Rgbe pixel;
        if (bytes.size() < pixel.size()) return false;
        std::memcpy(pixel.data(), bytes.data(), pixel.size());
        bytes.remove_prefix(pixel.size());
        if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
            row[x++] = pixel, shift = 0;
            continue;
        }
        const std::size_t count = static_cast<std::size_t>(pixel[3]) << shift;
        if (x == 0 || shift > kMostShift || count > row.size() - x) return false;
        std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
        x += count, shift += 8;
    }
    return true;
}

// A count above 128 repeats one value count - 128 times, any other copies that many. False if cut or inconsistent.
bool read_coded(std::string_view& bytes, std::vector<Rgbe>& row) {
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t x = 0; x < row.size();) {
            if (bytes.empty()) return false;
            const int code = next(bytes);
            const bool run = code > 128;
            const auto count = static_cast<std::size_t>(run ? code - 128 : code);
            if (count == 0 || count > row.size() - x || bytes.size() < (run ? 1 : count)) return false;
            const unsigned char value = run ? next(bytes) : static_cast<unsigned char>(0);
            for (std::size_t i = 0; i < count; ++i) row[x++][c] = run ? value : next(bytes);
        }
    return true;
}

bool read_scanline(std::string_view& bytes, std::vector<Rgbe>& row) {
    const int width = static_cast<int>(row.size());
    const std::array<char, 4> mark{2, 2, static_cast<char>(width >> 8), static_cast<char>(width & 0xff)};
    if (width < kMinCodedWidth || width > kMaxCodedWidth || !bytes.starts_with({mark.data(), mark.size()}))
        return read_plain(bytes, row);
    bytes.remove_prefix(mark.size());
    return read_coded(bytes, row);
}

// What a line of the header says of the light. Programs agree on the numbers as they are stored, not on these factors (EXPOSURE is what the
// picture has been multiplied by): they are told of where they are not 1.
void read_light(const std::string& line, WholePicture& picture) {
    if (line.starts_with("PRIMARIES=")) {
        Primaries p;
        if (std::sscanf(line.c_str(), "PRIMARIES= %lf %lf %lf %lf %lf %lf %lf %lf", &p.red.x, &p.red.y, &p.green.x,
                        &p.green.y, &p.blue.x, &p.blue.y, &p.white.x, &p.white.y) == 8)
            picture.to_rec709 = rec709_from(p);
        else
            picture.unused.push_back(line + ": not eight numbers");
        return;
    }
    for (const std::string_view key : {"EXPOSURE=", "COLORCORR=", "GAMMA=", "PIXASPECT="})
        if (line.starts_with(key)) {
            double n[3] = {1.0, 1.0, 1.0};
            std::sscanf(line.c_str() + key.size(), "%lf %lf %lf", &n[0], &n[1], &n[2]);
            if (n[0] != 1.0 || n[1] != 1.0 || n[2] != 1.0)
                picture.unused.push_back(line + ": numbers are read as stored");
        }
}

}  // namespace

bool is_hdr(std::string_view bytes) { return bytes.starts_with("#?RADIANCE\n") || bytes.starts_with("#?RGBE\n"); }

Result<WholePicture> decode_hdr(std::string_view file, long long max_pixels) {
    std::string_view bytes = file;
    WholePicture picture;
    for (std::string line = next_line(bytes); !line.empty(); line = next_line(bytes)) {
        if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
            return bad_input(fmt::format("unsupported HDR {}", line));
        read_light(line, picture);
    }
    int width = 0, height = 0;
    char down[2], along[2];
    if (std::sscanf(next_line(bytes).c_str(), "%1[+-]Y %9d %1[+-]X %9d", down, &height, along, &width) != 4 ||
        width <= 0 || height <= 0)
        return bad_input("HDR size is not '-Y height +X width'");
    if (static_cast<long long>(width) * height > max_pixels)
        return bad_input(fmt::format("{} x {} pixels, at most {} are allowed", width, height, max_pixels));
    if (!plausible_size(3LL * width * height, file.size()))
        return bad_input(fmt::format("{} x {} pixels are not in {} bytes", width, height, file.size()));
    picture.orientation = *down == '-' ? (*along == '+' ? 1 : 2) : (*along == '-' ? 3 : 4);
    Image<float>& image = picture.image = Image<float>(width, height, 3);
    std::vector<Rgbe> row(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        if (!read_scanline(bytes, row)) return bad_input("HDR data are cut off or damaged");
        float* out = image.at(0, y);
        for (const Rgbe& pixel : row) {
            const float scale = pixel[3] ? std::ldexp(1.0f, pixel[3] - kExponentBias) : 0.0f;
            for (std::size_t c = 0; c < 3; ++c) *out++ = scale * static_cast<float>(pixel[c]);
        }
    }
    return picture;
}

}  // namespace nullscope
