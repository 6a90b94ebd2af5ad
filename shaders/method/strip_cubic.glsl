// Method strip:cubic: the strip's cubics instead of its straight lines. Two fetches; for frames so deep that a line's error shows.
#include "core/ends.glsl"
#include "core/strip.glsl"
#include "core/sweep.glsl"

Sweep sweep_to_sky(StripRay ray, float s, float c) {
    Octave octave = octave_cell(ray.u, ENDS_CELLS_PER_OCTAVE);
    int row = 0;
    float f_slope = float(ENDS_CELLS_PER_OCTAVE) / octave.start * ray.slope;
#ifdef EFFECT_INNER
    row = ray.escapes ? 0 : ENDS_ROW_INNER;
#ifdef EFFECT_BOUNCE
    row = ray.by_centre ? ENDS_ROW_CENTRE + 1 - ENDS_ROW_COS : row;
#endif
    f_slope = ray.escapes ? f_slope : -f_slope;   // delta grows towards the other radial direction there
#endif
    vec4 cos_phi = ends_fetch(octave.cell, ENDS_ROW_COS + row);
    vec4 ratio = ends_fetch(octave.cell, ENDS_ROW_RATIO + row);
    Sweep sweep;
    sweep.cos_phi = cubic(cos_phi, octave.place);
    sweep.ratio = cubic(ratio, octave.place);
    sweep.along = sweep.cos_phi * (cubic_slope(ratio, octave.place) * f_slope * s - sweep.ratio * c) -
                  sweep.ratio * s * cubic_slope(cos_phi, octave.place) * f_slope;
    return sweep;
}
