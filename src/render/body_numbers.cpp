#include "render/body_numbers.h"

#include <algorithm>
#include <cmath>

#include "spacetime/circular_orbit.h"

namespace nullscope {
namespace {

void put_look(FrameVector& map, FrameVector& colour, FrameVector& second, const BodyLook& look) {
    map = {std::cos(look.rotation), std::sin(look.rotation), static_cast<double>(look.columns),
           static_cast<double>(look.rows)};
    colour = {look.brightness * look.colour, look.limb};
    second = {look.brightness * look.second_colour, look.band_latitude};
}

struct Silhouette {
    double sine, cosine;
};
// Of the angle from the outward radial under which a sphere's edge is seen. Sine -1 where only captured rays reach it: a sphere within
// the photon sphere.
Silhouette silhouette(const Spacetime& spacetime, const RayFan* fan, double camera_r, double radius) {
    const auto photon_sphere = spacetime.photon_sphere();
    if (photon_sphere && radius <= photon_sphere->radius) return {-1.0, 0.0};
    if (fan == nullptr) return {radius / camera_r, -std::sqrt((camera_r - radius) * (camera_r + radius)) / camera_r};
    const double t = fan->half_tangent_inward(std::sqrt(spacetime.lapse_squared(radius)) / radius),
                 by = 1.0 / (1.0 / t + t);
    return {2.0 * by, (1.0 / t - t) * by};
}

// Radii about the centre between which all bodies lie that are found by steps, and the shortest step: a thirtieth of the thinnest.
void put_march(FrameData& frame, const Scene& scene, const Spacetime& spacetime, const BallPath* ball_path) {
    constexpr double kMarchStep = 1.0 / 32;
    const bool planar = spacetime.planar_rays();
    double reaches[2] = {0.0, 0.0}, thinnest = 1e30, ground = 1e30;  // near, far
    const auto holds = [&](bool far, double radius, double from) {
        reaches[far] = std::max(reaches[far], radius), ground = std::min(ground, from);
    };
    if (const auto& c = scene.cylinder) {
        holds(c->far, std::hypot(c->outer, c->height), c->inner);
        thinnest = std::min({thinnest, 2 * c->height, c->outer - c->inner});
    }
    if (const auto& b = scene.ball) {
        holds(b->far, ball_path != nullptr ? ball_path->reach : length(b->position) + b->radius,
              ball_path != nullptr ? std::max(ball_path->ground, 0.0) : length(b->position) - b->radius);
        thinnest = std::min(thinnest, b->radius);
    }
    if (scene.sphere && (!planar || scene.sphere->swing > 0.0)) {
        holds(false, scene.sphere->radius * (1.0 + scene.sphere->swing),
              scene.sphere->radius * (1.0 - scene.sphere->swing));
        thinnest = std::min(thinnest, scene.sphere->radius * (1.0 - scene.sphere->swing));
    }
    if (const auto& f = scene.surface) {
        holds(f->far, f->bound, 0.0);
        thinnest = std::min(thinnest, 2 * f->bound / f->steps / kMarchStep);
    }
    const auto with_margin = [&](double reach) { return 1.001 * reach + 4 * kMarchStep * thinnest; };
    const double least = 0.999 * ground;
    frame.march = {with_margin(reaches[0]), kMarchStep * thinnest, planar ? with_margin(reaches[1]) : least,
                   std::min(least, planar ? kAnyRadius : light_orbit(spacetime))};
}

FrameVector sphere_form(const SphereSpec& sphere, const Scene& scene, const Spacetime& spacetime, const RayFan* fan) {
    if (sphere.swing > 0.0) {  // object/pulse.glsl
        const double pulse = 2.0 * M_PI / sphere.period;
        return {sphere.radius, sphere.swing, std::remainder(pulse * scene.time, 2.0 * M_PI), pulse};
    }
    const Silhouette edge = silhouette(spacetime, fan, scene.camera.r, sphere.radius);
    return {sphere.radius, 1.0 / sphere.radius, edge.sine, edge.cosine};
}

}  // namespace

void put_bodies(FrameData& frame, const Scene& scene, const Spacetime& spacetime, const RayFan* fan,
                const BallPath* ball_path) {
    if (const auto& sphere = scene.sphere) {
        frame.sphere_form = sphere_form(*sphere, scene, spacetime, fan);
        put_look(frame.sphere_map, frame.sphere_colour, frame.sphere_second, sphere->look);
    }
    if (const auto& cylinder = scene.cylinder) {
        frame.cylinder_form = {cylinder->inner, cylinder->outer, cylinder->height, 0};
        put_look(frame.cylinder_map, frame.cylinder_colour, frame.cylinder_second, cylinder->look);
    }
    if (const auto& ball = scene.ball) {
        frame.ball_form = {ball->position, ball->radius};
        put_look(frame.ball_map, frame.ball_colour, frame.ball_second, ball->look);
    }
    if (const auto& surface = scene.surface) {
        constexpr double kDifference = 1e-3;  // of the bound: gradients by differences keep half of a float's digits
        frame.surface_form = {surface->bound, 2 * surface->bound / surface->steps, kDifference * surface->bound,
                              scene.time};
        put_look(frame.surface_map, frame.surface_colour, frame.surface_second, surface->look);
    }
    put_march(frame, scene, spacetime, ball_path);
}

void put_patterns(FrameData& frame, const Scene& scene) {
    if (scene.disc) {  // its brightness is disc_look's
        BodyLook coat = scene.disc->look;
        coat.rotation = scene.disc->rotation;
        put_look(frame.disc_coat_map, frame.disc_coat_colour, frame.disc_coat_second, coat);
    }
    const double cy = std::cos(scene.sky.yaw), sy = std::sin(scene.sky.yaw), ct = std::cos(scene.sky.tilt),
                 st = std::sin(scene.sky.tilt);
    frame.dome_x = {cy, sy, 0, 0};  // columns of R_z(yaw) R_x(tilt)
    frame.dome_y = {-sy * ct, cy * ct, st, 0};
    frame.dome_z = {sy * st, -cy * st, ct, 0};
    BodyLook dome = scene.sky.look;
    dome.brightness = scene.sky.brightness;
    put_look(frame.dome_map, frame.dome_colour, frame.dome_second, dome);
}

}  // namespace nullscope
