// Where the rays of the picture's tiles (stage/tile_rays.glsl) cross the disc's plane first and second: stage/corner_ray.glsl.
uniform highp sampler2D places_texture;
#ifdef CROSSINGS_TOLD
uniform highp sampler2D moves_texture;

// Crossing k, 0 or 1: its place, (x, y) = 0 where there is none, delay, d zeta/d tau.
vec4 crossing_of(ivec2 texel, int k) {
    vec4 places = texelFetch(places_texture, texel, 0);
    vec4 moves = texelFetch(moves_texture, texel, 0);
    return k == 0 ? vec4(places.xy, moves.xy) : vec4(places.zw, moves.zw);
}
#endif
