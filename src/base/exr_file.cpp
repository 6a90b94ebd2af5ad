#include "base/exr_file.h"

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
#include <cstdint>
#include <exception>
#include <stdexcept>

#include "base/atomic_file.h"
#include "base/exr_check.h"
#include "base/text.h"

namespace nullscope {
namespace {

constexpr long long kMaxPixels = 500'000'000;     // as load_image
constexpr long long kMaxSamples = 2'000'000'000;  // pixels times channels: 8 GB of floats
constexpr std::size_t kMaxFileBytes = std::size_t{8} << 30;
constexpr long long kMaxSide = 1 << 16;      // px; also of a tile
constexpr long long kMostLinesAtOnce = 256;  // DWAB; the other kinds of compression take fewer
constexpr long long kMaxBlock = 1 << 27;     // samples that the decoder holds at once: 256 lines, or a tile

Error unreadable(const std::string& name, const std::string& reason) {
    return bad_input(without_controls(fmt::format("cannot read image '{}': {}", name, reason)));
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
    if (const Status checked = check_exr(bytes); !checked) return unreadable(name, checked.error().message);
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

Result<ChannelImage> load_exr_limited(const std::filesystem::path& path, long long max_pixels) {
    const Result<std::string> bytes = read_text(path, kMaxFileBytes);
    if (!bytes) return bytes.error();
    return decode_exr(*bytes, path.string(), max_pixels);
}

Result<ChannelImage> load_exr(const std::filesystem::path& path) { return load_exr_limited(path, kMaxPixels); }

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

}  // namespace nullscope
