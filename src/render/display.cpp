#include "render/display.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/vec.h"
#include "image/image_file.h"
#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

// Between texels, clamped at the edges, as the hardware filters: (u, v) in [0, 1]^2.
Vec3 filtered(const Image<float>& image, double u, double v) {
    const double x = u * image.width - 0.5, y = v * image.height - 0.5, fx = x - std::floor(x), fy = y - std::floor(y);
    const auto texel = [&](double column, double row) {
        const float* p = image.at(std::clamp(static_cast<int>(column), 0, image.width - 1),
                                  std::clamp(static_cast<int>(row), 0, image.height - 1));
        return Vec3{p[0], p[1], p[2]};
    };
    const double x0 = std::floor(x), y0 = std::floor(y);
    return (1 - fy) * ((1 - fx) * texel(x0, y0) + fx * texel(x0 + 1, y0)) +
           fy * ((1 - fx) * texel(x0, y0 + 1) + fx * texel(x0 + 1, y0 + 1));
}

Vec3 four(const Image<float>& image, double u, double v, double reach) {  // reach: texels of the image
    const double du = reach / image.width, dv = reach / image.height;
    return 0.25 * (filtered(image, u - du, v - dv) + filtered(image, u + du, v - dv) + filtered(image, u - du, v + dv) +
                   filtered(image, u + du, v + dv));
}

template <class Texel>
Image<float> image_of(int width, int height, const Texel& texel) {
    Image<float> image(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec3 c = texel(x + 0.5, y + 0.5);
            float* p = image.at(x, y);
            p[0] = static_cast<float>(c.x), p[1] = static_cast<float>(c.y), p[2] = static_cast<float>(c.z);
        }
    return image;
}

double tone(double x, ToneCurve curve) {
    if (curve == ToneCurve::kFilm) return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    return 1.0 - std::exp(-x);
}

Vec3 toned(Vec3 c, ToneCurve curve) {
    c = {std::min(c.x, 1e4), std::min(c.y, 1e4), std::min(c.z, 1e4)};
    if (curve != ToneCurve::kNeutral) return {tone(c.x, curve), tone(c.y, curve), tone(c.z, curve)};
    const double low = std::min({c.x, c.y, c.z}), offset = low < 0.08 ? low - 6.25 * low * low : 0.04;
    c = c - Vec3{offset, offset, offset};
    const double peak = std::max({c.x, c.y, c.z});
    if (peak < 0.76) return c;
    const double compressed = 1 - 0.0576 / (peak - 0.52), keep = 1 / (0.15 * (peak - compressed) + 1);
    return keep * compressed / peak * c + (1 - keep) * compressed * Vec3{1, 1, 1};
}

constexpr double kLeastMetered = 1e-4;  // shaders/stage/develop.frag

double mean_luminance(const Image<float>& image) {
    double sum = 0;
    for (std::size_t i = 0; i + 2 < image.data.size(); i += 3)
        sum += 0.2126 * image.data[i] + 0.7152 * image.data[i + 1] + 0.0722 * image.data[i + 2];
    return sum / (static_cast<double>(image.width) * image.height);
}

// Halves of halves, the first of them of the picture, until 8 px are left.
std::vector<Image<float>> pyramid(const Image<float>& linear) {
    std::vector<Image<float>> down;
    const Image<float>* source = &linear;
    do {
        const int width = (source->width + 1) / 2, height = (source->height + 1) / 2;
        down.push_back(
            image_of(width, height, [&](double x, double y) { return four(*source, x / width, y / height, 1.0); }));
        source = &down.back();
    } while (source->width > 8 || source->height > 8);
    return down;
}

}  // namespace

Image<float> with_bloom(const Image<float>& linear, double share) {
    const std::vector<Image<float>> down = pyramid(linear);
    Image<float> halo = down.back();
    for (std::size_t level = down.size() - 1; level-- > 0;) {
        const Image<float>& here = down[level];
        halo = image_of(here.width, here.height, [&](double x, double y) {
            const double u = x / here.width, v = y / here.height;
            return 0.5 * (filtered(here, u, v) + four(halo, u, v, 0.5));
        });
    }
    return image_of(linear.width, linear.height, [&](double x, double y) {
        return (1 - share) * filtered(linear, x / linear.width, y / linear.height) +
               share * filtered(halo, x / linear.width, y / linear.height);
    });
}

namespace {

template <class T>
Image<T> encoded(const Image<float>& linear, double exposure_ev, const PictureSpec& picture) {
    constexpr auto kMost = static_cast<float>(std::numeric_limits<T>::max());
    const Image<float> light = picture.bloom > 0.0 ? with_bloom(linear, picture.bloom) : linear;
    double exposure = std::exp2(exposure_ev);
    if (picture.auto_exposure) exposure *= kMeterKey / std::max(mean_luminance(pyramid(linear).back()), kLeastMetered);
    Image<T> out(light.width, light.height, 3);
    for (std::size_t i = 0; i + 2 < out.data.size(); i += 3) {
        const Vec3 c = toned(exposure * Vec3{light.data[i], light.data[i + 1], light.data[i + 2]}, picture.tone);
        const double values[3] = {c.x, c.y, c.z};
        for (std::size_t k = 0; k < 3; ++k)
            out.data[i + k] = static_cast<T>(
                std::lround(kMost * srgb_from_linear(static_cast<float>(std::clamp(values[k], 0.0, 1.0)))));
    }
    return out;
}

}  // namespace

Image<unsigned char> display_encoded(const Image<float>& linear, double exposure_ev, const PictureSpec& picture) {
    return encoded<unsigned char>(linear, exposure_ev, picture);
}

Image<unsigned short> display_encoded16(const Image<float>& linear, double exposure_ev, const PictureSpec& picture) {
    return encoded<unsigned short>(linear, exposure_ev, picture);
}

}  // namespace nullscope
