// Where rays end: rows of ENDS_CELLS_PER_OCTAVE cells (core/strip.glsl).
#ifndef __cplusplus
uniform highp sampler2D ends_texture;
vec4 ends_fetch(int x, int y) { return texelFetch(ends_texture, ivec2(x, y), 0); }
#endif
