// The picture: what each pixel's ray meets, front to back.
out vec4 colour;

void main() {
    Trace trace = trace_pixel(gl_FragCoord.xy - 0.5 * frame.image.xy);
    vec3 light = vec3(0.0);
    float through = 1.0;
#ifdef EFFECT_DISC
    PlaneMeeting meeting = disc_meeting(trace);
    for (int k = 0; k < DISC_MOST_CROSSINGS; ++k) {
        if (!disc_reachable(trace, meeting, k) || through < 0.002) break;
        if (!disc_close(trace, meeting, k)) continue;
        DiscCrossing crossing = disc_cross(trace, meeting, k, 0.5);
        if (crossing.hit) {
            vec4 over = disc_colour(crossing);
            light += through * over.rgb;
            through *= 1.0 - over.a;
        }
    }
#endif
#ifdef EFFECT_SKY
    if (trace.escapes && through > 0.002) light += through * celestial_sphere(trace);
#endif
#ifdef DISPLAY_ENCODE
    light = display_encode(light, frame.image.w);
#endif
    colour = vec4(light, 1.0);
}
