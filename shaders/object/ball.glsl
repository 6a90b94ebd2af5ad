// A sphere anywhere.
vec3 ball_offset(vec3 at) { return at - vec3(frame.ball_form.x, frame.ball_form.y, frame.ball_form.z); }

float ball_value(vec3 at) {
    vec3 offset = ball_offset(at);
    return sqrt(dot(offset, offset)) - frame.ball_form.w;
}
