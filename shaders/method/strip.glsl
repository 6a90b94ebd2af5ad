// Method strip: two fetches and two cubics, no trigonometry (core/strip.glsl).
Sweep sweep_to_sky(StripRay ray, float s, float c) {
    vec4 cos_poly = strip_coefficients(ray, 0);
    vec4 ratio_poly = strip_coefficients(ray, 1);
    float f = ray.octave.place;
    float f_per_w = strip_place_per_w(ray);
    Sweep sweep;
    sweep.cos_phi = cubic(cos_poly, f);
    sweep.ratio = cubic(ratio_poly, f);
    float cos_slope = cubic_slope(cos_poly, f) * f_per_w;
    float ratio_slope = cubic_slope(ratio_poly, f) * f_per_w;
    sweep.along = sweep.cos_phi * (ratio_slope * s + sweep.ratio * strip_s_slope(c)) - sweep.ratio * s * cos_slope;
    return sweep;
}
