// What must hold of an OpenEXR file before the package may see it.
#include "image/exr_input.h"

#include <ImfHeader.h>
#include <ImfTileDescription.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <istream>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/text.h"
#include "image/image_formats.h"
#include "image/picture_formats.h"

namespace nullscope {
namespace {

constexpr long long kMaxSamples = 2'000'000'000;  // pixels times channels: 8 GB of floats
constexpr long long kMaxSide = 1 << 16;           // px; also of a tile
constexpr long long kMostLinesAtOnce = 256;       // DWAB; the other kinds of compression take fewer
constexpr long long kMaxBlock = 1 << 27;          // samples that the decoder holds at once: 256 lines, or a tile

constexpr std::string_view kMagic = "\x76\x2f\x31\x01";
constexpr std::uint32_t kSeveralParts = 0x1000;  // of the version's flags
constexpr std::size_t kLongestName = 255;        // bytes
constexpr std::size_t kChannelBytes = 16;        // after a channel's name

// OpenEXR reads these many bytes of a value of such a type, whatever size is announced.
constexpr std::array<std::pair<std::string_view, std::size_t>, 24> kSizes = {{
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
}};

class Bytes {
public:
    explicit Bytes(std::string_view rest) : rest_(rest) {}
    std::size_t size() const { return rest_.size(); }
    std::optional<std::string_view> take(std::size_t count) {
        if (count > rest_.size()) return std::nullopt;
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    std::optional<std::string_view> word() {  // up to a zero byte, which goes too
        const std::size_t end = rest_.substr(0, kLongestName + 1).find('\0');
        if (end == std::string_view::npos) return std::nullopt;
        const auto taken = take(end);
        rest_.remove_prefix(1);
        return taken;
    }
    std::optional<std::uint32_t> number() {
        const auto bytes = take(4);
        if (!bytes) return std::nullopt;
        return static_cast<std::uint32_t>(little_endian(*bytes));
    }

private:
    std::string_view rest_;
};

bool channels_hold(Bytes value) {
    for (auto name = value.word(); name; name = value.word()) {
        if (name->empty()) return value.size() == 0;
        if (!value.take(kChannelBytes)) return false;
    }
    return false;
}

bool preview_holds(Bytes value) {
    const auto width = value.number(), height = value.number();
    return width && height && *width < 65536 && *height < 65536 && std::uint64_t{4} * *width * *height == value.size();
}

bool strings_hold(Bytes value) {
    while (value.size() > 0)
        if (const auto length = value.number(); !length || !value.take(*length)) return false;
    return true;
}

bool value_holds(std::string_view type, std::string_view value) {
    const auto fixed = std::find_if(kSizes.begin(), kSizes.end(), [&](const auto& row) { return row.first == type; });
    if (fixed != kSizes.end()) return value.size() == fixed->second;
    if (type == "chlist") return channels_hold(Bytes(value));
    if (type == "preview") return preview_holds(Bytes(value));
    if (type == "stringvector") return strings_hold(Bytes(value));
    return type != "idmanifest";  // of deep pictures: not read here, and it announces an unpacked size of its own
}

// One header; its strings are added to texts. nullopt: cut off. An empty name is the first thing: no header.
std::optional<bool> header_is_there(Bytes& bytes, std::string& fault, Texts* texts = nullptr) {
    for (bool first = true;; first = false) {
        const auto name = bytes.word();
        if (!name) return std::nullopt;
        if (name->empty()) return !first;
        const auto type = bytes.word();
        const auto size = type ? bytes.number() : std::nullopt;
        const auto value = size ? bytes.take(*size) : std::nullopt;
        if (!value) return std::nullopt;
        if (!value_holds(*type, *value)) fault = without_controls(fmt::format("attribute {} is no {}", *name, *type));
        if (!fault.empty()) return false;
        if (texts != nullptr && *type == "string") (*texts)[std::string(*name)] = std::string(*value);
    }
}

// String attributes of the first part.
Result<Texts> exr_texts_of(std::istream& file) {
    std::string header(kMostTextBytes, '\0');
    file.read(header.data(), static_cast<std::streamsize>(header.size()));
    header.resize(static_cast<std::size_t>(file.gcount()));
    Bytes bytes(header);
    bytes.take(kMagic.size());
    Texts texts;
    std::string fault;
    const bool versioned = bytes.number().has_value();
    const auto there = header_is_there(bytes, fault, &texts);
    if (!versioned || !there) return bad_input("its header is cut off or damaged");
    if (!fault.empty()) return bad_input(fault);
    return texts;
}

}  // namespace

// The layout: "OpenEXR File Layout", openexr.com. Attributes are name, type (both end with a zero byte), size (four
// bytes, little-endian) and value; a header ends with an empty name, the headers of several parts with an empty header.
Status check_exr(std::string_view file) {
    Bytes bytes(file);
    if (!file.starts_with(kMagic)) return bad_input("not an OpenEXR file");
    bytes.take(kMagic.size());
    const auto version = bytes.number();
    std::string fault;
    for (bool more = true; more;) {
        const auto there = header_is_there(bytes, fault);
        if (!there || !version) return bad_input("its header is cut off or damaged");
        more = *there && (*version & kSeveralParts) != 0;
    }
    if (!fault.empty()) return bad_input(fault);
    return Done{};
}

void MemoryStream::seekg(std::uint64_t at) { at_ = at; }

bool MemoryStream::read(char* to, int count) {
    const auto wanted = static_cast<std::size_t>(count);
    if (at_ > bytes_.size() || wanted > bytes_.size() - at_) throw std::runtime_error("the file is cut off");
    std::copy_n(bytes_.data() + at_, wanted, to);
    at_ += wanted;
    return at_ < bytes_.size();
}

Status check_exr_part(const Imf::Header& header, long long channels, std::size_t file_bytes, long long max_pixels) {
    const Imath::Box2i& window = header.dataWindow();
    const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
    const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
    if (width <= 0 || height <= 0 || width > kMaxSide || height > kMaxSide || width * height > max_pixels ||
        channels * width * height > kMaxSamples)
        return bad_input(fmt::format("{} x {} pixels of {} channels, at most {} pixels are allowed", width, height,
                                     channels, max_pixels));
    if (!plausible_size(width * height * channels, file_bytes))
        return bad_input(
            fmt::format("{} x {} pixels of {} channels are not in {} bytes", width, height, channels, file_bytes));
    const bool tiled = header.hasTileDescription();
    const long long tile_width = tiled ? header.tileDescription().xSize : 1;
    const long long tile_height = tiled ? header.tileDescription().ySize : 1;
    const long long block = tiled ? tile_width * tile_height : kMostLinesAtOnce * width;
    if (tile_width > kMaxSide || tile_height > kMaxSide || block * channels > kMaxBlock)
        return bad_input("its blocks of pixels are too large");
    return Done{};
}

const PictureFormat kExrFormat = {
    .name = "EXR",
    .ending = ".exr",
    .other = "",
    .sample = Sample::kLight,
    .help = "linear light, optional ray data",
    .options = "--half --colour --raydata --derivatives --layers --st-map",
    .is = [](std::string_view bytes) { return bytes.starts_with(kMagic); },
    .texts = exr_texts_of,
};

}  // namespace nullscope
