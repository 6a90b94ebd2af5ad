#include "command/capture_layers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compare/ray_channels.h"
#include "compare/st_map.h"
#include "image/channels.h"
#include "image/luminance.h"
#include "observer/ball_motion.h"
#include "plan/moving.h"
#include "scene/bodies.h"
#include "scene/disc_shape.h"
#include "scene/leaning_disc.h"
#include "scene/orbit_sense.h"
#include "sky/sky.h"
#include "spacetime/leaning_circle.h"

namespace nullscope::cli {
namespace {

void add_colours(const std::string& prefix, const Image<float>& image, ChannelImage& file) {
    for (int c = 0; c < 3; ++c) file.channels[prefix + "RGB"[c]] = channel_of(image, c);
}

double radius_at(const SphereSpec& sphere, double time) {
    return sphere.radius * (1.0 + sphere.amplitude * std::sin(2.0 * M_PI * time / sphere.period));
}

// A place of its surface, `time` after it was `place`.
Vec3 moved_sphere(const SphereSpec& sphere, Vec3 place, double left, double time) {
    const double turned = sphere.spin_rate * time, c = std::cos(turned), s = std::sin(turned);
    return radius_at(sphere, left + time) / radius_at(sphere, left) *
           Vec3{c * place.x - s * place.y, s * place.x + c * place.y, place.z};
}

// What the scene's things do between two pictures. Balls do not turn about themselves; a sphere that pulsates moves along its radii, one that turns about the polar axis; where the
// places of a surface whose formula asks for t go nobody says.
class Motions {
public:
    // spacetime: of the scene's matter. Both outlive this.
    Motions(const Scene& scene, const Spacetime& spacetime) : scene_(scene), spacetime_(spacetime) {
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            const int number = object_number(scene, i);
            const BodyShape& shape = scene.bodies[i].shape;
            if (const auto* sphere = std::get_if<SphereSpec>(&shape);
                sphere != nullptr && (sphere->amplitude > 0.0 || sphere->spin_rate != 0.0))
                spheres_.emplace(number, sphere);
            if (const auto* surface = std::get_if<SurfaceSpec>(&shape); surface != nullptr && surface_moves(*surface))
                surfaces_.insert(number);
            const auto* ball = std::get_if<BallSpec>(&shape);
            if (ball == nullptr || !ball->moves()) continue;
            if (auto motion = ball_motion(spacetime_, *ball)) balls_.emplace(number, std::move(*motion));
        }
    }

    Vec3 moved(const RayPixel& pixel, double time) const {
        const Vec3 place{pixel.u, pixel.v, pixel.w};
        if (pixel.hit == kDiscHit) return on_disc(place, time);
        if (surfaces_.contains(pixel.hit)) return {kNotANumber, kNotANumber, kNotANumber};
        const double left = scene_.time - pixel.delay;  // when the light did; now, where all is seen at once
        if (const auto sphere = spheres_.find(pixel.hit); sphere != spheres_.end())
            return moved_sphere(*sphere->second, place, left, time);
        const auto ball = balls_.find(pixel.hit);
        if (ball == balls_.end()) return place;
        return place + ball->second(left + time).place - ball->second(left).place;
    }

private:
    Vec3 on_disc(Vec3 place, double time) const {
        const bool flows = scene_.disc->flow != DiscFlowKind::kStill;
        if (!flows && !disc_precesses(scene_)) return place;
        const double r = length(place);
        const DiscPlane plane = DiscShape(*scene_.disc, scene_.time).plane(r),
                        then = DiscShape(*scene_.disc, scene_.time + time).plane(r);
        const double x = dot(place, plane.x), y = dot(place, plane.y);
        const auto rate =
            flows ? leaning_rate(spacetime_, r, sense_about(spacetime_, scene_.disc->sense), scene_.disc->lean.tilt)
                  : std::nullopt;
        const double turned = rate.value_or(0.0) * time, c = std::cos(turned), s = std::sin(turned);
        return then.place(c * x - s * y, s * x + c * y);
    }

    const Scene& scene_;
    const Spacetime& spacetime_;
    std::map<int, BallMotionAt> balls_;
    std::map<int, const SphereSpec*> spheres_;  // that pulsate or turn
    std::set<int> surfaces_;                    // that depend on time
};

// Ray data whose things are all seen as they are now: no light has left earlier.
RayFrame seen_at_once(RayFrame rays) {
    for (RayPixel& pixel : rays.pixels) pixel.delay = 0.0;
    return rays;
}

// Where a pixel shows matter along its ray, matter is what it hits: in front of the sky and the hole where half of the light is its,
// anywhere where half of the light behind it is hidden by it.
void hit_medium(LayeredPicture& picture) {
    const auto layer = std::ranges::find(picture.layers.each, "medium", &LayerImage::name);
    if (layer == picture.layers.each.end()) return;
    for (std::size_t i = 0; i < picture.rays.pixels.size(); ++i) {
        RayPixel& pixel = picture.rays.pixels[i];
        const float light = luminance_of(&layer->light.data[3 * i]);
        const bool bright = light > 0.0f && 2.0f * light >= luminance_of(&picture.layers.all.data[3 * i]);
        if (!(picture.depths.medium[i] > 0.0f) || !(layer->share[i] >= 0.5f || (pixel.hit == 0 && bright))) continue;
        pixel.hit = kMediumHit;
        const Vec3 place = picture.depths.medium_place[i];
        pixel.u = place.x, pixel.v = place.y, pixel.w = place.z;
        picture.depths.depth[i] = picture.depths.medium[i], picture.depths.g[i] = 0.0f;
        if (picture.motion) picture.motion->right[i] = picture.motion->up[i] = picture.motion->known[i] = 0.0f;
    }
}

}  // namespace

Result<LayeredPicture> capture_layers(Session& session, const Scene& scene, const Scene* next) {
    Renderer& renderer = *session.renderer;
    LayeredPicture picture;
    if (const auto sky = behind_things(scene)) {
        if (Status ready = renderer.prepare(*sky); !ready) return ready.error();
        picture.behind = renderer.ray_data();
    }
    RayFrame later;
    if (next != nullptr) {
        if (Status ready = renderer.prepare(*next); !ready) return ready.error();
        later = renderer.ray_data();
    }
    if (Status ready = renderer.prepare(scene); !ready) return ready.error();
    picture.layers = draw_layers(renderer);
    picture.rays = renderer.ray_data();
    picture.depths = renderer.ray_depths();
    if (next != nullptr) {
        const Motions motions(scene, renderer.tables().matter());
        const auto seen = [&](const RayFrame& rays) { return scene.light.delay ? rays : seen_at_once(rays); };
        picture.motion = ray_motion(seen(picture.rays), seen(later), next->time - scene.time,
                                    [&](const RayPixel& pixel, double time) { return motions.moved(pixel, time); });
    }
    hit_medium(picture);
    return picture;
}

std::optional<Scene> behind_things(const Scene& scene) {
    if (!scene.disc && !scene.medium && scene.bodies.empty() && scene.spots.empty()) return std::nullopt;
    Scene sky = scene;
    sky.disc.reset(), sky.medium.reset(), sky.bodies.clear(), sky.spots.clear();
    return sky;
}

Image<float> st_map_of(const RayFrame& rays, const Scene& scene, const std::string& of) {
    if (of == "plate") return st_map(rays, [&](Vec3 direction) { return plate_place(scene.camera, direction); });
    const Mat3 sky_from_world = transposed(sky_rotation(scene.sky));
    return st_map(rays, [&](Vec3 direction) { return std::optional(panorama_place(sky_from_world * direction)); });
}

void add_layer_channels(const LayeredPicture& picture, const Scene& scene, ChannelImage& file) {
    file.channels["A"] = picture.layers.covered;
    for (const LayerImage& layer : picture.layers.each) {
        add_colours(layer.name + ".", layer.light, file);
        file.channels[layer.name + ".A"] = layer.share;
    }
    add_ray_channels(picture.rays, RayNames::kBesideLayers, file);
    file.channels["depth.affine"] = picture.depths.depth;
    if (!picture.depths.medium.empty()) file.channels["depth.medium"] = picture.depths.medium;
    file.channels["g_hit"] = picture.depths.g;
    for (const char* of : {"sky", "plate"}) {
        const Image<float> map = st_map_of(picture.behind ? *picture.behind : picture.rays, scene, of);
        for (int c = 0; c < 3; ++c) file.channels[std::string("st_") + of + "." + "xyz"[c]] = channel_of(map, c);
    }
    if (!picture.motion) return;
    file.channels["forward.u"] = picture.motion->right;
    file.channels["forward.v"] = picture.motion->up;
    file.channels["forward_known"] = picture.motion->known;
}

}  // namespace nullscope::cli
