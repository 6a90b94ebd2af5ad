#include "base/exr_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <exception>

#include "base/atomic_file.h"

namespace nullscope {
namespace {

constexpr long long kMaxPixels = 500'000'000;     // as load_image
constexpr long long kMaxSamples = 2'000'000'000;  // pixels times channels: 8 GB of floats
constexpr long long kMaxSide = 1 << 20;           // the width alone sets the decoder's line buffers

Error unreadable(const std::filesystem::path& path, const std::string& reason) {
    return bad_input(fmt::format("cannot read image '{}': {}", path.string(), reason));
}

// Throws what OpenEXR throws.
Result<ChannelImage> read_exr(const std::filesystem::path& path, long long max_pixels) {
    Imf::InputFile file(path.c_str());
    const Imf::Header& header = file.header();
    const Imath::Box2i window = header.dataWindow();
    const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
    const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
    long long channels = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
        ++channels;
        if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
            return unreadable(path, fmt::format("channel {} is subsampled", it.name()));
    }
    if (width <= 0 || height <= 0 || width > kMaxSide || height > kMaxSide || width * height > max_pixels ||
        channels * width * height > kMaxSamples)
        return unreadable(path, fmt::format("{} x {} pixels of {} channels, at most {} pixels are allowed", width,
                                            height, channels, max_pixels));
    if (!file.isComplete()) return unreadable(path, "file is cut off");

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
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return image;
}

// Throws what OpenEXR throws. Encoded in memory: OpenEXR's destructors swallow write errors of files.
std::string encode_exr(const ChannelImage& image) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::PIZ_COMPRESSION;
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

Result<ChannelImage> load_exr_limited(const std::filesystem::path& path, long long max_pixels) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) return unreadable(path, "no such file");
    if (!std::filesystem::is_regular_file(status)) return unreadable(path, "not a regular file");
    try {
        return read_exr(path, max_pixels);
    } catch (const std::exception& exception) {
        return unreadable(path, exception.what());
    }
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
