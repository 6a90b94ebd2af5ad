// Method strip: one fetch and two straight lines, no trigonometry (core/strip.glsl).
Sweep sweep_to_sky(StripRay ray, float s, float c) {
    Octave octave = octave_cell(ray.u, STRIP_CELLS_PER_OCTAVE);
    vec4 line = strip_fetch(octave.cell & (STRIP_CELLS_PER_OCTAVE - 1), octave.cell / STRIP_CELLS_PER_OCTAVE);
    float f_per_w = float(STRIP_CELLS_PER_OCTAVE) / octave.start * frame.strip.y;
    Sweep sweep;
    sweep.cos_phi = line.x + octave.place * line.y;
    sweep.ratio = line.z + octave.place * line.w;
    float ratio_slope = line.w * f_per_w;
    sweep.along = sweep.cos_phi * (ratio_slope * s + sweep.ratio * strip_s_slope(c)) - sweep.ratio * s * line.y * f_per_w;
    return sweep;
}
