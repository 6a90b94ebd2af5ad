#include "render/star_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "base/assets.h"
#include "light/black_body.h"
#include "render/frame_tables.h"

namespace nullscope {
namespace {

// log2 of how bright black bodies are, of log2 of their temperature, to 0.01: a look into a table.
class Brightness {
public:
    explicit Brightness(bool bolometric) {
        for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = log2_brightness(std::exp2(kColdest + kStep * static_cast<double>(i)), bolometric);
    }
    double at(double log2_K) const {
        const double x = std::clamp((log2_K - kColdest) / kStep, 0.0, static_cast<double>(values_.size()) - 1.001);
        const auto i = static_cast<std::size_t>(x);
        return values_[i] + (x - static_cast<double>(i)) * (values_[i + 1] - values_[i]);
    }

private:
    static constexpr double kColdest = 9.0, kStep = 0.1;   // K: 512 to 524288
    std::array<double, 101> values_{};
};

// Of a colour of luminance 1 the largest part, over that: red of the coldest bodies.
constexpr double kLargestPart = 1.0 / 0.2126;

}  // namespace

Status StarField::update(const Scene& scene, const FrameTables& tables) {
    if (!tables.effects().contains(Effect::kPointStars)) {
        *this = {};
        return Done{};
    }
    const Sky sky{scene.sky, scene.light.bolometric, tables.effects().contains(Effect::kSpin)};
    if (sky_ != sky) {
        const auto stars = point_stars(scene.sky, assets_directory());
        if (!stars) return stars.error();
        std::unordered_map<double, double> brightness;   // by temperature: the catalogue has few
        std::vector<float> values;
        std::vector<Vec3> places;
        makes_.clear();
        for (const PointStar& star : *stars) {
            const auto [known, is_new] = brightness.try_emplace(star.temperature_K, 0.0);
            if (is_new) known->second = log2_brightness(star.temperature_K, sky.bolometric);
            const Make make{std::log2(star.flux) - known->second, std::log2(star.temperature_K)};
            if (sky.found) {
                places.push_back(star.direction);
                makes_.push_back(make);
            } else {
                for (const double value : {star.direction.x, star.direction.y, star.direction.z, make.light, make.temperature})
                    values.push_back(static_cast<float>(value));
            }
        }
        mesh_.reset();
        view_.reset();
        if (sky.found) mesh_.emplace(std::move(places));
        else vertices_ = gl::make_vertex_list(values, {3, 2});
        sky_ = sky;
    }
    if (sky.found) find_images(scene, tables);
    return Done{};
}

void StarField::find_images(const Scene& scene, const FrameTables& tables) {
    const View view{scene.spacetime, scene.camera, scene.light};
    if (view_ == view) return;
    Scene bare;   // rays to the sky, whatever is in their way
    bare.spacetime = scene.spacetime, bare.camera = scene.camera, bare.light = scene.light, bare.sky = scene.sky;
    const Brightness brightness(scene.light.bolometric);
    const double faintest = std::log2(kFaintestPoint / kLargestPart) - scene.camera.exposure_ev - std::log2(point_peak());
    const auto seen = [&](int star, double area, double g) {
        const Make& make = makes_[static_cast<std::size_t>(star)];
        return make.light + brightness.at(make.temperature + (scene.light.beaming ? std::log2(std::max(g, 1e-9)) : 0.0)) - std::log2(area) > faintest;
    };
    std::vector<float> values;
    for (const MeshImage& image : mesh_->images(tables.core_input(bare), scene.camera.width, scene.camera.height, kPointMargin_px, seen)) {
        const Make& make = makes_[static_cast<std::size_t>(image.star)];
        for (const double value : {image.x, image.y, image.g, make.light - std::log2(image.area), make.temperature})
            values.push_back(static_cast<float>(value));
    }
    vertices_ = gl::make_vertex_list(values, {3, 2});
    view_ = view;
}

void StarField::draw(const gl::Program& program, unsigned framebuffer, int width, int height, int images) const {
    for (int image = 0; image < images; ++image) {
        gl::set_integer(program, "image_order", image);
        gl::draw_points(program, vertices_, vertices_.count, framebuffer, width, height, kPointMargin_px);
    }
}

}  // namespace nullscope
