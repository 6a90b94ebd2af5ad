// From the picture in linear light to the display.
#include "effect/display.glsl"
#ifdef EFFECT_AUTO_EXPOSURE
#include "generated/constants"
#endif
#include "shared/frame.glsl"

uniform highp sampler2D picture_texture;
#ifdef EFFECT_BLOOM
uniform highp sampler2D bloom_texture;
#endif
#ifdef EFFECT_AUTO_EXPOSURE
uniform highp sampler2D meter_texture;
#endif
out vec4 colour;

void main() {
    vec3 light = texelFetch(picture_texture, ivec2(gl_FragCoord.xy), 0).rgb;
    float exposure = frame.image.w;
#ifdef EFFECT_BLOOM
    light = mix(light, textureLod(bloom_texture, gl_FragCoord.xy / frame.image.xy, 0.0).rgb, frame.bloom.x);
#endif
#ifdef EFFECT_AUTO_EXPOSURE
    float metered = texelFetch(meter_texture, ivec2(0), 0).r;
    exposure *= METER_KEY / clamp(metered, 1.0e-4, 1.0e30);
#endif
    colour = vec4(display_encode(light, exposure), 1.0);
}
