// How a solid body's light reaches the pixel: the footprint on its surface, and the darkening towards the limb.
#include "object/ray_place.glsl"
#include "object/tracer.glsl"

struct SolidSpot {
    vec3 at;        // r_s
    vec3 along;     // footprint of one pixel on the surface, r_s: image of one side of it
    vec3 across;    // ... and of the other
    float cosine;   // between the ray and the normal, in flat coordinates
};

SolidSpot solid_spot(Trace trace, RayPlace place, vec3 normal) {
    vec3 velocity = place_velocity(place);
    float speed = max(sqrt(dot(velocity, velocity)), 1.0e-20);
    SolidSpot spot;
    spot.at = place.at;
    spot.cosine = clamp(-dot(normal, velocity) / speed, 0.0, 1.0);
#ifdef EFFECT_SPIN
    vec3 within = trace.solid_right;
    vec3 round = trace.solid_up;
#else
    // The pixel moved by an angle within the plane, and turned about the radial direction.
    vec3 within = place.r_across * trace.pixel_angle * place.outward;
    vec3 round = cross(radial_direction(), place.at) * (trace.pixel_angle / max(trace.s, 1.0e-6));
#endif
    // Slid along the ray back to the surface.
    float slide = 1.0 / (speed * max(spot.cosine, 0.03));
    spot.along = within + velocity * (dot(normal, within) * slide);
    spot.across = round + velocity * (dot(normal, round) * slide);
    return spot;
}

float solid_limb(float limb, float cosine) { return 1.0 - limb * (1.0 - cosine); }
