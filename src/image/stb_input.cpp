// TGA, BMP and PSD as pictures, by stb_image; sRGB-encoded. What it does not look at is looked at here: whether the file goes on to its end
// (stb_image takes what is missing for zeros), the direction of TGA's rows, palettes that begin late, colour profiles.
#include <array>
#include <climits>
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "image/image_file.h"
#include "image/image_formats.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_ONLY_PSD
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_NO_FAILURE_STRINGS
#include <stb/stb_image.h>

namespace nullscope {
namespace {

// Where a file ends too early there are bytes that end every run, and it is remembered.
struct StbSource {
    std::string_view rest;
    const char* buffer = nullptr;  // stb_image's own, which is filled ahead of need
    bool is_cut = false;
};

int stb_read(void* user, char* to, int most) {
    auto& source = *static_cast<StbSource*>(user);
    if (source.buffer == nullptr) source.buffer = to;
    const std::size_t size = source.rest.copy(to, static_cast<std::size_t>(most));
    source.rest.remove_prefix(size);
    const bool is_ahead = to == source.buffer && size > 0;
    if (is_ahead) return static_cast<int>(size);
    source.is_cut = source.is_cut || size < static_cast<std::size_t>(most);
    std::memset(to + size, 0xff, static_cast<std::size_t>(most) - size);
    return most;
}

void stb_skip(void* user, int count) {
    auto& source = *static_cast<StbSource*>(user);
    const std::size_t there = std::min(static_cast<std::size_t>(std::max(count, 0)), source.rest.size());
    source.is_cut = source.is_cut || count < 0 || there < static_cast<std::size_t>(count);
    source.rest.remove_prefix(there);
}

int stb_eof(void* user) { return static_cast<StbSource*>(user)->rest.empty() ? 1 : 0; }

constexpr stbi_io_callbacks kStbCalls{stb_read, stb_skip, stb_eof};

unsigned byte_at(std::string_view bytes, std::size_t at) {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0u;
}
unsigned word_at(std::string_view bytes, std::size_t at) { return byte_at(bytes, at) | byte_at(bytes, at + 1) << 8; }

// Truevision TGA File Format Specification 2.0: byte 17 has the direction of rows and the order of lines.
constexpr unsigned kTgaFromRight = 0x10, kTgaInterleaved = 0xc0;
constexpr std::size_t kTgaPaletteStart = 3, kTgaDescriptor = 17;

// Adobe Photoshop File Formats Specification: three sections, each behind its length, lie between the head and the merged picture.
constexpr std::size_t kPsdChannels = 12, kPsdHeight = 14, kPsdWidth = 18, kPsdDepth = 22, kPsdHead = 26;
bool is_deep_psd(std::string_view bytes) {
    return bytes.size() > kPsdHead && bytes.substr(kPsdDepth, 2) == std::string_view("\0\x10", 2);
}
// Where the merged picture begins, by its kind of compression; nothing: the file ends before.
std::optional<std::size_t> merged_psd(std::string_view bytes) {
    std::size_t at = kPsdHead;
    for (int section = 0; section < 3 && at + 4 <= bytes.size(); ++section) at += 4 + big_endian(bytes.substr(at, 4));
    return at + 2 <= bytes.size() ? std::optional(at) : std::nullopt;
}

// With red, green and blue alone: of a fourth channel stb_image takes for granted that it is alpha over white, and undoes that, beyond the range of
// its numbers too. merged: of these bytes. The data of channels follow each other, behind the lengths of all their rows if they are compressed.
std::string psd_of_three(std::string_view bytes, std::size_t merged) {
    std::string three(bytes);
    const std::size_t channels = big_endian(bytes.substr(kPsdChannels, 2)),
                      height = big_endian(bytes.substr(kPsdHeight, 4));
    const std::size_t lengths = merged + 2 + 6 * height;
    if (big_endian(bytes.substr(merged, 2)) == 1 && lengths < three.size())
        three.erase(lengths, 2 * height * (channels - 3));
    three.replace(kPsdChannels, 2, std::string_view("\0\3", 2));
    return three;
}

// Runs of bytes, as Apple's PackBits has them; nothing: they are not `size` bytes.
std::optional<std::string> unpacked_bits(std::string_view packed, std::size_t size) {
    std::string bytes;
    while (!packed.empty() && bytes.size() <= size) {
        const auto head = static_cast<signed char>(packed.front());
        packed.remove_prefix(1);
        const std::size_t count = head >= 0 ? head + 1u : 1u - head, taken = head >= 0 ? count : 1u;
        if (head == -128) continue;
        if (taken > packed.size()) return {};
        head >= 0 ? bytes.append(packed.substr(0, count)) : bytes.append(count, packed.front());
        packed.remove_prefix(taken);
    }
    return bytes.size() == size ? std::optional(bytes) : std::nullopt;
}

// Of 16 bits and red, green and blue, without compression, of which stb_image reads no other.
Result<std::string> psd_without_runs(std::string_view bytes, std::size_t merged, long long max_pixels) {
    const std::size_t width = big_endian(bytes.substr(kPsdWidth, 4)), height = big_endian(bytes.substr(kPsdHeight, 4));
    const std::size_t rows = 3 * height, lengths = merged + 2;
    if (width * height > static_cast<std::size_t>(max_pixels) ||
        !plausible_size(2LL * static_cast<long long>(rows) * static_cast<long long>(width), bytes.size()))
        return bad_input(fmt::format("{} x {} pixels are not in {} bytes, or more than {}", width, height, bytes.size(),
                                     max_pixels));
    std::string whole(bytes.substr(0, merged));
    whole.append(2, '\0');
    std::size_t at = lengths + 2 * rows;
    for (std::size_t row = 0; row < rows && at <= bytes.size(); ++row) {
        const std::size_t length = big_endian(bytes.substr(lengths + 2 * row, 2));
        const auto line = unpacked_bits(bytes.substr(at, length), 2 * width);
        if (!line) return bad_input("a damaged row, or it is cut off");
        whole += *line, at += length;
    }
    return whole;
}

bool is_bmp(std::string_view bytes) { return bytes.starts_with("BM"); }
bool is_psd(std::string_view bytes) { return bytes.starts_with("8BPS"); }

std::vector<std::string> unused_of_stb(std::string_view bytes) {
    constexpr std::size_t kBmpHead = 14, kBmpSpace = kBmpHead + 56, kBmpV4 = 108;
    constexpr std::string_view kPsdProfile("8BIM\x04\x0f", 6);
    if (is_psd(bytes) && bytes.find(kPsdProfile) != std::string_view::npos) return {"a colour profile"};
    if (is_bmp(bytes) && word_at(bytes, kBmpHead) >= kBmpV4) {
        const std::string_view space = bytes.substr(std::min(kBmpSpace, bytes.size()), 4);
        if (space != "BGRs" && space != " niW") return {"a colour space of its own"};
    }
    return {};
}

// Of 8 or 16 bits, 3 or 4 channels.
template <class T>
void add_light(const T* codes, Image<float>& image) {
    constexpr auto kMost = static_cast<float>(std::numeric_limits<T>::max());
    std::vector<float> light(static_cast<std::size_t>(kMost) + 1);
    for (std::size_t code = 0; code < light.size(); ++code)
        light[code] = linear_from_srgb(static_cast<float>(code) / kMost);
    for (std::size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = image.channels == 4 && i % 4 == 3 ? static_cast<float>(codes[i]) / kMost : light[codes[i]];
}

Result<WholePicture> decode_by_stb(std::string_view bytes, long long max_pixels, const char* kinds) {
    const auto not_read = [&] { return bad_input(fmt::format("damaged, or not one of {}", kinds)); };
    StbSource head{bytes}, file{bytes};
    int width = 0, height = 0, channels = 0;
    if (stbi_info_from_callbacks(&kStbCalls, &head, &width, &height, &channels) == 0) return not_read();
    const long long pixels = static_cast<long long>(width) * std::abs(static_cast<long long>(height));
    if (width <= 0 || height == 0 || pixels > max_pixels)
        return bad_input(fmt::format("{} x {} pixels, at most {} are allowed", width, height, max_pixels));
    if (!plausible_size(pixels * channels, bytes.size()))
        return bad_input(fmt::format("{} x {} pixels are not in {} bytes", width, height, bytes.size()));
    const bool is_deep = is_psd(bytes) && is_deep_psd(bytes);  // which stb_image 2.27 finds only with MSVC
    const int wanted = channels % 2 == 0 ? 4 : 3;
    const std::unique_ptr<void, decltype(&stbi_image_free)> codes(
        is_deep ? static_cast<void*>(stbi_load_16_from_callbacks(&kStbCalls, &file, &width, &height, &channels, wanted))
                : stbi_load_from_callbacks(&kStbCalls, &file, &width, &height, &channels, wanted),
        stbi_image_free);
    if (codes == nullptr) return not_read();
    if (file.is_cut) return bad_input("it is cut off");
    WholePicture picture{Image<float>(width, height, wanted)};
    if (is_deep)
        add_light(static_cast<const stbi_us*>(codes.get()), picture.image);
    else
        add_light(static_cast<const stbi_uc*>(codes.get()), picture.image);
    picture.unused = unused_of_stb(bytes);
    return picture;
}

Result<WholePicture> decode_psd(std::string_view bytes, long long max_pixels) {
    constexpr const char* kKinds = "the PSD files that are read: RGB of 8 or 16 bits, with a merged picture";
    const auto merged = merged_psd(bytes);
    if (!merged) return bad_input("it is cut off");
    const bool has_more = big_endian(bytes.substr(kPsdChannels, 2)) > 3;
    std::string changed = has_more ? psd_of_three(bytes, *merged) : std::string();
    if (is_deep_psd(bytes) && big_endian(bytes.substr(*merged, 2)) == 1) {
        TRY(whole, psd_without_runs(has_more ? changed : bytes, *merged, max_pixels));
        changed = std::move(*whole);
    } else if (big_endian(bytes.substr(*merged, 2)) > 1) {
        return bad_input("a PSD whose merged picture is compressed by ZIP", "none, or runs");
    }
    auto picture = decode_by_stb(changed.empty() ? bytes : changed, max_pixels, kKinds);
    if (!has_more) return picture;
    if (picture) picture->unused.emplace_back("channels beside red, green and blue");
    return picture;
}

}  // namespace

bool is_by_stb(std::string_view bytes) {
    if (is_bmp(bytes) || is_psd(bytes)) return true;
    StbSource head{bytes};
    return stbi_info_from_callbacks(&kStbCalls, &head, nullptr, nullptr, nullptr) != 0 && !head.is_cut;
}

Result<WholePicture> decode_stb(std::string_view bytes, long long max_pixels) {
    if (is_bmp(bytes))
        return decode_by_stb(bytes, max_pixels, "the BMP files that are read: not compressed, 1 to 32 bits a pixel");
    if (is_psd(bytes)) return decode_psd(bytes, max_pixels);
    const unsigned descriptor = byte_at(bytes, kTgaDescriptor);
    if (byte_at(bytes, 1) == 1 && word_at(bytes, kTgaPaletteStart) != 0)
        return bad_input("a TGA palette that does not begin with its first entry");
    if ((descriptor & kTgaInterleaved) != 0) return bad_input("a TGA of interleaved lines");
    auto picture = decode_by_stb(bytes, max_pixels, "the TGA files that are read: 8 to 32 bits a pixel");
    if (picture && (descriptor & kTgaFromRight) != 0) picture->orientation = 2;
    return picture;
}

}  // namespace nullscope
