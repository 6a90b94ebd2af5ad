// The picture: what each pixel's ray meets, front to back.
out vec4 colour;

void main() {
    Trace trace = trace_pixel(gl_FragCoord.xy - 0.5 * frame.image.xy);
    vec3 light = vec3(0.0);
    float through = 1.0;
#ifdef EFFECT_DISC
    PlaneMeeting meeting = disc_meeting(trace);
    int k = disc_first(trace, meeting);
    bool more = disc_reachable(trace, meeting, k);
    do {   // tested at the end, see disc_colour
        DiscCrossing crossing = disc_cross(trace, meeting, k, 0.5);
        vec4 over = disc_colour(trace, crossing);
        over = more && crossing.hit ? over * through : vec4(0.0);
        light += over.rgb;
        through -= over.a;
        ++k;
        more = through > 0.002 && k < DISC_MOST_CROSSINGS && disc_reachable(trace, meeting, k);
    } while (more);
#endif
#ifdef EFFECT_SKY
    if (trace.escapes && through > 0.002) light += through * celestial_sphere(trace);
#endif
#ifdef DISPLAY_ENCODE
    light = display_encode(light, frame.image.w);
#endif
    colour = vec4(light, 1.0);
}
