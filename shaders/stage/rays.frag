// Where the rays of the picture's tiles go, a texel each (stage/tile_rays.glsl).
#include "core/view.glsl"
#include "generated/tiles"
#ifdef EFFECT_DISC
#include "path/crossings"
#endif
#include "path/trace"
#include "shared/frame.glsl"
#include "stage/tile_rays.glsl"

layout(location = 0) out vec4 ray;
#ifdef EFFECT_DISC
layout(location = 1) out vec4 places;   // where it crosses the disc's plane first and second
#endif

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    float middle = 0.5 * float(texel.x % RAYS_A_TILE);
    vec2 tile = vec2(float(texel.x / RAYS_A_TILE), float(texel.y)) - 1.0;
    Trace trace = trace_pixel(picture_place((tile + middle) * float(TILE_SIDE)));
    ray = vec4(trace.sky, trace.escapes ? RAY_ESCAPES : RAY_CAPTURED);
#ifdef EFFECT_DISC
    if (!crossings_known(trace)) ray.w = RAY_TANGLED;
    places = vec4(crossing_place(trace, 0), crossing_place(trace, 1));
#endif
}
