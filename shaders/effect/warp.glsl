// A mesh lays the picture out anew (scene/warp_mesh.h has the definition). What a place of the screen shows is found here; from there on, all is
// as if the picture had no mesh.
#include "core/view.glsl"
#include "shared/frame.glsl"

uniform highp sampler2D warp_texture;   // render/warp_texture.h: texels by number

#define WARP_ROW 1024       // texels
#define WARP_PICTURE 0      // the first of the two that tell of the bins by the place on the screen,
#define WARP_STARS 2        // and of those by the place in the picture
#define WARP_HALF 4         // half the picture's width and height, factor on shares: 0 where pixels are points
#define WARP_RIM 1.0e-4     // of a triangle beyond its sides, so that nothing is missed between two
#define WARP_NARROWEST 0.1  // as kNarrowestShare of scene/warp_mesh.h

struct WarpPlace {
    vec2 at;       // picture_place() of the projection's own picture
    float light;   // factor; below 0: nothing is drawn here
    float share;   // of a pixel's width, the root of areas
};

// Lengths: half heights of the screen. move: from its place on the screen to that in the picture.
struct WarpNode {
    vec2 place;
    vec2 move;
    float light;
};

vec4 warp_texel(int number) { return texelFetch(warp_texture, ivec2(number % WARP_ROW, number / WARP_ROW), 0); }

WarpNode warp_node(float first) {
    int number = int(first);
    vec4 place = warp_texel(number);
    return WarpNode(place.xy, place.zw, warp_texel(number + 1).x);
}

float warp_area(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// found, unless the place is within the triangle. at: half heights; found.at: likewise, the move alone.
WarpPlace warp_triangle(vec2 at, WarpNode a, WarpNode b, WarpNode c, WarpPlace found) {
    vec2 p = b.place - a.place;
    vec2 q = c.place - a.place;
    vec2 r = at - a.place;
    float area = warp_area(p, q);
    if (abs(area) < 1.0e-30) return found;
    float s = warp_area(r, q) / area;
    float t = warp_area(p, r) / area;
    if (s < -WARP_RIM || t < -WARP_RIM || s + t > 1.0 + WARP_RIM) return found;
    WarpPlace here;
    here.at = a.move + s * (b.move - a.move) + t * (c.move - a.move);
    here.light = max(a.light + s * (b.light - a.light) + t * (c.light - a.light), 0.0);
    here.share = sqrt(abs(warp_area(p + b.move - a.move, q + c.move - a.move) / area));
    return here;
}

// Of a node: it lies where it is seen on the screen, or where it is in the picture.
WarpNode warp_sided(WarpNode node, bool in_picture) {
    return in_picture ? WarpNode(node.place + node.move, -node.move, node.light) : node;
}

// The last cell at a place, half heights; light is below 0 where there is none. at: the move from there.
WarpPlace warp_search(vec2 at, int head, bool in_picture) {
    WarpPlace found = WarpPlace(vec2(0.0), -1.0, 1.0);
    vec4 bins = warp_texel(head);          // of the lower left one, and how many there are in a length
    vec4 counts = warp_texel(head + 1);    // along both sides; the first one's texel
    vec2 bin = floor((at - bins.xy) * bins.zw);
    if (bin.x < 0.0 || bin.y < 0.0 || bin.x >= counts.x || bin.y >= counts.y) return found;
    vec4 list = warp_texel(int(counts.z) + int(bin.x) + int(bin.y) * int(counts.x));   // its first cell, how many
    int cell = int(list.x);
    int end = cell + int(list.y);
    while (cell < end) {
        vec4 corners = warp_texel(cell);
        WarpNode a = warp_sided(warp_node(corners.x), in_picture);
        WarpNode b = warp_sided(warp_node(corners.y), in_picture);
        WarpNode c = warp_sided(warp_node(corners.z), in_picture);
        WarpNode d = warp_sided(warp_node(corners.w), in_picture);
        WarpNode middle = WarpNode(0.25 * (a.place + b.place + c.place + d.place), 0.25 * (a.move + b.move + c.move + d.move),
                                   0.25 * (a.light + b.light + c.light + d.light));
        found = warp_triangle(at, middle, a, b, found);
        found = warp_triangle(at, middle, b, c, found);
        found = warp_triangle(at, middle, c, d, found);
        found = warp_triangle(at, middle, d, a, found);
        ++cell;
    }
    return found;
}

vec2 warp_half_heights(vec2 place) { return (place - frame.warp.yz) / frame.warp.x; }
bool warp_beyond(vec2 at) {
    vec2 beyond = abs(at) - warp_texel(WARP_HALF).xy;
    return max(beyond.x, beyond.y) > 0.0;
}

// place: picture_place().
WarpPlace warp_place(vec2 place) {
    vec2 at = warp_half_heights(place);
    WarpPlace found = warp_search(at, WARP_PICTURE, false);
    if (found.light < 0.0 || warp_beyond(at + found.at)) return WarpPlace(place, -1.0, 1.0);
    found.at = place + frame.warp.x * found.at;
    found.share = max(found.share * warp_texel(WARP_HALF).z, WARP_NARROWEST);
    return found;
}

#ifdef EFFECT_POINT_STARS
// Where on the screen a place of the projection's own picture is; share: of the screen over the picture.
WarpPlace warp_seen(vec2 place) {
    vec2 at = warp_half_heights(place);
    WarpPlace found = warp_search(at, WARP_STARS, true);
    if (warp_beyond(at)) found.light = -1.0;
    found.at = place + frame.warp.x * found.at;
    return found;
}
#endif

// On light, of the mesh's intensity: its power, where it is one of a display's values.
float warp_factor(float intensity) {
    float light = max(intensity, 0.0);
    return frame.warp.w > 0.0 && light > 0.0 ? pow(light, frame.warp.w) : light;
}

float warp_light = 1.0;   // of the ray that was looked for last: factor on its light

// Where a ray looks: the projection's own place of a place of the screen.
vec2 warp_ray(vec2 place) {
    WarpPlace seen = warp_place(place);
    warp_light = warp_factor(seen.light);
    pixel_share = seen.share;
    return seen.at;
}
