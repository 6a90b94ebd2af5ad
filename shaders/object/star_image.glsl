// Image number `image_order` of a star, src/table/star_lens.h.

#ifdef EFFECT_LENSING
#define STAR_LENS_CELLS 1024
#define STAR_LENS_PER_RAD 81.487330863050   // cells over 4 pi

vec4 star_lens_fetch(int i) { return texelFetch(star_lens_texture, ivec2(i, 0), 0); }

// (alpha, d alpha / d Phi)
vec2 star_lens(float phi) {
    float x = clamp(phi * STAR_LENS_PER_RAD, 0.0, float(STAR_LENS_CELLS) - 0.001);
    int i = int(x);
    float f = x - float(i);
    vec4 a = star_lens_fetch(i);
    vec4 b = star_lens_fetch(i + 1);
    float h = 1.0 / STAR_LENS_PER_RAD;
    float rise = (b.x - a.x) * STAR_LENS_PER_RAD;
    float bend = a.y + b.y - 2.0 * rise;
    float turn = rise - a.y;
    return vec2(a.x + h * f * (a.y + f * (turn - bend + f * bend)), a.y + f * (2.0 * (turn - bend) + f * (3.0 * bend)));
}
#endif

struct StarImage {
    vec3 direction;   // unit, world axes, as the static observer sees it
    float spread;     // solid angle of the image over the star's
};

// Closer to the axis through the hole than this (rad) a star's magnification no longer grows: its disc is not a point then.
#define STAR_AXIS 1.0e-6

StarImage image_of_star(vec3 place) {
    StarImage image;
#ifdef EFFECT_LENSING
    vec3 e = vec3(frame.radial.x, frame.radial.y, frame.radial.z);
    vec3 across = cross(e, place);
    float s = length(across);
    vec3 side = cross(across, e) / max(s, 1.0e-20);
    float theta = atan(s, dot(place, e));
    bool odd = (image_order & 1) == 1;
    vec2 lens = star_lens(odd ? float(image_order + 1) * 3.14159265359 - theta : float(image_order) * 3.14159265359 + theta);
    float sine = sin(lens.x);
    image.direction = cos(lens.x) * e + (odd ? -sine : sine) * side;
    image.spread = abs(lens.y * sine) / max(s, STAR_AXIS);
#else
    image.direction = place;
    image.spread = 1.0;
#endif
    return image;
}
