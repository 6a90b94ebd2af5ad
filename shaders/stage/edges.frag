// Keeps the fragments that differ much from a neighbour (effect/edge.glsl).
#include "effect/edge.glsl"

uniform highp sampler2D picture_texture;
out vec4 mark;

float edge_at(ivec2 place) {
    vec4 pixel = texelFetch(picture_texture, place, 0);
#ifdef EFFECT_POINT_STARS
    return edge_value(pixel.rgb, 0.0);   // alpha is what of the stars shines through
#else
    return pixel.a;
#endif
}

void main() {
    ivec2 place = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(picture_texture, 0) - 1;
    // Neighbours in the driver's own block of 2 x 2 fragments by differences, those beyond it by the pixel across its corner.
    ivec2 beyond = clamp(place + 2 * (place % 2) - 1, ivec2(0), last);
    float here = edge_at(place);
    float most = max(abs(here - edge_at(beyond)), max(abs(dFdx(here)), abs(dFdy(here))));
    float kind = edge_kind(most);
    if (kind == 0.0) discard;
    mark = vec4(kind);
}
