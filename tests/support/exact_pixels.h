// Some pixels of a displayed picture, by the reference, and the same of one that was drawn.
#pragma once
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/assets.h"
#include "reference/reference.h"
#include "render/display.h"
#include "sky/sky.h"

namespace nullscope::test {

using Places = std::vector<std::array<int, 2>>;  // columns, and rows from the top

// What the reference's pictures of a scene with an image on its disc are made of, loaded once.
class ExactPixels {
public:
    ExactPixels(const Scene& scene, int sky_px) {
        auto sky = build_sky(scene.sky, assets_directory(), sky_px);
        auto disc = load_disc_image(*scene.disc);
        REQUIRE((sky && disc));
        sky_ = std::move(*sky), disc_ = std::move(disc->image);
    }
    // samples x samples rays a pixel, even; one row of pixels. Without bloom and automatic exposure, which are of a whole
    // picture.
    Image<unsigned char> shown(const Scene& scene, int samples, const Places& places) const {
        const auto lights = reference::render_pixels(scene, sky_, &disc_, samples, places, nullptr);
        REQUIRE(lights);
        Image<float> row(static_cast<int>(places.size()), 1, 3);
        for (std::size_t k = 0; k < places.size(); ++k) {
            const Vec3 light = (*lights)[k].light;
            float* pixel = row.at(static_cast<int>(k), 0);
            pixel[0] = static_cast<float>(light.x), pixel[1] = static_cast<float>(light.y),
            pixel[2] = static_cast<float>(light.z);
        }
        return display_encoded(row, scene.camera.exposure_ev, scene.picture);
    }

private:
    SkyCube sky_;
    Image<float> disc_;
};

inline Image<unsigned char> picked(const Image<unsigned char>& picture, const Places& places) {
    Image<unsigned char> row(static_cast<int>(places.size()), 1, 3);
    for (std::size_t k = 0; k < places.size(); ++k)
        std::copy_n(picture.at(places[k][0], places[k][1]), 3, row.at(static_cast<int>(k), 0));
    return row;
}

}  // namespace nullscope::test
