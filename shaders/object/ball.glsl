// A sphere anywhere.
#include "path/place"
#include "shared/frame.glsl"

#ifdef EFFECT_BALL_PATH
uniform highp sampler2D ball_path_texture;
vec4 ball_path_fetch(int x, int y) { return texelFetch(ball_path_texture, ivec2(x, y), 0); }

// Its middle when the light left: cubic between the nodes of ball_path_texture (row 0 places, row 1 steps), far away where there are none.
vec3 ball_middle(RayPlace place) {
    float x = (place.late - frame.ball_path.x) * frame.ball_path.y;
    float last = frame.ball_path.z;
    int i = int(clamp(x, 0.0, last - 1.0));
    float f = x - float(i);
    vec3 low = ball_path_fetch(i, 0).xyz;
    vec3 high = ball_path_fetch(i + 1, 0).xyz;
    vec3 low_step = ball_path_fetch(i, 1).xyz;
    vec3 high_step = ball_path_fetch(i + 1, 1).xyz;
    vec3 middle = low + f * f * (3.0 - 2.0 * f) * (high - low) + f * (1.0 - f) * (1.0 - f) * low_step + f * f * (f - 1.0) * high_step;
    return x >= 0.0 && x <= last ? middle : vec3(1.0e9);
}
#else
vec3 ball_middle(RayPlace place) { return vec3(frame.ball_form.x, frame.ball_form.y, frame.ball_form.z); }
#endif

vec3 ball_offset(RayPlace place) { return place.at - ball_middle(place); }

float ball_value(RayPlace place) {
    vec3 offset = ball_offset(place);
    return sqrt(dot(offset, offset)) - frame.ball_form.w;
}

// It comes to meet the ray: both move.
#ifdef EFFECT_BALL_PATH
float ball_room(RayPlace place) { return ball_value(place) / (1.0 + frame.ball_path.w * place_slowness(place)); }
#else
float ball_room(RayPlace place) { return ball_value(place); }
#endif
