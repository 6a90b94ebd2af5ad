#include "compare/ray_channels.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace nullscope {
namespace {

constexpr std::array<const char*, 12> kNames = {"fate",  "sky.x", "sky.y", "sky.z", "g", "delay",
                                                "angle", "order", "hit",   "u",     "v", "w"};

// work(channel, member), in the order of the names.
template <class Pixel, class Work>
void each_channel(Pixel& p, const Work& work) {
    std::size_t channel = 0;
    const auto all = [&](auto&... members) { (work(channel++, members), ...); };
    all(p.fate, p.sky.x, p.sky.y, p.sky.z, p.g, p.delay, p.angle, p.order, p.hit, p.u, p.v, p.w);
}

}  // namespace

void add_ray_channels(const RayFrame& frame, ChannelImage& image) {
    std::array<std::vector<float>*, kNames.size()> values;
    for (std::size_t c = 0; c < kNames.size(); ++c) values[c] = &image.channels[kNames[c]];
    for (auto* channel : values) channel->reserve(frame.pixels.size());
    for (const RayPixel& pixel : frame.pixels)
        each_channel(pixel, [&](std::size_t c, auto member) { values[c]->push_back(static_cast<float>(member)); });
}

Result<RayFrame> ray_frame_from(const ChannelImage& image) {
    RayFrame frame{image.width, image.height,
                   std::vector<RayPixel>(static_cast<std::size_t>(image.width) * image.height)};
    std::array<const std::vector<float>*, kNames.size()> values{};
    for (std::size_t c = 0; c < kNames.size(); ++c) {
        const auto found = image.channels.find(kNames[c]);
        if (found != image.channels.end())
            values[c] = &found->second;
        else if (kNames[c] != std::string_view("w"))  // older files know discs only
            return bad_input(fmt::format("no ray data: channel \"{}\" is missing", kNames[c]));
    }
    for (std::size_t i = 0; i < frame.pixels.size(); ++i)
        each_channel(frame.pixels[i], [&]<class T>(std::size_t c, T& member) {
            if (values[c]) member = static_cast<T>((*values[c])[i]);
        });
    return frame;
}

}  // namespace nullscope
