// A sphere on its way. Its form: how long ago light left at the first node of its path, 1/step, largest speed; radius.
#include "path/place"
#include "shared/objects.glsl"

uniform highp sampler2D ball_path_texture;   // of ball k: row 2 k its places at equal steps of that time, row 2 k + 1 their derivative
vec4 ball_path_fetch(int x, int y) { return texelFetch(ball_path_texture, ivec2(x, y), 0); }

float moving_ball_size(int i) { return body_form(i).w; }

// Its middle when the light left: cubic between the nodes. Before the first light has not come to where it may be, and it is at that node, so
// that steps are not too long for it; after the last it is far away.
vec3 moving_ball_middle(int i, RayPlace place) {
    vec4 form = body_form(i);
    int row = 2 * (i - BALL_PATH_FIRST);
    float x = max((place.delay - form.x) * form.y, 0.0);
    float last = float(textureSize(ball_path_texture, 0).x - 1);
    int node = int(min(x, last - 1.0));
    float f = x - float(node);
    vec3 low = ball_path_fetch(node, row).xyz;
    vec3 high = ball_path_fetch(node + 1, row).xyz;
    vec3 low_step = ball_path_fetch(node, row + 1).xyz;
    vec3 high_step = ball_path_fetch(node + 1, row + 1).xyz;
    vec3 middle = low + f * f * (3.0 - 2.0 * f) * (high - low) + f * (1.0 - f) * (1.0 - f) * low_step + f * f * (f - 1.0) * high_step;
    return x <= last ? middle : vec3(1.0e9);
}

float moving_ball_value(int i, RayPlace place) {
    vec3 offset = place.at - moving_ball_middle(i, place);
    return sqrt(dot(offset, offset)) - body_form(i).w;
}
// It comes to meet the ray: both move.
float moving_ball_room(int i, RayPlace place) { return moving_ball_value(i, place) / (1.0 + body_form(i).z * place_slowness(place)); }
vec3 moving_ball_normal(int i, RayPlace place) { return (place.at - moving_ball_middle(i, place)) / body_form(i).w; }
