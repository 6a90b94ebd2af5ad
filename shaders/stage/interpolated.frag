// The picture where rays are interpolated: the sky alone.
#ifdef DISPLAY_ENCODE
#include "effect/display.glsl"
#endif
#ifdef EFFECT_SKY
#include "object/celestial_sphere.glsl"
#endif
#ifdef EFFECT_SKY_PATTERN
#include "object/sky_pattern.glsl"
#endif
#include "path/trace"
#include "shared/frame.glsl"
#include "stage/tile_varyings.glsl"

out vec4 colour;

void main() {
    vec2 at = tile_place();
    TileSky sky = tile_sky();
    Trace trace = trace_to_sky(gl_FragCoord.xy - 0.5 * frame.image.xy, tile_sky_at(sky, at), tile_sky_right(sky, at), tile_sky_up(sky, at));
    vec3 light = vec3(0.0);
#ifdef EFFECT_SKY
    float detail = tile_detail.x + at.x * tile_detail.y + at.y * (tile_detail.z + at.x * tile_detail.w);
    light += celestial_sphere(trace, footprint_level(detail, frame.sky.y));
#endif
#ifdef EFFECT_SKY_PATTERN
    light += sky_pattern_light(trace);
#endif
    light = tile_escapes() ? light : vec3(0.0);
#ifdef DISPLAY_ENCODE
    light = display_encode(light, frame.image.w);
#endif
    colour = vec4(light, 1.0);
}
