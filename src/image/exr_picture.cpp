// The one picture that is in an OpenEXR file, whatever else is: "Technical Introduction to OpenEXR" and "Reading and Writing OpenEXR Image
// Files", openexr.com, for layers, parts, windows and chromaticities.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "image/colour_space.h"
#include "image/exr_input.h"
#include "image/image_formats.h"

namespace nullscope {
namespace {

constexpr long long kMostDisplaySide = 1 << 16;  // px
constexpr std::size_t kMostNames = 24;           // in an error or a note

// Channels of one part that make a picture.
struct ExrLayer {
    int part = 0;
    std::string prefix;                 // "ViewLayer.Combined." or empty
    std::vector<std::string> channels;  // R, G, B or Y, and A where there is one
};

bool is_deep(const Imf::Header& header) { return header.hasType() && Imf::isDeepData(header.type()); }

std::vector<std::string> channel_names(const Imf::Header& header) {
    std::vector<std::string> names;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) names.emplace_back(it.name());
    return names;
}

std::vector<ExrLayer> layers_of(const Imf::MultiPartInputFile& file) {
    std::vector<ExrLayer> layers;
    for (int part = 0; part < file.parts(); ++part) {
        if (is_deep(file.header(part))) continue;
        std::map<std::string, std::vector<std::string>> by_prefix;
        for (const std::string& name : channel_names(file.header(part))) {
            const std::size_t dot = name.rfind('.');
            const std::size_t start = dot == std::string::npos ? 0 : dot + 1;
            by_prefix[name.substr(0, start)].push_back(name.substr(start));
        }
        for (const auto& [prefix, names] : by_prefix) {
            const auto has = [&names = names](const char* name) { return std::ranges::count(names, name) > 0; };
            ExrLayer layer{part, prefix, {}};
            if (has("R") && has("G") && has("B"))
                layer.channels = {"R", "G", "B"};
            else if (has("Y") && !has("RY") && !has("BY") && !has("X") && !has("Z"))  // not a place or a direction
                layer.channels = {"Y"};
            else
                continue;
            if (has("A")) layer.channels.emplace_back("A");
            layers.push_back(std::move(layer));
        }
    }
    return layers;
}

std::string shortened(std::vector<std::string> names) {
    const std::size_t all = names.size();
    if (all > kMostNames) names.resize(kMostNames), names.push_back(fmt::format("{} more", all - kMostNames));
    return fmt::format("{}", fmt::join(names, ", "));
}

// "R, G, B, Z", or "part 1 (beauty): R, G, B; part 2 (depth): Z".
std::string contents_of(const Imf::MultiPartInputFile& file) {
    std::vector<std::string> parts;
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::Header& header = file.header(part);
        const std::string name = header.hasName() ? fmt::format(" ({})", header.name()) : "";
        const std::string deep = is_deep(header) ? " (deep)" : "", which = fmt::format("part {}{}: ", part + 1, name);
        parts.push_back((file.parts() > 1 ? which : "") + shortened(channel_names(header)) + deep);
    }
    return fmt::format("{}", fmt::join(parts, "; "));
}

// What a layer is called: its prefix, its part's name, or both.
std::vector<std::string> names_of(const Imf::MultiPartInputFile& file, const ExrLayer& layer) {
    const Imf::Header& header = file.header(layer.part);
    const std::string part = header.hasName() ? header.name() : "",
                      prefix = layer.prefix.substr(0, layer.prefix.empty() ? 0 : layer.prefix.size() - 1);
    std::vector<std::string> names;
    const std::string both = part.empty() || prefix.empty() ? "" : fmt::format("{}.{}", part, prefix);
    for (const std::string& name : {prefix, part, both})
        if (!name.empty()) names.push_back(name);
    return names;
}

// The only layer of that name; where several share it, as those of a part do, the one without a prefix.
Result<ExrLayer> named_layer(const Imf::MultiPartInputFile& file, const std::vector<ExrLayer>& layers,
                             const std::string& wanted, const std::string& name) {
    std::vector<const ExrLayer*> found;
    std::vector<std::string> all;
    for (const ExrLayer& layer : layers) {
        const auto names = names_of(file, layer);
        if (std::ranges::count(names, wanted) > 0) found.push_back(&layer);
        all.push_back(names.empty() ? "a picture without a name, read without image_layer"
                                    : fmt::format("\"{}\"", file.parts() > 1 ? names.back() : names.front()));
    }
    const bool none = found.empty();
    if (found.size() > 1) std::erase_if(found, [](const ExrLayer* layer) { return !layer->prefix.empty(); });
    if (found.size() == 1) return *found.front();
    return unreadable(name, fmt::format("image_layer \"{}\" is {}; it has {}", wanted,
                                        none ? "none of its pictures" : "several of its pictures",
                                        all.empty() ? "none: " + contents_of(file) : shortened(std::move(all))));
}

// The picture: what has no prefix, or the only one, or the only one that is called Combined, as Blender has it.
Result<ExrLayer> picture_layer(const Imf::MultiPartInputFile& file, const std::string& wanted,
                               const std::string& name) {
    const std::vector<ExrLayer> layers = layers_of(file);
    if (!wanted.empty()) return named_layer(file, layers, wanted, name);
    if (layers.empty())
        return unreadable(name, fmt::format("no channels R, G and B, or Y, of one name; it has {}", contents_of(file)));
    const auto only = [&](auto is_it) -> const ExrLayer* {
        if (std::ranges::count_if(layers, is_it) != 1) return nullptr;
        return &*std::ranges::find_if(layers, is_it);
    };
    const auto bare = [](const ExrLayer& layer) { return layer.prefix.empty(); };
    const auto combined = [](const ExrLayer& layer) {
        return layer.prefix == "Combined." || layer.prefix.ends_with(".Combined.");
    };
    if (layers.size() == 1) return layers.front();
    if (const ExrLayer* found = only(bare)) return *found;
    if (const ExrLayer* found = std::ranges::any_of(layers, bare) ? nullptr : only(combined)) return *found;
    return unreadable(name, fmt::format("several pictures, and none that is the file's: {}; image_layer says which",
                                        contents_of(file)));
}

// What of the file is not used, each a few words.
std::vector<std::string> unused_of(const Imf::MultiPartInputFile& file, const ExrLayer& layer, bool with_alpha) {
    std::vector<std::string> unused, others;
    for (int part = 0; part < file.parts(); ++part)
        for (const std::string& name : channel_names(file.header(part))) {
            const bool read =
                part == layer.part && std::ranges::any_of(layer.channels, [&](const std::string& channel) {
                    return name == layer.prefix + channel && (with_alpha || channel != "A");
                });
            const bool alpha = part == layer.part && name == layer.prefix + "A";  // told of by who leaves it out
            if (!read && !alpha)
                others.push_back(part == layer.part ? name : fmt::format("{} (part {})", name, part + 1));
        }
    if (!others.empty()) unused.push_back("channels " + shortened(std::move(others)));
    const Imf::Header& header = file.header(layer.part);
    if (header.pixelAspectRatio() != 1.0f)
        unused.push_back(fmt::format("pixelAspectRatio {}", header.pixelAspectRatio()));
    if (Imf::hasEnvmap(header) && Imf::envmap(header) == Imf::ENVMAP_CUBE) unused.emplace_back("envmap cube");
    const Imath::Box2i &data = header.dataWindow(), &shown = header.displayWindow();
    if (data.min.x < shown.min.x || data.min.y < shown.min.y || data.max.x > shown.max.x || data.max.y > shown.max.y)
        unused.emplace_back("pixels outside of its display window");
    return unused;
}

Result<Image<float>> decoded_layer(Imf::MultiPartInputFile& file, const ExrLayer& layer, const std::string& name) {
    const Imath::Box2i window = file.header(layer.part).dataWindow();
    const auto channels = static_cast<int>(layer.channels.size());
    Image<float> image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, channels);
    const std::size_t pixel = sizeof(float) * layer.channels.size();
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < layer.channels.size(); ++c) {
        const std::string channel = layer.prefix + layer.channels[c];
        const Imf::Channel& kind = file.header(layer.part).channels()[channel.c_str()];
        if (kind.xSampling != 1 || kind.ySampling != 1)
            return unreadable(name, fmt::format("channel {} is subsampled", channel));
        buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, image.data.data() + c, window, pixel,
                                                pixel * static_cast<std::size_t>(image.width)));
    }
    Imf::InputPart part(file, layer.part);
    part.setFrameBuffer(buffer);
    part.readPixels(window.min.y, window.max.y);
    return image;
}

// Its pixels where the display window has them, black and clear elsewhere; grey as three colours.
Image<float> displayed(const Image<float>& data, const Imath::Box2i& window, const Imath::Box2i& shown, bool grey) {
    Image<float> image(shown.max.x - shown.min.x + 1, shown.max.y - shown.min.y + 1, data.channels + (grey ? 2 : 0));
    const Imath::Box2i both({std::max(window.min.x, shown.min.x), std::max(window.min.y, shown.min.y)},
                            {std::min(window.max.x, shown.max.x), std::min(window.max.y, shown.max.y)});
    for (int y = both.min.y; y <= both.max.y; ++y)
        for (int x = both.min.x; x <= both.max.x; ++x) {
            const float* from = data.at(x - window.min.x, y - window.min.y);
            float* to = image.at(x - shown.min.x, y - shown.min.y);
            for (int c = 0; c < image.channels; ++c) to[c] = from[!grey ? c : c < 3 ? 0 : 1];
        }
    return image;
}

// Throws what OpenEXR throws.
Result<ExrPicture> read_exr_picture(std::string_view bytes, const std::string& name, long long max_pixels,
                                    bool with_alpha, const std::string& wanted) {
    if (const Status checked = check_exr(bytes); !checked) return unreadable(name, checked.error().message());
    MemoryStream stream(bytes, name);
    Imf::MultiPartInputFile file(stream);
    TRY(layer, picture_layer(file, wanted, name));
    ExrPicture picture;
    picture.unused = unused_of(file, *layer, with_alpha);
    picture.has_alpha = layer->channels.back() == "A";
    if (picture.has_alpha && !with_alpha) layer->channels.pop_back();
    const Imf::Header& header = file.header(layer->part);
    const Imath::Box2i shown = header.displayWindow(), window = header.dataWindow();
    if (const Status fits = check_exr_part(header, std::ssize(channel_names(header)), bytes.size(), max_pixels); !fits)
        return unreadable(name, fits.error().message());
    const long long width = static_cast<long long>(shown.max.x) - shown.min.x + 1,
                    height = static_cast<long long>(shown.max.y) - shown.min.y + 1;
    if (width <= 0 || height <= 0 || width > kMostDisplaySide || height > kMostDisplaySide ||
        width * height > max_pixels || !plausible_size(4 * width * height, bytes.size()))
        return unreadable(name, fmt::format("a display window of {} x {} pixels", width, height));
    if (!shown.intersects(window)) return unreadable(name, "its pixels lie outside of its display window");
    if (!file.partComplete(layer->part)) return unreadable(name, "file is cut off");
    TRY(data, decoded_layer(file, *layer, name));
    const bool grey = layer->channels.front() == "Y";
    picture.image = window == shown && !grey ? std::move(*data) : displayed(*data, window, shown, grey);
    if (Imf::hasChromaticities(header)) {
        const Imf::Chromaticities& c = Imf::chromaticities(header);
        picture.to_rec709 =
            rec709_from({{c.red.x, c.red.y}, {c.green.x, c.green.y}, {c.blue.x, c.blue.y}, {c.white.x, c.white.y}});
    }
    return picture;
}

}  // namespace

Result<ExrPicture> decode_exr_picture(std::string_view bytes, const std::string& name, long long max_pixels,
                                      bool with_alpha, const std::string& wanted) {
    try {
        return read_exr_picture(bytes, name, max_pixels, with_alpha, wanted);
    } catch (const std::exception& exception) {
        return unreadable(name, exception.what());
    }
}

Result<ExrPicture> load_exr_picture(const std::filesystem::path& path, long long max_pixels, bool with_alpha,
                                    const std::string& wanted) {
    TRY(bytes, read_text(path, kMaxExrBytes));
    return decode_exr_picture(*bytes, path.string(), max_pixels, with_alpha, wanted);
}

}  // namespace nullscope
