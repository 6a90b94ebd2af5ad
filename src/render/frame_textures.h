// The tables and textures of a frame as one list: `nullscope plan` prints it, and tests hold it against Renderer::textures(), which is
// what a driver was given. Calls no GL.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "plan/effects.h"
#include "render/frame_tables.h"

namespace nullscope {

// layers x width x height texels.
struct FrameTexture {
    std::string name;
    long long layers, width, height, bytes;
    std::string reason;           // keys of the scene, or what in it calls for the effects
    std::vector<Effect> effects;  // of the frame's that fetch from it, or need it to be made
    bool on_gpu = true;
};

// What Renderer::textures() and frame_textures() call the image of number `image` of body_images().
std::string body_image_name(const Scene& scene, int image);

// In the order: tables of rays, of bodies, skies, light, pictures. Sizes of skies are those of a driver with textures of 16384 px. Cost:
// reads the images, stars, meshes and grids of the scene. Errors: one of them cannot be read.
Result<std::vector<FrameTexture>> frame_textures(const FrameTables& tables);

}  // namespace nullscope
