// A tile of a picture with matter as a point, if it is one of those that a stage draws.
#include "shared/frame.glsl"
#include "stage/lattice_tells.glsl"
#include "stage/tile_point.glsl"

void main() {
    ivec2 tiles = ivec2(frame.image.xy * sampling_share() + float(TILE_SIDE) - 0.5) / TILE_SIDE;
    float size = tile_point_size();
    vec2 low = size * vec2(tile_point(gl_VertexID, tiles));
    gl_Position = tile_position(gl_VertexID, tiles, lattice_draws(low, low + size));
    gl_PointSize = size;
}
