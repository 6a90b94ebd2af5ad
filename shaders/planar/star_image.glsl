// Image number `image_order` of a star, src/table/star_lens.h.
#include "shared/frame.glsl"

#ifdef EFFECT_LENSING
uniform highp sampler2D star_lens_texture;
uniform int image_order;
#define STAR_LENS_CELLS 1024

vec4 star_lens_fetch(int i) { return texelFetch(star_lens_texture, ivec2(i, 0), 0); }

// Hermite's cubic over a cell: value and slope at both ends.
float star_lens_cubic(vec2 a, vec2 b, float f) {
    float rise = b.x - a.x;
    float bend = a.y + b.y - 2.0 * rise;
    return a.x + f * (a.y + f * (rise - a.y - bend + f * bend));
}

// (T, |d ln T/d b|) of the ray that ends at b; no slope where there is none.
vec2 star_lens(float b) {
    vec4 scale = star_lens_fetch(STAR_LENS_CELLS + 1);
    float root = sqrt(0.25 * b * b + scale.x * scale.x);
    float weak = b < 0.0 ? root - 0.5 * b : scale.x * scale.x / (root + 0.5 * b);
    float cells = (log(scale.x / weak) - scale.y) * scale.z;
    float x = clamp(cells, 0.0, float(STAR_LENS_CELLS) - 0.001);
    int i = int(x);
    float f = x - float(i);
    vec4 low = star_lens_fetch(i);
    vec4 high = star_lens_fetch(i + 1);
    float slope = star_lens_cubic(low.zw, high.zw, f) * 0.5 / root;
    return vec2(weak * star_lens_cubic(low.xy, high.xy, f), cells > float(STAR_LENS_CELLS) + 0.01 ? 0.0 : slope);
}
#endif

struct StarImage {
    vec3 direction;   // unit, along meridian, transverse and radial, as the static observer sees it
    float spread;     // solid angle of the image over the star's
};

// Closer to the axis through the hole than this (rad) a star's magnification no longer grows: its disc is not a point then.
#define STAR_AXIS 1.0e-6

// The star's distance from the axis through the hole is formed from the difference to the nearer end of that axis: next
// to it a cross product would lose more than the directions' own last bit, 6e-8 rad. From 1e9 r_s that is 1/750 of the
// Einstein radius.
StarImage image_of_star(vec3 place) {
    StarImage image;
    vec3 e = frame.radial.xyz;
    float c = dot(place, e);
    bool behind = c < 0.0;
    vec3 apart = behind ? place + e : place - e;
    vec2 side = vec2(dot(apart, frame.meridian.xyz), dot(apart, frame.transverse.xyz));
    float s = length(side);
#ifdef EFFECT_LENSING
    side /= max(s, 1.0e-30);
    bool odd = (image_order & 1) == 1;
    // b and db/dPhi. Phi - pi = -beta for image 0, k pi - beta (k even) or (k - 1) pi + beta; beta = pi - Theta.
    float b = behind ? -s / (1.0 - c) : -(1.0 + c) / max(s, STAR_AXIS);
    float by_phi = 0.5 + 0.5 * b * b;
    if (image_order > 0) {
        float beta = atan(s, -c);
        b = 0.5 * (odd ? float(image_order - 1) * 3.14159265359 + beta : float(image_order) * 3.14159265359 - beta);
        by_phi = 0.5;
    }
    vec2 lens = star_lens(b);
    float half_sine = lens.x / (1.0 + lens.x * lens.x);
    image.direction = vec3((odd ? -2.0 : 2.0) * half_sine * side, 2.0 * lens.x * half_sine - 1.0);
    image.spread = 4.0 * half_sine * half_sine * lens.y * by_phi / max(s, STAR_AXIS);
#else
    image.direction = vec3(side, c);
    image.spread = 1.0;
#endif
    return image;
}
