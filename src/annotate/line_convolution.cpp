#include "annotate/line_convolution.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "annotate/between_texels.h"

namespace nullscope {
namespace {

constexpr double kStep = 2.0;  // px

struct Vector {  // px, to the right and down
    double x, y;
};

class Lines {
public:
    Lines(const Image<float>& noise, const Image<float>& stokes)
        : noise_(noise),
          stokes_(stokes),
          wide_(static_cast<double>(stokes.width) / noise.width),
          high_(static_cast<double>(stokes.height) / noise.height) {}

    // Unit vector along the line at a place, the one of the two that turns less from `before`.
    std::optional<Vector> along(Vector at, Vector before) const {
        const BetweenTexels light(stokes_, wide_ * at.x, high_ * at.y);
        const double q = light.channel(1), u = light.channel(2), polarised = std::sqrt(q * q + u * u);
        if (!(polarised > 0) || !std::isfinite(polarised)) return std::nullopt;
        // Of half the angle of (q, u), without the difference of nearly equal numbers.
        Vector way = q >= 0 ? Vector{polarised + q, -u} : Vector{u, q - polarised};
        double length = std::sqrt(way.x * way.x + way.y * way.y);
        if (way.x * before.x + way.y * before.y < 0) length = -length;
        return Vector{way.x / length, way.y / length};
    }

    // Sums of weight and of weight times noise on one side of a place, which is left in the direction `way`.
    void walk(Vector at, Vector way, const std::vector<double>& window, double& weights, double& sum) const {
        for (const double weight : window) {
            const auto middle = along({at.x + 0.5 * kStep * way.x, at.y + 0.5 * kStep * way.y}, way);
            if (!middle) return;
            way = *middle, at.x += kStep * way.x, at.y += kStep * way.y;
            if (!(at.x >= 0 && at.y >= 0 && at.x <= noise_.width && at.y <= noise_.height)) return;
            weights += weight, sum += weight * BetweenTexels(noise_, at.x, at.y).channel(0);
        }
    }

    double mean(int x, int y, const std::vector<double>& window) const {
        const Vector at{x + 0.5, y + 0.5};
        double weights = 1, sum = noise_.at(x, y)[0];
        if (const auto way = along(at, {1, 0})) {
            walk(at, *way, window, weights, sum);
            walk(at, {-way->x, -way->y}, window, weights, sum);
        }
        return sum / weights;
    }

private:
    const Image<float>&noise_, &stokes_;
    double wide_, high_;
};

}  // namespace

Image<float> line_convolution(const Image<float>& noise, const Image<float>& stokes, double reach,
                              const std::vector<bool>& lit) {
    Image<float> texture(noise.width, noise.height, 1);
    const Lines lines(noise, stokes);
    std::vector<double> window;  // of the places beside the middle, on one side
    for (double s = kStep; s < reach; s += kStep) window.push_back(0.5 + 0.5 * std::cos(std::numbers::pi * s / reach));
    tbb::parallel_for(0, noise.height, [&](int y) {
        for (int x = 0; x < noise.width; ++x)
            if (lit[static_cast<std::size_t>(y) * noise.width + x])
                *texture.at(x, y) = static_cast<float>(lines.mean(x, y, window));
    });
    return texture;
}

}  // namespace nullscope
