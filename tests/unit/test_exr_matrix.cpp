// EXR files of every make: compression, type of numbers, tiles, parts, prefix, windows, alpha. Made and read by OpenEXR's own interface, and
// read as pictures: the same numbers.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTileDescription.h>
#include <ImfTiledOutputPart.h>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <half.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "image/large_image.h"
#include "support/temporary_folder.h"

namespace {

using namespace nullscope;
namespace fs = std::filesystem;

constexpr int kShownWide = 21, kShownHigh = 13;  // of the display window, px

enum class Windows { kSame, kSmaller, kMoved };  // of data: as the display's, within it, partly beside it
struct Make {
    Imf::Compression compression = Imf::ZIP_COMPRESSION;
    bool half = false, tiled = false, several = false, prefix = false, alpha = false;
    Windows windows = Windows::kSame;
};

Imath::Box2i data_window(Windows windows) {
    if (windows == Windows::kSame) return {{0, 0}, {kShownWide - 1, kShownHigh - 1}};
    if (windows == Windows::kSmaller) return {{3, 2}, {kShownWide - 5, kShownHigh - 3}};
    return {{-4, 5}, {kShownWide - 8, kShownHigh + 6}};
}

// Of a half float, so that it is the same number in both types.
float light_at(int x, int y, int channel) {
    return half(static_cast<float>(0.3 + 0.21 * std::sin(0.3 * x + channel) + 0.1 * std::cos(0.4 * y - channel)));
}

void save(const fs::path& path, const Make& make, float factor = 1.0f) {
    const Imath::Box2i window = data_window(make.windows);
    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    const std::string prefix = make.prefix ? "ViewLayer.Combined." : "";
    const Imf::PixelType type = make.half ? Imf::HALF : Imf::FLOAT;
    std::vector<std::string> names = {"R", "G", "B"};
    if (make.alpha) names.emplace_back("A");
    std::vector<std::vector<float>> floats(names.size());
    std::vector<std::vector<half>> halves(names.size());
    std::vector<Imf::Header> headers;
    Imf::FrameBuffer buffer;
    for (int part = 0; part < (make.several ? 2 : 1); ++part) {
        Imf::Header header({{0, 0}, {kShownWide - 1, kShownHigh - 1}}, window);
        header.compression() = make.compression;
        header.setName(part == 0 ? "beauty" : "depth");
        header.setType(make.tiled ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
        if (make.tiled) header.setTileDescription(Imf::TileDescription(8, 4));
        if (part == 1) header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
        for (std::size_t c = 0; part == 0 && c < names.size(); ++c)
            header.channels().insert(prefix + names[c], Imf::Channel(type));
        headers.push_back(header);
    }
    for (std::size_t c = 0; c < names.size(); ++c) {
        for (int y = window.min.y; y <= window.max.y; ++y)
            for (int x = window.min.x; x <= window.max.x; ++x)
                floats[c].push_back(factor * light_at(x, y, static_cast<int>(c)));
        halves[c].assign(floats[c].begin(), floats[c].end());
        const std::size_t size = make.half ? sizeof(half) : sizeof(float);
        void* base = make.half ? static_cast<void*>(halves[c].data()) : floats[c].data();
        buffer.insert(prefix + names[c],
                      Imf::Slice::Make(type, base, window, size, size * static_cast<std::size_t>(width)));
    }
    std::vector<float> depths(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 5.0f);
    Imf::FrameBuffer depth;
    depth.insert("Z", Imf::Slice::Make(Imf::FLOAT, depths.data(), window));
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
    for (int number = 0; number < static_cast<int>(headers.size()); ++number)
        if (make.tiled) {
            Imf::TiledOutputPart part(file, number);
            part.setFrameBuffer(number == 0 ? buffer : depth);
            part.writeTiles(0, part.numXTiles() - 1, 0, part.numYTiles() - 1);
        } else {
            Imf::OutputPart part(file, number);
            part.setFrameBuffer(number == 0 ? buffer : depth);
            part.writePixels(height);
        }
}

// What OpenEXR says of a channel of the first part, over its data window.
std::vector<float> own_reading(const fs::path& path, const std::string& channel) {
    Imf::MultiPartInputFile file(path.c_str());
    const Imath::Box2i window = file.header(0).dataWindow();
    const auto width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
    std::vector<float> values(width * static_cast<std::size_t>(window.max.y - window.min.y + 1));
    Imf::FrameBuffer buffer;
    buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, values.data(), window, sizeof(float), sizeof(float) * width));
    Imf::InputPart part(file, 0);
    part.setFrameBuffer(buffer);
    part.readPixels(window.min.y, window.max.y);
    return values;
}

// The largest difference of a picture's numbers from OpenEXR's, and from what was written; black and clear beside the data window.
struct Apart {
    float own = 0.0f, written = 0.0f;
};
Apart apart(const fs::path& path, const Make& make, const Image<float>& image) {
    const Imath::Box2i window = data_window(make.windows);
    const std::string prefix = make.prefix ? "ViewLayer.Combined." : "";
    Apart worst;
    for (int c = 0; c < image.channels; ++c) {
        const std::vector<float> own = own_reading(path, prefix + std::string(1, "RGBA"[c]));
        for (int y = 0; y < kShownHigh; ++y)
            for (int x = 0; x < kShownWide; ++x) {
                const float got = image.at(x, y)[c];
                const bool there = window.intersects(Imath::V2i{x, y});
                const int at = (y - window.min.y) * (window.max.x - window.min.x + 1) + x - window.min.x;
                worst.own = std::fmax(worst.own, std::fabs(got - (there ? own[static_cast<std::size_t>(at)] : 0.0f)));
                worst.written = std::fmax(worst.written, std::fabs(got - (there ? light_at(x, y, c) : 0.0f)));
            }
    }
    return worst;
}

template <class F>
void each_make(F f) {
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION,
          Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION, Imf::DWAA_COMPRESSION,
          Imf::DWAB_COMPRESSION})
        for (int bits = 0; bits < 32; ++bits)
            for (const Windows windows : {Windows::kSame, Windows::kSmaller, Windows::kMoved})
                f(Make{compression, (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0,
                       (bits & 16) != 0, windows});
}

TEST_CASE("EXR matrix: every make of file is read as OpenEXR reads it") {
    constexpr float kSame = 1e-6f, kLossy = 0.04f;  // what B44 itself loses of these: 0.027
    const TemporaryFolder folder("exr");
    const fs::path path = folder.path / "a.exr";
    int files = 0;
    each_make([&](const Make& make) {
        save(path, make);
        const auto picture = load_fitted_image(path, {.light = false});
        const std::string words =
            fmt::format("compression {} half {} tiled {} several {} prefix {} alpha {} windows {}{}",
                        static_cast<int>(make.compression), make.half, make.tiled, make.several, make.prefix,
                        make.alpha, static_cast<int>(make.windows), picture ? "" : ": " + picture.error().message());
        CAPTURE(words);
        REQUIRE(picture);
        const Image<float>& image = picture->image;
        REQUIRE(image.width == kShownWide);
        REQUIRE(image.height == kShownHigh);
        REQUIRE(image.channels == (make.alpha ? 4 : 3));
        const Apart worst = apart(path, make, image);
        const bool lossy = make.compression >= Imf::B44_COMPRESSION;
        CHECK(worst.own <= kSame);
        CHECK(worst.written <= (lossy ? kLossy : kSame));
        ++files;
    });
    CHECK(files == 960);
}

// Two pictures in one file, as layers of one part or as parts.
enum class Two { kLayers, kParts, kSameName };
void save_two(const fs::path& path, Two kind) {
    const auto write = [&](std::vector<Imf::Header> headers, const std::vector<std::vector<std::string>>& channels) {
        static const std::vector<float> kDark(kShownWide * kShownHigh, 0.25f), kBright(kShownWide * kShownHigh, 0.75f);
        std::vector<Imf::FrameBuffer> buffers(headers.size());
        for (std::size_t part = 0; part < headers.size(); ++part) {
            headers[part].setType(Imf::SCANLINEIMAGE);
            for (const std::string& name : channels[part]) {
                headers[part].channels().insert(name, Imf::Channel(Imf::FLOAT));
                const auto& values =
                    headers[part].name() == "bright" || name.starts_with("b.bright.") ? kBright : kDark;
                buffers[part].insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), headers[part].dataWindow()));
            }
        }
        Imf::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
        for (std::size_t part = 0; part < headers.size(); ++part) {
            Imf::OutputPart out(file, static_cast<int>(part));
            out.setFrameBuffer(buffers[part]);
            out.writePixels(kShownHigh);
        }
    };
    Imf::Header dark(kShownWide, kShownHigh), bright(kShownWide, kShownHigh);
    dark.setName("dark"), bright.setName("bright");
    const std::vector<std::string> light = {"light.R", "light.G", "light.B"};
    if (kind == Two::kSameName) return write({dark, bright}, {light, light});
    if (kind == Two::kParts) return write({dark, bright}, {{"R", "G", "B"}, light});
    write({dark},
          {{"a.dark.R", "a.dark.G", "a.dark.B", "b.bright.R", "b.bright.G", "b.bright.B", "n.X", "n.Y", "n.Z"}});
}

TEST_CASE("EXR layers: a name chooses, and what there is is told of") {
    const TemporaryFolder folder("layers");
    const fs::path layers = folder.path / "layers.exr", parts = folder.path / "parts.exr", png = folder.path / "a.png",
                   same = folder.path / "same.exr";
    save_two(layers, Two::kLayers), save_two(parts, Two::kParts), save_two(same, Two::kSameName);
    const auto light = [](const fs::path& file, const std::string& layer) {
        const auto picture = load_fitted_image(file, {.layer = layer});
        const std::string why = picture ? "" : picture.error().message();
        REQUIRE_MESSAGE(picture, why);
        return picture->image.at(3, 4)[1];
    };
    CHECK(light(layers, "a.dark") == 0.25f);
    CHECK(light(layers, "b.bright") == 0.75f);
    CHECK(light(parts, "") == 0.25f);  // the only one without a prefix
    CHECK(light(parts, "dark") == 0.25f);
    CHECK(light(parts, "bright") == 0.75f);
    CHECK(light(parts, "light") == 0.75f);
    CHECK(light(parts, "bright.light") == 0.75f);
    const auto refused = [](const fs::path& file, const std::string& layer) {
        const auto picture = load_fitted_image(file, {.layer = layer});
        REQUIRE_FALSE(picture);
        return picture.error().message();
    };
    CHECK(refused(layers, "").find("image_layer says which") != std::string::npos);
    CHECK(refused(layers, "c").find("it has \"a.dark\", \"b.bright\"") != std::string::npos);
    CHECK(refused(layers, "n").find("none of its pictures") != std::string::npos);  // a direction is no picture
    CHECK(light(same, "bright.light") == 0.75f);
    CHECK(refused(same, "light").find("several of its pictures") != std::string::npos);
    CHECK(refused(png, "c").find("EXR") != std::string::npos);
}

}  // namespace
