#include "render/star_field.h"

#include <cmath>
#include <unordered_map>
#include <vector>

#include "base/assets.h"
#include "light/black_body.h"
#include "sky/point_stars.h"

namespace nullscope {

Status StarField::update(const Scene& scene, bool wanted) {
    if (!wanted) {
        *this = {};
        return Done{};
    }
    const Key key{scene.sky, scene.light.bolometric};
    if (key_ == key) return Done{};
    const auto stars = point_stars(scene.sky, assets_directory());
    if (!stars) return stars.error();
    std::unordered_map<double, double> brightness;   // by temperature: the catalogue has few
    std::vector<float> values;
    values.reserve(stars->size() * 5);
    for (const PointStar& star : *stars) {
        const auto [known, is_new] = brightness.try_emplace(star.temperature_K, 0.0);
        if (is_new) known->second = log2_brightness(star.temperature_K, key.bolometric);
        for (const double value : {star.direction.x, star.direction.y, star.direction.z, std::log2(star.flux) - known->second,
                                   std::log2(star.temperature_K)})
            values.push_back(static_cast<float>(value));
    }
    stars_ = gl::make_vertex_list(values, {3, 2});
    key_ = key;
    return Done{};
}

void StarField::draw(const gl::Program& program, unsigned framebuffer, int width, int height, int images) const {
    for (int image = 0; image < images; ++image) {
        gl::set_integer(program, "image_order", image);
        gl::draw_points(program, stars_, stars_.count, framebuffer, width, height, kPointMargin_px);
    }
}

}  // namespace nullscope
