// A disc whose rings lie in planes of their own, and which may have gaps (scene/disc_shape.h): by disc_warp_texture, cells of equal ln r.
#include "shared/frame.glsl"

uniform highp sampler2D disc_warp_texture;   // unit normal along the base's axes; ln of the radius to the nearest end of a ring

#define DISC_WARP_CELLS 2000
#define DISC_WARP_BESIDE 0.25   // ln of the radius by which they go beyond both rims

struct DiscRing {
    vec3 normal;    // world axes
    vec3 slope;     // of it, by ln r
    float within;   // ln of the radius to the nearest end of a ring, above 0 on one
};

// Of a vector along the base's axes, in the world's.
vec3 disc_in_world(vec3 v) {
    return v.x * vec3(frame.disc_x.x, frame.disc_x.y, frame.disc_x.z) + v.y * vec3(frame.disc_y.x, frame.disc_y.y, frame.disc_y.z) +
           v.z * vec3(frame.disc_normal.x, frame.disc_normal.y, frame.disc_normal.z);
}

struct DiscWarpPlace {
    vec4 at;      // of the texture
    vec4 slope;   // by ln r; 0 beyond its ends
};

DiscWarpPlace disc_warp_at(float r) {
    float inner = frame.disc_x.w;
    float cells = float(DISC_WARP_CELLS) / (log(frame.disc_y.w / inner) + 2.0 * DISC_WARP_BESIDE);
    float x = (log(r / inner) + DISC_WARP_BESIDE) * cells;
    float kept = clamp(x, 0.0, float(DISC_WARP_CELLS) - 0.001);
    int i = int(kept);
    vec4 low = texelFetch(disc_warp_texture, ivec2(i, 0), 0);
    vec4 change = texelFetch(disc_warp_texture, ivec2(i + 1, 0), 0) - low;
    DiscWarpPlace place;
    place.at = low + (kept - float(i)) * change;
    place.at.w -= abs(x - kept) / cells;
    place.slope = (x == kept ? cells : 0.0) * change;
    return place;
}

DiscRing disc_ring(float r) {
    DiscWarpPlace place = disc_warp_at(r);
    return DiscRing(disc_in_world(vec3(place.at.x, place.at.y, place.at.z)), disc_in_world(vec3(place.slope.x, place.slope.y, place.slope.z)), place.at.w);
}

// Axes of the ring's plane: the base's, turned by the shortest way.
struct DiscAxes {
    vec3 x;
    vec3 y;
    vec3 normal;
};

DiscAxes disc_axes(float r) {
    DiscWarpPlace place = disc_warp_at(r);
    vec3 n = normalize(vec3(place.at.x, place.at.y, place.at.z));
    float turn_x = n.x / (n.z + 1.0);
    float turn_y = n.y / (n.z + 1.0);
    return DiscAxes(disc_in_world(vec3(1.0 - turn_x * n.x, -turn_x * n.y, -n.x)), disc_in_world(vec3(-turn_y * n.x, 1.0 - turn_y * n.y, -n.y)), disc_in_world(n));
}
