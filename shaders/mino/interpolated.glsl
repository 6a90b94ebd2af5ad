// A pixel's ray about a rotating hole, interpolated between those that were traced (stage/tile_sky.glsl): of mino/trace.glsl's Trace what a
// sky asks for.
#include "core/pixel_sides.glsl"
#include "mino/ray.glsl"
#include "mino/ray_way.glsl"
#include "shared/frame.glsl"

struct Trace {
    float doppler;
    float pixel_angle;
    bool escapes;
    vec3 sky;
    float stretch_along;
    float stretch_across;
    PixelSides sky_sides;
    float energy;
};

float g_of(Trace trace) { return trace.doppler / max(trace.energy, 1.0e-6); }

float path_way(Trace trace) { return spin_way(trace.escapes, 0.0, 0.0); }   // tiles clear of the disc

PixelSides sky_sides(Trace trace) { return trace.sky_sides; }

// Of a ray to the sky in this direction, which moves by right and up a pixel.
Trace trace_to_sky(vec2 pixel, vec3 sky, vec3 right, vec3 up) {
    Trace trace;
    SpinView view = spin_view(pixel);
    trace.pixel_angle = view.pixel_angle;
    trace.doppler = view.doppler;
    trace.energy = -spin_energy(view.direction);
    trace.escapes = true;
    trace.sky = sky;
    trace.sky_sides.along = right;
    trace.sky_sides.across = up;
    vec2 stretched = sides_stretch(trace.sky_sides, trace.pixel_angle);
    trace.stretch_along = stretched.x;
    trace.stretch_across = stretched.y;
    return trace;
}
