// A pixel's ray about a rotating hole, interpolated between those that were traced (stage/tile_polynomial.glsl): of mino/trace.glsl's Trace what a
// sky and a disc ask for.
#include "core/pixel_sides.glsl"
#include "mino/ray.glsl"
#include "shared/frame.glsl"

struct Trace {
    float doppler;
    float pixel_angle;
    bool escapes;
    vec3 sky;
    float stretch_along;
    float stretch_across;
    PixelSides sky_sides;
    float energy;         // as mino/trace.glsl
#ifdef INTERPOLATED_DISC
    float momentum;
#ifdef NEEDS_RISE
    float rise;           // |p_theta| where the ray crosses the equatorial plane: the root of Carter's constant
#endif
#endif
};

float path_spin() { return frame.spin_hole.x; }

float g_of(Trace trace) { return trace.doppler / max(trace.energy, 1.0e-6); }

PixelSides sky_sides(Trace trace) { return trace.sky_sides; }

// Of a ray to the sky in this direction, which moves by right and up a pixel.
Trace trace_to_sky(vec2 pixel, vec3 sky, vec3 right, vec3 up) {
    Trace trace;
    SpinView view = spin_view(pixel);
    trace.pixel_angle = view.pixel_angle;
    trace.doppler = view.doppler;
    trace.energy = -spin_energy(view.direction);
#ifdef INTERPOLATED_DISC
    float across = spin_across(view.direction);
    trace.momentum = -across * frame.spin_place.x;
#ifdef NEEDS_RISE
    float p_theta = frame.spin_energy.w * view.direction.y;
    float a2e2 = frame.spin_hole.y * trace.energy * trace.energy;
    trace.rise = sqrt(max(p_theta * p_theta + frame.spin_place.y * frame.spin_place.y * (across * across - a2e2), 0.0));
#endif
#endif
    trace.escapes = true;
    trace.sky = sky;
    trace.sky_sides.along = right;
    trace.sky_sides.across = up;
    vec2 stretched = sides_stretch(trace.sky_sides, trace.pixel_angle);
    trace.stretch_along = stretched.x;
    trace.stretch_across = stretched.y;
    return trace;
}
