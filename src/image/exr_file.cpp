#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <ostream>
#include <utility>

#include "base/atomic_file.h"
#include "image/exr_input.h"
#include "image/half_float.h"
#include "image/image_file.h"
#include "image/image_formats.h"
#include "image/picture_texts.h"

namespace nullscope {
namespace {

// ffmpeg (5.1) draws black, without a word, what has a longer string attribute than some 490 bytes.
constexpr std::size_t kLongestAttribute = 240;

void add_texts(const Texts& texts, Imf::Header& header) {
    for (const auto& [name, text] : in_pieces(texts, kLongestAttribute))
        header.insert(name, Imf::StringAttribute(text));
}

void add_primaries(const std::optional<Primaries>& primaries, Imf::Header& header) {
    if (!primaries) return;
    const auto point = [](Chromaticity c) { return Imath::V2f(static_cast<float>(c.x), static_cast<float>(c.y)); };
    Imf::addChromaticities(
        header, {point(primaries->red), point(primaries->green), point(primaries->blue), point(primaries->white)});
}

// Throws what OpenEXR throws. Of a file with several parts, the first.
Result<ChannelImage> read_exr(std::string_view bytes, const std::string& name, long long max_pixels) {
    if (const Status checked = check_exr(bytes); !checked) return unreadable(name, checked.error().message());
    MemoryStream stream(bytes, name);
    // The headers alone: Imf::InputFile would at once make buffers as large as a header announces.
    Imf::MultiPartInputFile file(stream);
    const Imf::Header& header = file.header(0);
    long long channels = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
        ++channels;
        if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
            return unreadable(name, fmt::format("channel {} is subsampled", it.name()));
    }
    if (const Status fits = check_exr_part(header, channels, bytes.size(), max_pixels); !fits)
        return unreadable(name, fits.error().message());
    if (!file.partComplete(0)) return unreadable(name, "file is cut off");

    const Imath::Box2i window = header.dataWindow();
    ChannelImage image;
    image.width = window.max.x - window.min.x + 1;
    image.height = window.max.y - window.min.y + 1;
    const std::size_t width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
    Imf::FrameBuffer buffer;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
        std::vector<float>& values = image.channels[it.name()];
        values.resize(width * height);
        buffer.insert(it.name(),
                      Imf::Slice::Make(Imf::FLOAT, values.data(), window, sizeof(float), sizeof(float) * width));
    }
    for (auto it = header.begin(); it != header.end(); ++it)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
            image.attributes[it.name()] = text->value();
    image.attributes = put_together(std::move(image.attributes));
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
    add_texts(image.attributes, header);
    add_primaries(image.primaries, header);
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
    TRY(bytes, read_text(path, kMaxExrBytes));
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
    add_texts(image.attributes, header);
    add_primaries(image.primaries, header);
    FileStream stream(to, "");
    Imf::OutputFile file(stream, header);
    for (int y = 0; y < image.height;) {
        TRY(rows, rows_from(y));
        if (rows->width != image.width || rows->channels != 3 || rows->height < 1 || rows->height > image.height - y)
            return failed(fmt::format("a band of {}x{} from row {}", rows->width, rows->height, y));
        std::vector<half> halves;
        if (image.half) {
            halves.reserve(rows->data.size());
            for (const float light : rows->data)  // a half beyond its largest number would be infinite
                halves.emplace_back(std::clamp(light, -kMostHalf, kMostHalf));
        }
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
