// The picture where the disc covers all: what it is at the crossing that the tile says.
#ifdef DISPLAY_ENCODE
#include "effect/display.glsl"
#endif
#include "object/disc_colour.glsl"
#include "path/disc"
#include "path/trace"
#include "shared/frame.glsl"
#include "stage/pixel.glsl"

flat in highp float tile_number;   // stage/tile.vert

out vec4 colour;

void main() {
    Trace trace = trace_pixel(fragment_pixel());
    vec4 disc = disc_colour(trace, disc_crossing_within(trace, int(tile_number)));
    vec3 light = disc.rgb;
#ifdef DISPLAY_ENCODE
    light = display_encode(light, frame.image.w);
#endif
    colour = vec4(light, 1.0 - disc.a);
}
