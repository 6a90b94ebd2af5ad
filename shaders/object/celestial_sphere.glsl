// The celestial sphere at infinity, a cube map in linear light.

vec3 celestial_sphere(Trace trace) {
    float along = abs(trace.stretch_along) * trace.pixel_angle;
    float across = abs(trace.stretch_across) * trace.pixel_angle;
    vec3 size = abs(trace.sky);
    float texels = frame.sky.x / max(max(size.x, size.y), size.z);   // a cube face is denser towards its corners
    bool radial = along > across;
    float wide = radial ? along : across;
    float narrow = radial ? across : along;
    Taps taps = footprint_taps(min(wide * texels, 1.0e6), narrow * texels, frame.sky.w, frame.sky.y);
    if (taps.count == 1) return textureLod(sky_texture, trace.sky, taps.level).rgb * frame.sky.z;
    vec3 orbital = normalize(cross(radial_direction(), trace.n) + vec3(0.0, 0.0, 1.0e-20));
    vec3 axis = (radial ? cross(orbital, trace.sky) : orbital) * min(wide, 1.0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < taps.count; ++i) {
        float offset = (float(i) + 0.5) / float(taps.count) - 0.5;
        sum += textureLod(sky_texture, trace.sky + offset * axis, taps.level).rgb;
    }
    return sum * (frame.sky.z / float(taps.count));
}
