// From linear light to the display: exposure, a tone curve, sRGB encoding.
#ifdef EFFECT_DITHER
#include "shared/fragment_at.glsl"
#include "shared/frame.glsl"
#endif

// IEC 61966-2-1 without pow: three square roots a channel, with the factors of the least largest error, 1/22500 (0.0114 of a step of
// 8 bits); straight next to black, as the standard is.
vec3 srgb_encode(vec3 c) {
    vec3 s1 = sqrt(c);
    vec3 s2 = sqrt(s1);
    vec3 s3 = sqrt(s2);
    vec3 curve = 0.642366773 * s1 + 0.712109149 * s2 - 0.336869386 * s3 - 0.0175634953 * c;
    return mix(curve, 12.92 * c, lessThan(c, vec3(0.0031308)));
}

#ifdef EFFECT_TONE_FILM
// Narkowicz's fit (2015) of the Academy's reference rendering (ACES), without its change of primaries.
vec3 tone_film(vec3 c) { return (c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14); }
#endif

#ifdef EFFECT_TONE_NEUTRAL
// Khronos PBR Neutral (2024): colours stay as they are up to 0.76 of white, then are compressed and, when very bright, paled.
vec3 tone_neutral(vec3 c) {
    float low = min(c.r, min(c.g, c.b));
    c -= low < 0.08 ? low - 6.25 * low * low : 0.04;
    float peak = max(c.r, max(c.g, c.b));
    float compressed = 1.0 - 0.0576 / (max(peak, 0.76) - 0.52);
    vec3 shown = c * (compressed / max(peak, 0.76));
    return peak < 0.76 ? c : mix(vec3(compressed), shown, 1.0 / (0.15 * (peak - compressed) + 1.0));
}
#endif

#ifdef EFFECT_DITHER
// Noise of -1/2 ... 1/2 steps of 8 bits, whose neighbours differ (interleaved gradient noise, Jimenez 2014). Black stays black.
float dither_noise(vec2 pixel) {
    return (fract(52.9829189 * fract(0.06711056 * pixel.x + 0.00583715 * pixel.y)) - 0.5) * (1.0 / 255.0);
}
#endif

vec3 display_encode(vec3 linear, float exposure) {
    vec3 c = min(linear * exposure, vec3(1.0e4));
#ifdef EFFECT_TONE_FILM
    c = tone_film(c);
#else
#ifdef EFFECT_TONE_NEUTRAL
    c = tone_neutral(c);
#else
    c = vec3(1.0) - exp(-c);
#endif
#endif
    c = srgb_encode(clamp(c, 0.0, 1.0));
#ifdef EFFECT_DITHER
    c += dither_noise(fragment_at() + frame.dither.xy);
#endif
    return c;
}
