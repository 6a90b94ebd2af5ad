#include "command/derivative_channels.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>

#include "gradient/picture_motion.h"

namespace nullscope::cli {
namespace {

constexpr std::array<const char*, 7> kDerivativeNames = {"x", "y", "z", "shift", "delay", "right", "down"};

// In the order of the names.
std::array<double, kDerivativeNames.size()> channel_values(const PictureMotion::ByKey& by, const RayPixel& ray) {
    std::array<double, kDerivativeNames.size()> values{};
    if (ray.fate == Fate::kEscaped) values = {by.sky.x, by.sky.y, by.sky.z, by.shift, by.delay, 0.0, 0.0};
    if (by.move) values[5] = by.move->right, values[6] = by.move->down;
    return values;
}

}  // namespace

Status check_derivatives(const Scene& scene, const std::vector<std::string>& keys) {
    if (const auto motion = PictureMotion::make(scene, keys); !motion) {
        Error error = motion.error();
        error.what = "--derivatives: " + error.what;
        return error;
    }
    return Done{};
}

Status add_derivative_channels(const Scene& scene, const std::vector<std::string>& keys, const RayFrame& rays,
                               const std::function<void(long long)>& advance, ChannelImage& image) {
    TRY(motion, PictureMotion::make(scene, keys));
    std::vector<std::array<std::vector<float>*, kDerivativeNames.size()>> channels(keys.size());
    for (std::size_t k = 0; k < keys.size(); ++k)
        for (std::size_t c = 0; c < kDerivativeNames.size(); ++c) {
            channels[k][c] = &image.channels[fmt::format("d_{}.{}", keys[k], kDerivativeNames[c])];
            channels[k][c]->assign(rays.pixels.size(), 0.0f);
        }
    tbb::parallel_for(0, rays.height, [&](int y) {
        for (int x = 0; x < rays.width; ++x) {
            const PictureMotion::Place place = (*motion)->at(x + 0.5, y + 0.5);
            const std::size_t at = rays.index(x, y);
            for (std::size_t k = 0; k < keys.size(); ++k) {
                const auto values = channel_values(place.by[k], rays.pixels[at]);
                for (std::size_t c = 0; c < values.size(); ++c)
                    if (std::isfinite(values[c])) (*channels[k][c])[at] = static_cast<float>(values[c]);
            }
        }
        advance(1);
    });
    return Done{};
}

}  // namespace nullscope::cli
