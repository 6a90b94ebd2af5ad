// An image of a star that the host has found (src/render/star_mesh.h).
#include "effect/black_body.glsl"
#include "effect/star_point.glsl"
#include "shared/frame.glsl"

// place: picture_place(); g. make: as planar/stars.glsl, the first for an image over the sky in a pixel.
StarPoint star_point(vec3 place, vec2 make) {
    StarPoint point;
    point.peak = seen_black_body(make.y, place.z, -make.x) * frame.point_stars.x;
    point.pixel = vec2(place.x, place.y);
    point.seen = true;
    return point;
}
