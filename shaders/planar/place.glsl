// Where a ray is after a swept angle, in flat coordinates about the centre: for solid bodies. Of a wormhole, those of one side.
#include "core/trig.glsl"
#ifdef NEEDS_LIGHT_TIMES
#include "planar/delay.glsl"
#endif
#ifdef EFFECT_LENSING
#include "core/orbit.glsl"
#endif
#include "core/pixel_sides.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

struct RayPlace {
    vec3 at;          // r_s, world axes
    vec3 outward;     // unit vector from the centre to it
    vec3 onward;      // unit vector across it, in the ray's plane, towards growing angle
    float r;
    float r_along;    // d r / d phi
    float r_across;   // d r / d |delta| at fixed phi (core/strip.glsl)
#ifdef MARCH_PASSES
    float pixel;      // place_pixel
#endif
#ifdef NEEDS_PLACE_LATE
    float delay;       // how long ago the light left that is seen now; 0 where things are seen at once; not of place_of
#ifdef EFFECT_DELAY
    vec2 time_slope;   // place_time_slope; as that
    float doubt;       // how far from the light-time table's that may be
#endif
#endif
#ifdef EFFECT_SIDES
    float side;       // of the throat: 1 near, -1 far; r is |l|
    float radius;     // R, areal
    float speed;      // d(way)/d(phi): (way)^2 is (dl)^2 + (R dphi)^2
#endif
};

// Unit vector across the radial direction at the camera, in the ray's plane; 0 for an exactly radial ray.
vec3 place_tangent(Trace trace) { return sideways(trace.side) / max(trace.s, 1.0e-30); }

// What of a place is how far out it is; swept: sine and cosine of phi.
#ifdef EFFECT_SIDES
RayPlace place_out(Trace trace, float phi, vec2 swept) {
    // The map holds W (table/throat_orbit.h), which gives l towards the sky where the ray ends.
    OrbitPoint point = orbit_point(trace.escapes, trace.ray.u, trace.ray.slope, phi, trace.phi_end, trace.phi_end_slope);
    float w = clamp(point.zeta, 1.0e-9, 3.1415925);
    vec2 turn = sine_cosine(w);
    float sine = max(turn.x, 1.0e-9);
    float cosine = turn.y;
    float logarithm = frame.throat.y * log(sine);
    float l = frame.throat.x * cosine * (1.0 / sine - logarithm);
    float l_slope = -frame.throat.x * (1.0 / (sine * sine) - sine * logarithm + frame.throat.y * cosine * cosine / sine);
    float outward = l < 0.0 ? -1.0 : 1.0;   // growing |l|
    RayPlace place;
    place.side = trace.escapes ? outward : -outward;
    place.r = max(abs(l), 1.0e-6 * frame.throat.x);
    place.r_along = outward * l_slope * point.along;
    place.r_across = outward * l_slope * point.across;
    // (dl/dphi)^2 = R^4 q^2 - R^2
    float q = max(q_sine(trace.c) / trace_sine(trace), 1.0e-9);
    float steep = min(q * abs(place.r_along), 1.0e18);   // from far away its square has no room in a float
    float r2q2 = 0.5 + sqrt(0.25 + steep * steep);
    place.radius = sqrt(r2q2) / q;
    place.speed = r2q2 / q;
    return place;
}
#else
#ifdef EFFECT_LENSING
// zeta, d zeta/d phi and d zeta/d|delta|.
vec3 place_zeta(Trace trace, float phi, vec2 swept) {
    OrbitPoint point = orbit_point(trace.escapes, trace.ray.u, trace.ray.slope, phi, trace.phi_end, trace.phi_end_slope);
    return vec3(point.zeta, point.along, point.across);
}
#else
// zeta = zeta0 sin(alpha - phi)/sin(alpha), written so that rays towards the centre keep their digits.
vec3 place_zeta(Trace trace, float phi, vec2 swept) {
    float zeta0 = frame.shift.y;
    float s = trace_sine(trace);
    float cotangent = trace.c / s;
    return vec3(zeta0 * (swept.y - cotangent * swept.x), -zeta0 * (swept.x + cotangent * swept.y), zeta0 * swept.x / (s * s));
}
#endif

RayPlace place_out(Trace trace, float phi, vec2 swept) {
    vec3 zeta = place_zeta(trace, phi, swept);
    RayPlace place;
    place.r = 1.0 / max(zeta.x, 1.0e-10);
    place.r_along = -zeta.y * place.r * place.r;
    place.r_across = -zeta.z * place.r * place.r;
    return place;
}
#endif

#ifdef MARCH_PASSES
RayPlace place_with_pixel(RayPlace place, Trace trace, float sin_phi) {
    float steep_along = place.r_along / place.r;
    float along_pixel = abs(place.r_across) * inversesqrt(1.0 + steep_along * steep_along);
    place.pixel = 0.5 * trace.pixel_angle * (along_pixel + place.r * abs(sin_phi) / trace_sine(trace));
    return place;
}
#else
RayPlace place_with_pixel(RayPlace place, Trace trace, float sin_phi) { return place; }
#endif

// 0 <= phi <= trace.phi_end. tangent: place_tangent.
RayPlace place_of(Trace trace, vec3 tangent, float phi) {
    vec2 swept = sine_cosine(phi);
    RayPlace place = place_with_pixel(place_out(trace, phi, swept), trace, swept.x);
    vec3 e = radial_direction();
    place.outward = swept.y * e + swept.x * tangent;
    place.onward = swept.y * tangent - swept.x * e;
    place.at = place.r * place.outward;
#ifdef NEEDS_PLACE_LATE
    place.delay = 0.0;
#ifdef EFFECT_DELAY
    place.time_slope = vec2(0.0);
    place.doubt = 0.0;
#endif
#endif
    return place;
}

#ifdef NEEDS_PLACE_LATE
// 1/A, the most that light needs for a length there: what moves goes that much further while it comes along.
#define PLACE_SLOWEST 1.0e6
float place_slowness(RayPlace place) {
#ifdef EFFECT_DELAY
#ifdef EFFECT_LENSING
    float zeta = 1.0 / place.r;
    return 1.0 / max((1.0 - frame.delay.x * zeta) * (1.0 - frame.delay.y * zeta), 1.0 / PLACE_SLOWEST);
#endif
#endif
    return 1.0;
}

#ifdef EFFECT_DELAY
// Coordinate time of light for a swept angle, dt/dphi = r^2 q/A, and how that changes with the angle.
vec2 place_time_slope(Trace trace, RayPlace place) {
    float slowness = place_slowness(place);
    float rate = place.r * place.r * q_sine(trace.c) / trace_sine(trace) * slowness;
    float change = 2.0 / place.r;
#ifdef EFFECT_LENSING
    float zeta = 1.0 / place.r;
    change -= zeta * zeta * (frame.delay.x + frame.delay.y - 2.0 * frame.delay.x * frame.delay.y * zeta) * slowness;   // A'/A
#endif
    return vec2(rate, rate * change * place.r_along);
}

#define PLACE_DOUBT 1.0   // of the correction: what the next terms may be

// A place whose time follows from one close by, without the light-time table: the trapezoid with the ends' slopes (Euler and Maclaurin).
RayPlace place_timed_beside(Trace trace, RayPlace place, float phi, RayPlace from, float from_phi) {
    float way = phi - from_phi;
    place.time_slope = place_time_slope(trace, place);
    float correction = way * way * (1.0 / 12.0) * (from.time_slope.y - place.time_slope.y);
    place.delay = from.delay + 0.5 * way * (from.time_slope.x + place.time_slope.x) + correction;
    place.doubt = from.doubt + PLACE_DOUBT * abs(correction);
    return place;
}

RayPlace place_beside(Trace trace, vec3 tangent, float phi, RayPlace from, float from_phi) {
    return place_timed_beside(trace, place_of(trace, tangent, phi), phi, from, from_phi);
}
#endif
#endif

#ifdef NEEDS_LIGHT_TIMES
// How long light took from a place after the swept angle phi, whenever what it left is seen.
float place_light_time(Trace trace, RayPlace place, float phi) {
    return light_time(trace, phi, place.r, -place.r_along / (place.r * place.r));
}
#endif

// place_of with its time.
RayPlace place_seen(Trace trace, vec3 tangent, float phi) {
    RayPlace place = place_of(trace, tangent, phi);
#ifdef NEEDS_PLACE_LATE
#ifdef EFFECT_DELAY
    place.delay = place_light_time(trace, place, phi);
    place.time_slope = place_time_slope(trace, place);
#endif
#endif
    return place;
}

// r_s by rad.
float place_speed(RayPlace place) {
    float steep = place.r_along / place.r;   // the square of r_along itself has no room in a float from far away
    return place.r * sqrt(1.0 + steep * steep);
}

// d(place)/d(phi)
vec3 place_velocity(RayPlace place) { return place.r_along * place.outward + place.r * place.onward; }

// Swept angle after `length` more along the ray, taken as straight.
float place_part(RayPlace place, float length) {
#ifdef EFFECT_SIDES
    // dphi = q/R^2 along a way on which R grows by no more than the way itself.
    return length * place.radius / (place.speed * (place.radius + length));
#else
    float steep = place.r_along / place.r;
    float y = length * inversesqrt(1.0 + steep * steep);
    float x = place.r + y * steep;
    return arc_tangent2(max(y, 1.0e-30), x);
#endif
}

// How wide a pixel is there, r_s: its side along the ray's plane, seen across the ray, and its side across it.
vec2 place_pixel_sides(Trace trace, RayPlace place, float phi) {
    float along = abs(place.r_across) * place.r / max(place_speed(place), 1.0e-20);
    float across = place.r * abs(sin(phi)) / trace_sine(trace);
    return trace.pixel_angle * vec2(along, across);
}

// The mean of the two.
float place_pixel(Trace trace, RayPlace place, float phi) {
    vec2 sides = place_pixel_sides(trace, place, phi);
    return 0.5 * (sides.x + sides.y);
}

#define PLACE_NEAREST 1.0e-6   // as TRACE_NEAREST: closer to the radial direction the cross product is all rounding

// How a place moves with the pixel: by an angle within the plane, and turned about the radial direction.
PixelSides solid_sides(Trace trace, RayPlace place) {
    PixelSides sides;
    sides.along = place.r_across * trace.pixel_angle * place.outward;
    sides.across = cross(radial_direction(), place.at) * (trace.pixel_angle / max(trace.s, PLACE_NEAREST * min(frame.shift.y, 1.0)));
    return sides;
}
