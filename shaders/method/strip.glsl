// Method strip: one fetch and two straight lines, no trigonometry (core/strip.glsl).
Sweep sweep_to_sky(StripRay ray, float s, float c) {
    Octave octave = octave_cell(ray.u, STRIP_CELLS_PER_OCTAVE);
    vec4 line = strip_fetch(octave.cell & (STRIP_CELLS_PER_OCTAVE - 1), octave.cell / STRIP_CELLS_PER_OCTAVE);
    float f_slope = float(STRIP_CELLS_PER_OCTAVE) / octave.start * ray.slope;
    Sweep sweep;
    sweep.cos_phi = line.x + octave.place * line.y;
    sweep.ratio = line.z + octave.place * line.w;
    sweep.along = sweep.cos_phi * (line.w * f_slope * s - sweep.ratio * c) - sweep.ratio * s * line.y * f_slope;
    return sweep;
}
