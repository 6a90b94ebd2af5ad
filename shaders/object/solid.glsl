// How a solid body's light reaches the pixel: the footprint on its surface, and the darkening towards the limb.
#include "core/pixel_sides.glsl"
#include "path/place"
#include "path/trace"

struct SolidSpot {
    vec3 along;     // footprint of one pixel on the surface, r_s: image of one side of it
    vec3 across;    // ... and of the other
    float cosine;   // between the ray and the normal, in flat coordinates
};

SolidSpot solid_spot(Trace trace, RayPlace place, vec3 normal) {
    vec3 velocity = place_velocity(place);
    float speed = max(sqrt(dot(velocity, velocity)), 1.0e-20);
    SolidSpot spot;
    spot.cosine = clamp(-dot(normal, velocity) / speed, 0.0, 1.0);
    PixelSides sides = solid_sides(trace, place);
    // Slid along the ray back to the surface.
    float slide = 1.0 / (speed * max(spot.cosine, 0.03));
    spot.along = sides.along + velocity * (dot(normal, sides.along) * slide);
    spot.across = sides.across + velocity * (dot(normal, sides.across) * slide);
    return spot;
}

// Of light from a far sun, Lambert's law. sun: its direction, and what the side away from it has.
float solid_day(vec4 sun, vec3 normal) { return sun.w + (1.0 - sun.w) * max(dot(normal, sun.xyz), 0.0); }

float solid_limb(float limb, float cosine) { return 1.0 - limb * (1.0 - cosine); }
