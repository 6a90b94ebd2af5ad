// The picture at once, one triangle without a vertex buffer; or, where pixels are drawn again with more rays, the blocks that they are in.
#ifdef EFFECT_REFINE
#include "effect/sampling.glsl"
#include "generated/tiles"
#include "shared/frame.glsl"
#include "stage/tile_point.glsl"
#endif

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
#ifdef EFFECT_REFINE
    int number = gl_VertexID - FIRST_PICTURE_TILE;
    ivec2 tiles = ivec2(frame.image.xy * sampling_share() + float(TILE_SIDE) - 0.5) / TILE_SIDE;
    if (number >= 0) gl_Position = tile_position(number, tiles, true);
    gl_PointSize = tile_point_size();
#endif
}
