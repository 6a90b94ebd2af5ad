#include "compare/ray_channels.h"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

namespace nullscope {
namespace {

struct Names {
    const char *alone, *beside_layers, *old;
};
constexpr Names same(const char* name) { return {name, name, name}; }
constexpr std::array<Names, 12> kNames = {{same("fate"),
                                           {"sky.x", "direction.x", "sky.x"},
                                           {"sky.y", "direction.y", "sky.y"},
                                           {"sky.z", "direction.z", "sky.z"},
                                           {"ray.shift", "ray.shift", "g"},
                                           same("delay"),
                                           same("angle"),
                                           same("order"),
                                           same("hit"),
                                           {"ray.hit_u", "place.x", "u"},
                                           {"ray.hit_v", "place.y", "v"},
                                           {"ray.hit_w", "place.z", "w"}}};

// work(channel, member), in the order of the names.
template <class Pixel, class Work>
void each_channel(Pixel& p, const Work& work) {
    std::size_t channel = 0;
    const auto all = [&](auto&... members) { (work(channel++, members), ...); };
    all(p.fate, p.sky.x, p.sky.y, p.sky.z, p.g, p.delay, p.angle, p.order, p.hit, p.u, p.v, p.w);
}

const std::vector<float>* values_of(const ChannelImage& image, const Names& names) {
    for (const char* name : {names.alone, names.beside_layers, names.old})
        if (const auto found = image.channels.find(name); found != image.channels.end()) return &found->second;
    return nullptr;
}

}  // namespace

void add_ray_channels(const RayFrame& frame, RayNames names, ChannelImage& image) {
    std::array<std::vector<float>*, kNames.size()> values;
    for (std::size_t c = 0; c < kNames.size(); ++c)
        values[c] = &image.channels[names == RayNames::kAlone ? kNames[c].alone : kNames[c].beside_layers];
    for (auto* channel : values) channel->reserve(frame.pixels.size());
    for (const RayPixel& pixel : frame.pixels)
        each_channel(pixel, [&](std::size_t c, auto member) { values[c]->push_back(static_cast<float>(member)); });
}

Result<RayFrame> ray_frame_from(const ChannelImage& image) {
    RayFrame frame{image.width, image.height,
                   std::vector<RayPixel>(static_cast<std::size_t>(image.width) * image.height)};
    std::array<const std::vector<float>*, kNames.size()> values{};
    for (std::size_t c = 0; c < kNames.size(); ++c) {
        values[c] = values_of(image, kNames[c]);
        if (values[c] == nullptr && kNames[c].old != std::string_view("w"))  // older files know discs only
            return bad_input(fmt::format("no ray data: channel \"{}\" is missing", kNames[c].alone));
    }
    for (std::size_t i = 0; i < frame.pixels.size(); ++i)
        each_channel(frame.pixels[i], [&]<class T>(std::size_t c, T& member) {
            if (values[c]) member = static_cast<T>((*values[c])[i]);
        });
    return frame;
}

}  // namespace nullscope
