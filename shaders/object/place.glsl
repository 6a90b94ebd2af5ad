// Where a ray is after a swept angle, in flat coordinates about the centre: for solid bodies.

struct RayPlace {
    vec3 at;          // r_s, world axes
    vec3 outward;     // unit vector from the centre to it
    vec3 onward;      // unit vector across it, in the ray's plane, towards growing angle
    float r;
    float r_along;    // d r / d phi
    float r_across;   // d r / d |delta| at fixed phi (core/strip.glsl)
#ifdef NEEDS_PLACE_LATE
    float late;       // how long ago the light left that arrives now
#endif
};

// Unit vector across the radial direction at the camera, in the ray's plane; 0 for an exactly radial ray.
vec3 place_tangent(Trace trace) { return sideways(trace.side) / max(trace.s, 1.0e-30); }

// 0 <= phi <= trace.phi_end. tangent: place_tangent.
RayPlace place_of(Trace trace, vec3 tangent, float phi) {
    float cos_phi = cos(phi);
    float sin_phi = sin(phi);
#ifdef EFFECT_LENSING
    OrbitPoint point = orbit_point(trace.escapes, trace.ray.u, trace.ray.slope, phi, trace.phi_end, trace.phi_end_slope);
    float zeta = point.zeta;
    float along = point.along;
    float across = point.across;
#else
    // zeta = zeta0 sin(alpha - phi)/sin(alpha), written so that rays towards the centre keep their digits.
    float zeta0 = frame.shift.y;
    float s = max(trace.s, 1.0e-9);
    float cotangent = trace.c / s;
    float zeta = zeta0 * (cos_phi - cotangent * sin_phi);
    float along = -zeta0 * (sin_phi + cotangent * cos_phi);
    float across = zeta0 * sin_phi / (s * s);
#endif
    zeta = max(zeta, 1.0e-10);
    RayPlace place;
    place.r = 1.0 / zeta;
    place.r_along = -along * place.r * place.r;
    place.r_across = -across * place.r * place.r;
    vec3 e = radial_direction();
    place.outward = cos_phi * e + sin_phi * tangent;
    place.onward = cos_phi * tangent - sin_phi * e;
    place.at = place.r * place.outward;
#ifdef NEEDS_PLACE_LATE
    place.late = 0.0;
#ifdef EFFECT_DELAY
    place.late = light_time(trace, phi, zeta, along);
#endif
#endif
    return place;
}

// d(place)/d(phi)
vec3 place_velocity(RayPlace place) { return place.r_along * place.outward + place.r * place.onward; }

// How wide a pixel is there, r_s: the mean of its side along the ray's plane and of its side across it, seen across the ray.
float place_pixel(Trace trace, RayPlace place, float phi) {
    float speed = sqrt(place.r_along * place.r_along + place.r * place.r);
    float along = abs(place.r_across) * place.r / max(speed, 1.0e-20);
    float across = place.r * abs(sin(phi)) / max(trace.s, 1.0e-9);
    return 0.5 * trace.pixel_angle * (along + across);
}

// What a solid body's hit is known by.
struct SolidHit {
    int object;      // its number (scene/ray.h), 0 for none
    float phi;       // swept angle there; trace.phi_end for none
    float covered;   // part of the pixel that the body covers
};
