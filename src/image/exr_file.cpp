#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfTileDescription.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "base/atomic_file.h"
#include "base/text.h"
#include "image/image_file.h"
#include "image/image_formats.h"

namespace nullscope {
namespace {

constexpr long long kMaxSamples = 2'000'000'000;  // pixels times channels: 8 GB of floats
constexpr std::size_t kMaxFileBytes = std::size_t{8} << 30;
constexpr long long kMaxSide = 1 << 16;      // px; also of a tile
constexpr long long kMostLinesAtOnce = 256;  // DWAB; the other kinds of compression take fewer
constexpr long long kMaxBlock = 1 << 27;     // samples that the decoder holds at once: 256 lines, or a tile

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

// One header. nullopt: cut off. An empty name is the first thing: no header.
std::optional<bool> header_is_there(Bytes& bytes, std::string& fault) {
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
    }
}

// What must hold of the headers before OpenEXR may see them. OpenEXR (3.1) allocates whatever size an attribute
// announces, up to 2 GB, before it looks whether the file goes on for so long. Errors (without a file name): not an
// OpenEXR file, cut off, an attribute whose size is not that of its type or of what is in it.
//
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

// A file in memory, as OpenEXR wants it.
class MemoryStream final : public Imf::IStream {
public:
    MemoryStream(std::string_view bytes, const std::string& name) : IStream(name.c_str()), bytes_(bytes) {}
    bool read(char* to, int count) override {
        const auto wanted = static_cast<std::size_t>(count);
        if (at_ > bytes_.size() || wanted > bytes_.size() - at_) throw std::runtime_error("the file is cut off");
        std::copy_n(bytes_.data() + at_, wanted, to);
        at_ += wanted;
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t at) override { at_ = at; }

private:
    std::string_view bytes_;
    std::uint64_t at_ = 0;
};

// Throws what OpenEXR throws. Of a file with several parts, the first.
Result<ChannelImage> read_exr(std::string_view bytes, const std::string& name, long long max_pixels) {
    if (const Status checked = check_exr(bytes); !checked) return unreadable(name, checked.error().message());
    MemoryStream stream(bytes, name);
    // The headers alone: Imf::InputFile would at once make buffers as large as a header announces.
    Imf::MultiPartInputFile file(stream);
    const Imf::Header& header = file.header(0);
    const Imath::Box2i window = header.dataWindow();
    const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
    const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
    long long channels = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
        ++channels;
        if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
            return unreadable(name, fmt::format("channel {} is subsampled", it.name()));
    }
    if (width <= 0 || height <= 0 || width > kMaxSide || height > kMaxSide || width * height > max_pixels ||
        channels * width * height > kMaxSamples)
        return unreadable(name, fmt::format("{} x {} pixels of {} channels, at most {} pixels are allowed", width,
                                            height, channels, max_pixels));
    if (!plausible_size(width * height * channels, bytes.size()))
        return unreadable(name, fmt::format("{} x {} pixels of {} channels are not in {} bytes", width, height,
                                            channels, bytes.size()));
    const bool tiled = header.hasTileDescription();
    const long long tile_width = tiled ? header.tileDescription().xSize : 1;
    const long long tile_height = tiled ? header.tileDescription().ySize : 1;
    const long long block = tiled ? tile_width * tile_height : kMostLinesAtOnce * width;
    if (tile_width > kMaxSide || tile_height > kMaxSide || block * channels > kMaxBlock)
        return unreadable(name, "its blocks of pixels are too large");
    if (!file.partComplete(0)) return unreadable(name, "file is cut off");

    ChannelImage image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    Imf::FrameBuffer buffer;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
        std::vector<float>& values = image.channels[it.name()];
        values.resize(static_cast<std::size_t>(width * height));
        buffer.insert(it.name(), Imf::Slice::Make(Imf::FLOAT, values.data(), window, sizeof(float),
                                                  sizeof(float) * static_cast<std::size_t>(width)));
    }
    for (auto it = header.begin(); it != header.end(); ++it)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
            image.attributes[it.name()] = text->value();
    Imf::InputPart part(file, 0);
    part.setFrameBuffer(buffer);
    part.readPixels(window.min.y, window.max.y);
    return image;
}

// Throws what OpenEXR throws. Encoded in memory: OpenEXR's destructors swallow write errors of files.
std::string encode_exr(const ChannelImage& image) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer buffer;
    for (const auto& [name, values] : image.channels) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        char* base = const_cast<char*>(reinterpret_cast<const char*>(values.data()));  // only read from
        buffer.insert(
            name, Imf::Slice(Imf::FLOAT, base, sizeof(float), sizeof(float) * static_cast<std::size_t>(image.width)));
    }
    for (const auto& [name, text] : image.attributes) header.insert(name, Imf::StringAttribute(text));
    Imf::StdOSStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(buffer);
        file.writePixels(image.height);
    }
    return stream.str();
}

}  // namespace

Result<ChannelImage> decode_exr(std::string_view bytes, const std::string& name, long long max_pixels) {
    try {
        return read_exr(bytes, name, max_pixels);
    } catch (const std::exception& exception) {
        return unreadable(name, exception.what());
    }
}

Result<ChannelImage> load_exr(const std::filesystem::path& path, long long max_pixels) {
    TRY(bytes, read_text(path, kMaxFileBytes));
    return decode_exr(*bytes, path.string(), max_pixels);
}

Status save_exr(const std::filesystem::path& path, const ChannelImage& image) {
    const auto invalid = [&](const std::string& reason) {
        return failed(fmt::format("cannot write '{}': {}", path.string(), reason));
    };
    if (image.width <= 0 || image.height <= 0 || image.channels.empty()) return invalid("an empty image");
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (const auto& [name, values] : image.channels)
        if (values.size() != count)
            return invalid(fmt::format("channel {} has {} values instead of {}", name, values.size(), count));
    std::string bytes;
    try {
        bytes = encode_exr(image);
    } catch (const std::exception& exception) {
        return invalid(exception.what());
    }
    return write_text_atomically(path, bytes);
}

namespace {

// Errors are kept by the stream, for OpenEXR's destructors swallow them.
class FileStream final : public Imf::OStream {
public:
    FileStream(std::ostream& to, const std::string& name) : OStream(name.c_str()), to_(to) {}
    void write(const char* from, int count) override { to_.write(from, count); }
    uint64_t tellp() override { return static_cast<uint64_t>(to_.tellp()); }
    void seekp(uint64_t at) override { to_.seekp(static_cast<std::streamoff>(at)); }

private:
    std::ostream& to_;
};

// Throws what OpenEXR throws.
Status write_bands(std::ostream& to, const BandedImage& image,
                   const std::function<Result<Image<float>>(int y)>& rows_from) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : {"R", "G", "B"})
        header.channels().insert(name, Imf::Channel(image.half ? Imf::HALF : Imf::FLOAT));
    for (const auto& [name, text] : image.attributes) header.insert(name, Imf::StringAttribute(text));
    FileStream stream(to, "");
    Imf::OutputFile file(stream, header);
    for (int y = 0; y < image.height;) {
        TRY(rows, rows_from(y));
        if (rows->width != image.width || rows->channels != 3 || rows->height < 1 || rows->height > image.height - y)
            return failed(fmt::format("a band of {}x{} from row {}", rows->width, rows->height, y));
        std::vector<half> halves;
        if (image.half) halves.assign(rows->data.begin(), rows->data.end());
        const std::size_t size = image.half ? sizeof(half) : sizeof(float),
                          row = 3 * size * static_cast<std::size_t>(image.width);
        char* base = image.half ? reinterpret_cast<char*>(halves.data()) : reinterpret_cast<char*>(rows->data.data());
        Imf::FrameBuffer buffer;
        const Imath::Box2i window({0, y}, {image.width - 1, y + rows->height - 1});
        for (const char* name : {"R", "G", "B"}) {
            buffer.insert(name, Imf::Slice::Make(image.half ? Imf::HALF : Imf::FLOAT, base, window, 3 * size, row));
            base += size;
        }
        file.setFrameBuffer(buffer);
        file.writePixels(rows->height);
        if (!to) break;
        y += rows->height;
    }
    return Done{};
}

}  // namespace

Status save_exr_bands(const std::filesystem::path& path, const BandedImage& image,
                      const std::function<Result<Image<float>>(int y)>& rows_from) {
    return write_stream_atomically(path, [&](std::ostream& to) -> Status {
        try {
            return write_bands(to, image, rows_from);
        } catch (const std::exception& exception) {
            return failed(fmt::format("cannot write '{}': {}", path.string(), exception.what()));
        }
    });
}

}  // namespace nullscope
