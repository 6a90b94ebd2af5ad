// The picture at once, one triangle without a vertex buffer; or, where pixels are drawn again with more rays, a point for each.
#ifdef EFFECT_REFINE
#include "stage/tile_point.glsl"
#endif

void main() {
    vec4 corner = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
#ifdef EFFECT_REFINE
    place_point(gl_VertexID, ivec2(1), true);
    if (!draws_patches()) gl_Position = corner;
#else
    gl_Position = corner;
#endif
}
