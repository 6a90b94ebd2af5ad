#include "render/ray_list_target.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "shaderlib/body_text.h"

namespace nullscope {
namespace {

// Sides are powers of two: llvmpipe compiles once more for textures of other sizes.
constexpr std::size_t kWidth = 256;
constexpr int kNumbers = 4;  // texels a ray

void put_vector(const FrameVector& v, float* to) {
    to[0] = static_cast<float>(v.x), to[1] = static_cast<float>(v.y), to[2] = static_cast<float>(v.z),
    to[3] = static_cast<float>(v.w);
}

using Texel = std::array<float, 4>;

// stage/ray_list.frag, main. at(k): what it wrote to location k.
template <class At>
ListedRay ray_of(const At& at, int outputs, const std::vector<int>& bodies) {
    ListedRay ray;
    const Texel fate = at(0), data = at(1);
    const int word = static_cast<int>(fate[0]);
    ray.end.fate = static_cast<Fate>(word & 7);
    ray.count = (word >> 3) & 7;
    ray.more = (word & 64) != 0;
    ray.end.sky = {fate[1], fate[2], fate[3]};
    ray.end.g = data[0], ray.end.delay = data[1], ray.end.angle = data[2];
    ray.end.order = static_cast<int>(std::floor(ray.end.angle / M_PI));
    ray.end.hit = static_cast<int>(data[3]);
    if (ray.end.hit >= kFirstBody) ray.end.hit = bodies[static_cast<std::size_t>(ray.end.hit - kFirstBody)];
    for (int k = 2; k < outputs; ++k) {
        const Texel met = at(k);
        ray.crossings[static_cast<std::size_t>(k - 2)] = {met[0], met[1], met[2]};
        if (k == 2) ray.at = met[3];
    }
    return ray;
}

}  // namespace

gl::Texture RayListTarget::begin(std::span<const RayNumbers> rays) {
    count_ = rays.size();
    const std::size_t width = std::bit_ceil(std::min(count_, kWidth)),
                      height = std::bit_ceil((count_ + width - 1) / width);
    const int outputs = crossings_ ? 2 + std::max(asked_.most, 1) : 2;
    if (target_.width != static_cast<int>(width) || target_.height != static_cast<int>(height))
        target_ = gl::make_target(static_cast<int>(width), static_cast<int>(height), gl::Format::kRgba32F, outputs);
    std::vector<float> numbers(width * height * kNumbers * 4);
    for (std::size_t i = 0; i < count_; ++i) {
        float* to = numbers.data() + ((i / width) * kNumbers * width + i % width) * 4;
        put_vector(rays[i].start, to);
        put_vector(rays[i].radial, to + 4 * width);
        put_vector(rays[i].meridian, to + 8 * width);
        put_vector(rays[i].ray, to + 12 * width);
    }
    return gl::make_number_texture(static_cast<int>(width), static_cast<int>(height) * kNumbers, 4, numbers.data(),
                                   false);
}

int RayListTarget::rows() const {
    const auto width = static_cast<std::size_t>(target_.width);
    return static_cast<int>((count_ + width - 1) / width);
}

void RayListTarget::read(const std::vector<int>& bodies, ListedRay* found) const {
    const auto outputs = static_cast<int>(target_.colours.size());
    const std::size_t texels = static_cast<std::size_t>(target_.width) * static_cast<std::size_t>(target_.height);
    std::vector<std::vector<Texel>> values(target_.colours.size(), std::vector<Texel>(texels));
    for (int k = 0; k < outputs; ++k) gl::read_rgba32f(target_, k, values[static_cast<std::size_t>(k)].front().data());
    for (std::size_t i = 0; i < count_; ++i)
        found[i] = ray_of([&](int k) { return values[static_cast<std::size_t>(k)][i]; }, outputs, bodies);
}

}  // namespace nullscope
