// dx/dt of a ball on its way, when the light left: the cubic through the derivatives at four nodes of its path, as differences of places have no
// digits left where nodes are close to each other.
#include "object/moving_ball.glsl"

vec3 moving_ball_step(int i, int node) { return ball_path_fetch(node, 2 * (i - BALL_PATH_FIRST) + 1).xyz; }

vec3 moving_ball_velocity(int i, RayPlace place) {
    vec4 form = body_form(i);
    float x = max((place.delay - form.x) * form.y, 0.0);
    int node = clamp(int(x), 1, textureSize(ball_path_texture, 0).x - 3);
    float f = x - float(node);
    float before = f + 1.0;
    float next = f - 1.0;
    float after = f - 2.0;
    vec3 step = before * after * (0.5 * next * moving_ball_step(i, node) - 0.5 * f * moving_ball_step(i, node + 1)) +
                f * next * (1.0 / 6.0) * (before * moving_ball_step(i, node + 2) - after * moving_ball_step(i, node - 1));
    return -form.y * step;
}
