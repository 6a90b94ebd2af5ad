#include "render/picture_bands.h"

#include <algorithm>

namespace nullscope {
namespace {

// What parts begin at multiples of, from the lower left corner, and what they have around them that is not used: the picture's largest
// tiles, and the neighbours that edges are found by.
constexpr int kGrid_px = kFirstTiles * kTileSide;

template <class T, class Draw>
Result<Image<T>> drawn_in_parts(Renderer& renderer, const Exposure& shown, PictureBand band, int widest, Draw draw) {
    const CameraSpec& whole = shown.scene.camera;
    Image<T> image(whole.width, band.rows, 3);
    const int step = std::max(widest / kGrid_px, 1) * kGrid_px;
    for (int left = 0; left < whole.width; left += step) {
        const int right = std::min(left + step, whole.width), bottom = band.top + band.rows;
        const int from = std::max(left - kGrid_px, 0), to = std::min(right + kGrid_px, whole.width),
                  above = std::max(band.top - kGrid_px, 0), below = std::min(bottom + kGrid_px, whole.height);
        TRY(part, draw(renderer, changed(shown, [&](Scene scene) {
                           scene.camera.part = PicturePart{from, above, whole.width, whole.height};
                           scene.camera.width = to - from, scene.camera.height = below - above;
                           return scene;
                       })));
        copy_part(*part, left - from, band.top - above, right - left, band.rows, image, left, 0);
    }
    return image;
}

}  // namespace

bool is_drawn_in_bands(const Scene& scene, long long most_px) {
    const long long pixels = static_cast<long long>(scene.camera.width) * scene.camera.height;
    return pixels > most_px && scene.picture.bloom == 0.0 && !scene.picture.auto_exposure;
}

std::vector<PictureBand> picture_bands(const CameraSpec& camera, long long most_px) {
    const long long most_rows = std::max(most_px / camera.width, 1LL);
    const int rows = static_cast<int>(std::max(most_rows / kGrid_px, 1LL)) * kGrid_px;
    std::vector<PictureBand> bands;
    for (int bottom = camera.height; bottom > 0; bottom -= rows) {
        const int top = std::max(bottom - rows, 0);
        bands.push_back({top, bottom - top});
    }
    std::ranges::reverse(bands);
    return bands;
}

Result<Image<unsigned char>> draw_band8(Renderer& renderer, const Exposure& shown, PictureBand band, int widest) {
    return drawn_in_parts<unsigned char>(renderer, shown, band, widest, draw_picture8);
}

Result<Image<float>> draw_band(Renderer& renderer, const Exposure& shown, PictureBand band, int widest) {
    return drawn_in_parts<float>(renderer, shown, band, widest, draw_picture);
}

Result<Image<unsigned char>> draw_picture8(Renderer& renderer, const Exposure& shown) {
    if (shown.sub_frames.empty()) {
        if (Status ready = renderer.prepare(shown.scene); !ready) return ready.error();
        return renderer.picture8();
    }
    TRY(light, draw_picture(renderer, shown));
    return renderer.displayed(*light);  // by the last sub-frame's exposure, which is the scene's
}

Result<PictureRead> begin_picture8(Renderer& renderer, const Exposure& shown) {
    if (shown.sub_frames.empty()) {
        if (Status ready = renderer.prepare(shown.scene); !ready) return ready.error();
        return renderer.begin_picture8();
    }
    TRY(drawn, draw_picture8(renderer, shown));
    return PictureRead{drawn->width, drawn->height, [picture = std::move(*drawn)] { return picture; }};
}

Result<Image<float>> draw_picture(Renderer& renderer, const Exposure& shown) {
    return mean_light(shown, [&](const Scene& scene) -> Result<Image<float>> {
        if (Status ready = renderer.prepare(scene); !ready) return ready.error();
        return renderer.picture();
    });
}

}  // namespace nullscope
