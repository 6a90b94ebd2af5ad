// One pixel's ray from the camera to its end: set-up, aberration, lookup of the strip. Stage shaders and the C++ core share it.
// Reads the globals `frame` (FrameData) and strip_fetch / orbit_fetch.
#include "shared/frame.glsl"
#ifdef EFFECT_ABERRATION
#include "core/aberration.glsl"
#endif
#include "core/pixel_sides.glsl"
#ifdef NEEDS_SCREEN
#include "core/screen.glsl"
#endif
#include "core/view.glsl"
#ifdef EFFECT_LENSING
#include "core/strip.glsl"
#include "core/sweep.glsl"
#include "generated/method"
#ifdef NEEDS_PHI_END
#include "core/ends.glsl"
#endif
#else
#ifdef NEEDS_PHI_END
#include "core/trig.glsl"
#endif
#endif

struct Trace {
    float doppler;        // frequency in the camera over frequency in the radial frame
    float pixel_angle;    // angle that one pixel spans here, rad, in the radial frame
    vec2 side;            // components of the unit view direction n along frame.meridian and frame.transverse
    float s;              // |n x e| = |side|
    float c;              // n . e
    bool escapes;
    vec3 sky;             // direction on the celestial sphere, unit to rounding; of use if escapes
    float stretch_along;  // d phi / d alpha: how fast the sky direction moves in the ray's plane
    float stretch_across; // sin(phi) / sin(alpha): and across it
#ifdef NEEDS_SCREEN
    vec2 screen_phase;
#endif
#ifdef NEEDS_PHI_END
    float phi_end;        // swept to the sky or to the horizon
    float phi_end_slope;  // d phi_end / d |delta|, core/strip.glsl
#ifdef EFFECT_LENSING
    StripRay ray;
#endif
#endif
};

// What every kind of path says of its rays.
float path_spin() { return 0.0; }                 // a of a rotating hole, r_s
float path_steps(Trace trace) { return 0.0; }     // that the tracer took
#ifdef EFFECT_DISC
#ifdef EFFECT_LENSING
#ifdef NEEDS_FOOTPRINT
#define DISC_IS_THIN   // images of the disc may be: planar/disc_thin.glsl
#endif
#endif
#endif
#ifndef EFFECT_DISC
float path_way(Trace trace) { return 0.0; }       // effect/edge.glsl
#endif
float swept_angle(float along) { return along; }  // of a place on the ray, by what tells the order of places
#ifdef NEEDS_PHI_END
float path_angle(Trace trace) { return trace.phi_end; }   // swept to the end
#endif

// n x e's length as a divisor: rays that pass a distant camera's hole have small ones.
#define TRACE_NEAREST 1.0e-9   // r_s from the centre, of a straight ray
float trace_sine(Trace trace) { return max(trace.s, TRACE_NEAREST * min(frame.shift.y, 1.0)); }

vec3 radial_direction() { return vec3(frame.radial.x, frame.radial.y, frame.radial.z); }

#ifdef EFFECT_ZOOM
// What a zoom leaves out of what a ray has swept, and of its light's time: rays that have come past the middle of it have all.
float ring_part(float phi, float all) { return phi > frame.ring.z ? all : 0.0; }
#endif

// Across the radial direction, in world axes.
vec3 sideways(vec2 side) {
    return side.x * vec3(frame.meridian.x, frame.meridian.y, frame.meridian.z) +
           side.y * vec3(frame.transverse.x, frame.transverse.y, frame.transverse.z);
}

// Frequency at infinity over frequency in the radial frame, in the direction with cosine c from e.
float energy_at(float c) { return frame.shift.x + frame.shift.z * c; }

// g: the camera's frequency over that at infinity.
float g_of(Trace trace) { return frame.radial.w * trace.doppler / energy_at(trace.c); }

// q sin(alpha), alpha the ray's angle from e; at rest it is sqrt(V(zeta0)) for all rays.
float q_sine(float c) { return frame.shift.y * energy_at(c); }

// n x e
vec3 crossed_direction(Trace trace) { return sideways(vec2(trace.side.y, -trace.side.x)); }

vec3 look_direction(PixelView view) {
    vec4 ray = view_form(frame.ray_0, frame.ray_x, frame.ray_y, view);
    return vec3(ray.x, ray.y, ray.z);
}

// Where a pixel looks.
struct TraceLook {
    float doppler;
    float pixel_angle;
    vec2 side;        // Trace
    float c;
#ifdef EFFECT_LENSING
    float tangent;    // strip_locate
#else
    vec3 direction;   // n, world axes
#endif
};

#ifdef EFFECT_ABERRATION
Aberration look_seen(PixelView view) {
    return aberrate(look_direction(view), vec3(frame.boost.x, frame.boost.y, frame.boost.z), frame.boost.w, frame.boost_colour.x);
}
#endif

#ifdef EFFECT_ZOOM
// No direction is formed before what is small in it: next to the critical curve each keeps its digits, in motion too.
TraceLook look_along(TraceLook look, PixelView view, vec2 pixel) {
#ifdef EFFECT_ABERRATION
    Aberration seen = look_seen(view);
    look.doppler = seen.doppler;
    look.pixel_angle *= seen.squeeze;
#endif
    float square = dot(pixel, pixel) * (frame.image.z * frame.image.z);
    float longer = square * view.inverse_length / (1.0 + view.inverse_length);   // |v| - 1
    float scale = 1.0 / (frame.polar_weight.x + pixel.x * frame.polar_weight.y + pixel.y * frame.polar_weight.z + longer * frame.polar_weight.w);
    vec4 polar = (frame.polar_0 + pixel.x * frame.polar_x + pixel.y * frame.polar_y + longer * frame.polar_length) * scale;
    look.side = vec2(polar.x, polar.y);
    look.c = polar.z;
    look.tangent = polar.w;
    return look;
}
#else
#ifdef EFFECT_ABERRATION
TraceLook look_along(TraceLook look, PixelView view, vec2 pixel) {
    Aberration seen = look_seen(view);
    vec3 n = seen.direction;
    look.doppler = seen.doppler;
    look.pixel_angle *= seen.squeeze;
    look.side = vec2(dot(n, vec3(frame.meridian.x, frame.meridian.y, frame.meridian.z)),
                     dot(n, vec3(frame.transverse.x, frame.transverse.y, frame.transverse.z)));
    look.c = dot(n, radial_direction());
#ifdef EFFECT_LENSING
    look.tangent = frame.strip.y * look.c - frame.strip.x * look.side.x;
#else
    look.direction = n;
#endif
    return look;
}
#else
TraceLook look_along(TraceLook look, PixelView view, vec2 pixel) {
    vec4 polar = view_form(frame.polar_0, frame.polar_x, frame.polar_y, view);
    look.side = vec2(polar.x, polar.y);
    look.c = polar.z;
#ifdef EFFECT_LENSING
    look.tangent = polar.w;
#else
    look.direction = look_direction(view);
#endif
    return look;
}
#endif
#endif

#ifdef SLOT_MEDIUM
// Matter is followed by the swept angle. The ray passes the centre at least 1e-7 r_s away.
vec2 beside_centre(vec2 side) {
    float aside = 1.0e-7 * min(frame.shift.y, 1.0);
    return vec2(side.x + (dot(side, side) < aside * aside ? aside : 0.0), side.y);
}
#else
vec2 beside_centre(vec2 side) { return side; }
#endif

#ifdef EFFECT_LENSING
#ifdef NEEDS_PHI_END
Trace trace_end(Trace trace, StripRay ray) {
    Octave octave = octave_cell(ray.u, ENDS_CELLS_PER_OCTAVE);
    int end_row = ray.escapes ? ENDS_ROW_SKY : ENDS_ROW_CAPTURED;
#ifdef EFFECT_BOUNCE
    end_row = ray.by_centre ? ENDS_ROW_CENTRE : end_row;
#endif
    vec4 end_poly = ends_fetch(octave.cell, end_row);
    float end_ratio = cubic(end_poly, octave.place);
    float end_slope = cubic_slope(end_poly, octave.place) * (float(ENDS_CELLS_PER_OCTAVE) / octave.start * ray.slope);
    trace.ray = ray;
    trace.phi_end = end_ratio * trace.s;
    trace.phi_end_slope = end_slope * trace.s + end_ratio * strip_s_slope(ray, trace.c);
    return trace;
}
#else
Trace trace_end(Trace trace, StripRay ray) { return trace; }
#endif

Trace trace_along(Trace trace, TraceLook look) {
    StripRay ray = strip_locate(trace.side, trace.s, trace.c, look.tangent, frame.strip, frame.series.w);
    Sweep sweep = sweep_to_sky(ray, trace.s, trace.c);
    trace.escapes = ray.escapes;
    trace.sky = sweep.cos_phi * radial_direction() + sideways(sweep.ratio * trace.side);
    trace.stretch_along = sweep.along;
    trace.stretch_across = sweep.ratio;
    return trace_end(trace, ray);
}
#else
Trace trace_along(Trace trace, TraceLook look) {
    trace.escapes = true;
    trace.sky = look.direction;
    trace.stretch_along = 1.0;
    trace.stretch_across = 1.0;
#ifdef NEEDS_PHI_END
    trace.phi_end = arc_tangent2(trace.s, trace.c);
    trace.phi_end_slope = 1.0;
#endif
    return trace;
}
#endif

// pixel: picture_place().
Trace trace_pixel(vec2 pixel) {
    PixelView view = pixel_view(pixel);
    TraceLook look;
    look.doppler = 1.0;
    look.pixel_angle = view.angle;
    look = look_along(look, view, pixel);
    Trace trace;
#ifdef NEEDS_SCREEN
    trace.screen_phase = screen_phase(view);
#endif
    trace.doppler = look.doppler;
    trace.pixel_angle = look.pixel_angle;
    trace.side = beside_centre(look.side);
    trace.s = sqrt(dot(trace.side, trace.side));
    trace.c = look.c;
    return trace_along(trace, look);
}

// Sides of the pixel's box on the sky, within the ray's plane and across it.
#define SKY_WIDEST 4.0   // boxes wider than the sphere are all of it
PixelSides sky_sides(Trace trace) {
    vec3 across = crossed_direction(trace) / max(trace.s, 1.0e-30);   // 0 for an exactly radial ray: no box
    vec3 along = cross(across, trace.sky);
    PixelSides sides;
    sides.along = along * clamp(trace.stretch_along * trace.pixel_angle, -SKY_WIDEST, SKY_WIDEST);
    sides.across = across * clamp(trace.stretch_across * trace.pixel_angle, -SKY_WIDEST, SKY_WIDEST);
    return sides;
}
