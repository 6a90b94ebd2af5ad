// What compositors ask for beside a picture (docs/layers.md): its layers, motion vectors, ST maps.
#pragma once
#include <optional>

#include "base/result.h"
#include "command/session.h"
#include "compare/ray_motion.h"
#include "image/image.h"
#include "image/image_file.h"
#include "render/picture_layers.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::cli {

// The picture in layers, its ray data and, where there is a next picture, how far things move until then. Beside what ray data are of
// themselves, pixels that show matter along their ray hit it (kMediumHit), at its mean place.
struct LayeredPicture {
    PictureLayers layers;
    RayFrame rays;
    std::optional<RayFrame> behind;  // those of behind_things(), for ST maps; none where they are the same
    Renderer::RayDepths depths;
    std::optional<RayMotion> motion;
};

// next: the scene of the next frame; null: none. The session's renderer is prepared here. Errors: as of pictures.
Result<LayeredPicture> capture_layers(Session& session, const Scene& scene, const Scene* next);

// Beside R, G and B of the picture: A of what covers the sky; NAME.R ... NAME.A of every layer; ray data; depth.affine, depth.medium of scenes
// with matter, and g_hit; x, y, z of st_sky and st_plate; forward.u, forward.v, forward_known.
void add_layer_channels(const LayeredPicture& picture, const Scene& scene, ChannelImage& file);

// The scene whose rays ST maps are of: without disc, bodies, hot spots and matter, so that pixels that these cover in part, or wholly, have
// the sky behind them. None: there are no such things.
std::optional<Scene> behind_things(const Scene& scene);

// Of the rays of behind_things(), if there are. of: "sky" or "plate" (compare/st_map.h).
Image<float> st_map_of(const RayFrame& rays, const Scene& scene, const std::string& of);

}  // namespace nullscope::cli
