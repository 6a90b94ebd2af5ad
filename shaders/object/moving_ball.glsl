// A sphere on its way. Its form: how long ago light left at the first node of its path, 1/step, largest speed; radius.
#ifdef MARCH_PASSES
#include "object/passing.glsl"
#endif
#include "object/unseen.glsl"
#include "path/place"
#include "shared/objects.glsl"

uniform highp sampler2D ball_path_texture;   // of ball k: row 2 k its places at equal steps of that time, row 2 k + 1 their derivative
vec4 ball_path_fetch(int x, int y) { return texelFetch(ball_path_texture, ivec2(x, y), 0); }

float moving_ball_size(int i) { return body_form(i).w; }

// A part of its path, between two nodes: the cubic with their places and derivatives, by steps of time f from the first on.
struct BallPath {
    vec3 low;
    vec3 high;
    vec3 low_step;
    vec3 high_step;
    float f;
    float bend;   // the largest acceleration from the first node on, for BALL_PATH_AHEAD nodes, c^2/r_s
    bool known;   // not after the last node
};

// When the light left. Before the first node light has not come to where it may be, and it is at that node, so that steps are not too long for it.
BallPath moving_ball_path(int i, RayPlace place) {
    vec4 form = body_form(i);
    int row = 2 * (i - BALL_PATH_FIRST);
    float x = max((place.delay - form.x) * form.y, 0.0);
    float last = float(textureSize(ball_path_texture, 0).x - 1);
    int node = int(min(x, last - 1.0));
    BallPath path;
    vec4 low = ball_path_fetch(node, row);
    path.low = low.xyz;
    path.bend = low.w;
    path.high = ball_path_fetch(node + 1, row).xyz;
    path.low_step = ball_path_fetch(node, row + 1).xyz;
    path.high_step = ball_path_fetch(node + 1, row + 1).xyz;
    path.f = x - float(node);
    path.known = x <= last;
    return path;
}

// Its middle; after the last node it is far away.
vec3 ball_path_place(BallPath path) {
    float f = path.f;
    vec3 middle = path.low + f * f * (3.0 - 2.0 * f) * (path.high - path.low) + f * (1.0 - f) * (1.0 - f) * path.low_step + f * f * (f - 1.0) * path.high_step;
    return path.known ? middle : vec3(1.0e9);
}

vec3 moving_ball_middle(int i, RayPlace place) { return ball_path_place(moving_ball_path(i, place)); }

#define BALL_PATH_CELL 1.5   // how far it goes within a cell, over that at its largest speed: and more than rounding

// Of its room, by the node before alone.
float moving_ball_least(int i, RayPlace place) {
    vec4 form = body_form(i);
    float last = float(textureSize(ball_path_texture, 0).x - 1);
    float node = clamp((place.delay - form.x) * form.y, 0.0, last - 1.0);
    vec3 offset = place.at - ball_path_fetch(int(node), 2 * (i - BALL_PATH_FIRST)).xyz;
    return (sqrt(dot(offset, offset)) - form.w - BALL_PATH_CELL * form.z / form.y) / (1.0 + form.z * place_slowness(place));
}

float moving_ball_value(int i, RayPlace place) {
    vec3 middle = moving_ball_middle(i, place);
    vec3 offset = place.at - middle;
    float unseen = max(solid_unseen(place.r), UNSEEN_STEEP * solid_unseen(sqrt(dot(middle, middle))));
    return max(sqrt(dot(offset, offset)) - body_form(i).w, unseen);
}
// It comes to meet the ray: both move.
float moving_ball_away(int i, RayPlace place) { return moving_ball_value(i, place) / (1.0 + body_form(i).z * place_slowness(place)); }
#ifdef MARCH_PASSES
// How long light takes for a length changes by no more than slowness^2 of how much light bends.
Passing moving_ball_passing(int i, RayPlace place) {
    BallPath path = moving_ball_path(i, place);
    vec4 form = body_form(i);
    vec3 offset = place.at - ball_path_place(path);
    float slowness = place_slowness(place);
    float room = (sqrt(dot(offset, offset)) - form.w) / (1.0 + form.z * slowness);
    float f = path.f;
    vec3 way = path.high - path.low;
    vec3 step = 6.0 * f * (1.0 - f) * way + (1.0 - f) * (1.0 - 3.0 * f) * path.low_step + f * (3.0 * f - 2.0) * path.high_step;
#ifdef EFFECT_DELAY
    float steps = place.time_slope.x / max(place_speed(place), 1.0e-20) * form.y;   // of time, for a length
#else
    float steps = 0.0;
#endif
    float most = PASSING_SLOWER * slowness;
    float bend = passing_bend(place) * (1.0 + form.z * most * most) + path.bend * most * most;
    Passing passing = passing_ball(place, offset, form.w, passing_course(place) - steps * step, bend, room);
    float known = (float(BALL_PATH_AHEAD) - f) / (form.y * most);
    known = place.delay >= form.x ? known : 0.0;
    passing.room = max(room, min(passing.room, known));
    passing.stride = max(room, min(passing.stride, known));
    return passing;
}
float moving_ball_room(int i, RayPlace place) { return moving_ball_passing(i, place).room; }
float moving_ball_stride(int i, RayPlace place) { return moving_ball_passing(i, place).stride; }
#else
float moving_ball_room(int i, RayPlace place) { return moving_ball_away(i, place); }
float moving_ball_stride(int i, RayPlace place) { return moving_ball_room(i, place); }
#endif
vec3 moving_ball_normal(int i, RayPlace place) { return (place.at - moving_ball_middle(i, place)) / body_form(i).w; }
