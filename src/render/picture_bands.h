// Pictures that are too large to be drawn at once: bands of rows, each drawn in parts and pasted together, equal to the whole bit by bit.
#pragma once
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "render/renderer.h"
#include "scene/exposure.h"
#include "scene/scene.h"

namespace nullscope {

inline constexpr long long kMostAtOnce_px = 1 << 24;

// Not where the picture has to be known as a whole: with bloom, or an exposure that follows it.
bool is_drawn_in_bands(const Scene& scene, long long most_px = kMostAtOnce_px);

struct PictureBand {
    int top = 0, rows = 0;
};
// From the top, of at most most_px pixels each if that is more than 8 rows.
std::vector<PictureBand> picture_bands(const CameraSpec& camera, long long most_px = kMostAtOnce_px / 4);

// Display-encoded, and in linear light; RGB. widest: of a part, px. Errors: Renderer::prepare()'s.
inline constexpr int kWidestPart_px = 8192;
Result<Image<unsigned char>> draw_band8(Renderer& renderer, const Exposure& shown, PictureBand band,
                                        int widest = kWidestPart_px);
Result<Image<float>> draw_band(Renderer& renderer, const Exposure& shown, PictureBand band,
                               int widest = kWidestPart_px);

// The same of a whole picture that is drawn at once.
Result<Image<unsigned char>> draw_picture8(Renderer& renderer, const Exposure& shown);
// The same, handed over while the next is prepared and drawn.
Result<PictureRead> begin_picture8(Renderer& renderer, const Exposure& shown);
Result<Image<float>> draw_picture(Renderer& renderer, const Exposure& shown);

}  // namespace nullscope
