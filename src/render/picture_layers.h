// A picture in layers, for compositing: what each image order of the disc, the bodies, matter along rays and the sky add to it.
#pragma once
#include <string>
#include <vector>

#include "image/image.h"

namespace nullscope {

class Renderer;

// As shaders/stage/layer.glsl numbers them. Shares: how much of the pixel's light something hides, or would if it were behind nothing.
// kDisc2: of the third image and all higher ones. kMedium: of matter along rays. kStokes: Stokes parameters Q
// and U of all light, in units of its luminance. kDiscShares: of three image orders; kOtherShares: of
// bodies, sky and medium.
enum class PictureLayer { kAll, kDisc0, kDisc1, kDisc2, kBodies, kSky, kMedium, kStokes, kDiscShares, kOtherShares };

inline constexpr int kStokesParameters = 4;
struct LayerImage {
    std::string name;    // disc0, disc1, disc2, bodies, medium, sky
    Image<float> light;  // RGB, linear, as much of it as reaches the camera: the layers add up to the picture
    std::vector<float>
        share;  // of each pixel, [0, 1]: what of the light behind it the layer keeps from the camera; the sky's: what it is seen through
};
struct PictureLayers {
    Image<float> all;              // the picture
    std::vector<LayerImage> each;  // those that the scene can have
    Image<float> stokes;           // I, Q, U, V of all light, I its luminance; empty where no light is polarised
    std::vector<float>
        covered;  // of each pixel, [0, 1]: by the disc, bodies, matter and the hole; the sky has the rest
};

// Of the scene that the renderer has prepared; rows from the top. Bloom and tone mapping are not in it, as in every picture of linear light.
// Cost: the picture drawn once for each layer, and twice for the shares. A layer is seen where the picture has it: with all that it is
// lit, covered and refined by.
PictureLayers draw_layers(Renderer& renderer);

// PictureLayers::stokes alone. Cost: the picture twice, by a program of its own.
Image<float> draw_stokes(Renderer& renderer);

}  // namespace nullscope
