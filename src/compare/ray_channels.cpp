#include "compare/ray_channels.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace nullscope {
namespace {

struct Channel {
    const char* name;
    double (*get)(const RayPixel&);
    void (*set)(RayPixel&, double);
};

constexpr std::array<Channel, 12> kChannels = {{
    {"fate", [](const RayPixel& p) { return static_cast<double>(p.fate); },
     [](RayPixel& p, double v) { p.fate = static_cast<Fate>(static_cast<int>(v)); }},
    {"sky.x", [](const RayPixel& p) { return p.sky.x; }, [](RayPixel& p, double v) { p.sky.x = v; }},
    {"sky.y", [](const RayPixel& p) { return p.sky.y; }, [](RayPixel& p, double v) { p.sky.y = v; }},
    {"sky.z", [](const RayPixel& p) { return p.sky.z; }, [](RayPixel& p, double v) { p.sky.z = v; }},
    {"g", [](const RayPixel& p) { return p.g; }, [](RayPixel& p, double v) { p.g = v; }},
    {"delay", [](const RayPixel& p) { return p.delay; }, [](RayPixel& p, double v) { p.delay = v; }},
    {"angle", [](const RayPixel& p) { return p.angle; }, [](RayPixel& p, double v) { p.angle = v; }},
    {"order", [](const RayPixel& p) { return static_cast<double>(p.order); },
     [](RayPixel& p, double v) { p.order = static_cast<int>(v); }},
    {"hit", [](const RayPixel& p) { return static_cast<double>(p.hit); },
     [](RayPixel& p, double v) { p.hit = static_cast<int>(v); }},
    {"u", [](const RayPixel& p) { return p.u; }, [](RayPixel& p, double v) { p.u = v; }},
    {"v", [](const RayPixel& p) { return p.v; }, [](RayPixel& p, double v) { p.v = v; }},
    {"w", [](const RayPixel& p) { return p.w; }, [](RayPixel& p, double v) { p.w = v; }},
}};

}  // namespace

void add_ray_channels(const RayFrame& frame, ChannelImage& image) {
    for (const Channel& channel : kChannels) {
        auto& values = image.channels[channel.name];
        values.reserve(frame.pixels.size());
        for (const RayPixel& pixel : frame.pixels) values.push_back(static_cast<float>(channel.get(pixel)));
    }
}

Result<RayFrame> ray_frame_from(const ChannelImage& image) {
    RayFrame frame{image.width, image.height,
                   std::vector<RayPixel>(static_cast<std::size_t>(image.width) * image.height)};
    for (const Channel& channel : kChannels) {
        const auto found = image.channels.find(channel.name);
        if (found == image.channels.end() && channel.name == std::string_view("w"))
            continue;  // older files know discs only
        if (found == image.channels.end())
            return bad_input(fmt::format("no ray data: channel \"{}\" is missing", channel.name));
        for (std::size_t i = 0; i < frame.pixels.size(); ++i) channel.set(frame.pixels[i], found->second[i]);
    }
    return frame;
}

}  // namespace nullscope
