#include "annotate/streamlines.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "annotate/between_texels.h"
#include "annotate/line_convolution.h"

namespace nullscope {
namespace {

// Of the picture's smaller side.
constexpr int kMostLight_px = 360, kMostTexture_px = 720;
constexpr double kLine = 1.0 / 330, kReach = 0.07;
constexpr double kLeastLine_px = 2.2;  // thinner ones would fall between the steps along them
constexpr double kDarkest = 0.7;
constexpr double kFullFrom = 0.05;  // of the brightest light: what is fainter has less contrast in proportion
// Of the texture, whose mean is 0.5; in proportion between them.
constexpr double kBlackAt = 0.38, kClearAt = 0.57;
constexpr unsigned kSeed = 1993;

struct Size {
    int width, height;
};

// As large, or smaller by one factor.
Size limited(int width, int height, int most) {
    const double part = std::min(1.0, static_cast<double>(most) / std::min(width, height));
    return {std::max(1, static_cast<int>(std::lround(part * width))),
            std::max(1, static_cast<int>(std::lround(part * height)))};
}

// White noise on a lattice of that many px, interpolated.
Image<float> noise_of(Size size, double cell) {
    std::mt19937 random(kSeed);
    Image<float> lattice(static_cast<int>(size.width / cell) + 2, static_cast<int>(size.height / cell) + 2, 1);
    for (float& value : lattice.data) value = static_cast<float>(static_cast<double>(random()) / 4294967296.0);
    Image<float> noise(size.width, size.height, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            *noise.at(x, y) = static_cast<float>(BetweenTexels(lattice, 0.5 + x / cell, 0.5 + y / cell).channel(0));
    return noise;
}

// Of each texel of stokes, [0, 1]: how much contrast lines have there.
Image<float> contrast_of(const Image<float>& stokes) {
    double brightest = 0, most = 0;
    for (int y = 0; y < stokes.height; ++y)
        for (int x = 0; x < stokes.width; ++x)
            if (std::isfinite(stokes.at(x, y)[0])) brightest = std::max<double>(brightest, stokes.at(x, y)[0]);
    Image<float> contrast(stokes.width, stokes.height, 1);
    for (int y = 0; y < stokes.height; ++y)
        for (int x = 0; x < stokes.width; ++x) {
            const float* light = stokes.at(x, y);
            const double polarised = std::hypot(light[1], light[2]), full = kFullFrom * brightest;
            if (!(light[0] > 0) || !std::isfinite(polarised)) continue;
            *contrast.at(x, y) = static_cast<float>(polarised / std::max<double>(light[0], full));
            most = std::max<double>(most, *contrast.at(x, y));
        }
    for (float& value : contrast.data) value = most > 0 ? static_cast<float>(value / most) : 0.0f;
    return contrast;
}

// Of each px of the texture, [0, 1]: by how much it darkens the picture.
Image<float> darkness_of(const Image<float>& stokes, Size size) {
    const double side = std::min(size.width, size.height);
    const Image<float> contrast = contrast_of(stokes);
    Image<float> dark(size.width, size.height, 1);
    std::vector<bool> lit;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            *dark.at(x, y) = static_cast<float>(
                BetweenTexels(contrast, (x + 0.5) * stokes.width / size.width, (y + 0.5) * stokes.height / size.height)
                    .channel(0));
            lit.push_back(255 * kDarkest * *dark.at(x, y) > 0.5);  // by a step of 8 bits
        }
    const Image<float> lines =
        line_convolution(noise_of(size, std::max(kLine * side, kLeastLine_px)), stokes, kReach * side, lit);
    for (std::size_t i = 0; i < dark.data.size(); ++i)
        dark.data[i] *=
            static_cast<float>(kDarkest * std::clamp((kClearAt - lines.data[i]) / (kClearAt - kBlackAt), 0.0, 1.0));
    return dark;
}

}  // namespace

Scene streamline_scene(Scene scene, int width, int height) {
    const Size size = limited(width, height, kMostLight_px);
    scene.camera.pixel_aspect *= static_cast<double>(width) * size.height / (static_cast<double>(height) * size.width);
    scene.camera.width = size.width, scene.camera.height = size.height;
    return scene;
}

std::vector<Mark> streamline_marks(const Image<float>& stokes, int width, int height) {
    if (stokes.empty()) return {};
    const Size size = limited(width, height, kMostTexture_px);
    const Image<float> dark = darkness_of(stokes, size);
    Mark mark{0, 0, Image<unsigned char>(width, height, 4)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const BetweenTexels at(dark, (x + 0.5) * size.width / width, (y + 0.5) * size.height / height);
            mark.rgba.at(x, y)[3] = static_cast<unsigned char>(std::lround(255 * at.channel(0)));
        }
    return {std::move(mark)};
}

}  // namespace nullscope
