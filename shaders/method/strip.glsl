// Method strip: one fetch and two straight lines, no trigonometry (core/strip.glsl).
#include "shared/frame.glsl"
#include "core/strip.glsl"
#include "core/sweep.glsl"

#ifndef __cplusplus
uniform highp sampler2D strip_texture;
vec4 strip_fetch(int x, int y) { return texelFetch(strip_texture, ivec2(x, y), 0); }
#endif

Sweep sweep_to_sky(StripRay ray, float s, float c) {
    Octave octave = octave_cell(ray.u, STRIP_CELLS_PER_OCTAVE);
    int row = octave.cell / STRIP_CELLS_PER_OCTAVE;
#ifdef EFFECT_INNER
    float first_row = frame.strip.w;
#ifdef EFFECT_BOUNCE
    first_row = ray.by_centre ? frame.series.z : first_row;
#endif
    row += ray.escapes ? 0 : int(first_row);
#endif
    vec4 line = strip_fetch(octave.cell & (STRIP_CELLS_PER_OCTAVE - 1), row);
    float f_slope = float(STRIP_CELLS_PER_OCTAVE) / octave.start * ray.slope;
    Sweep sweep;
    sweep.cos_phi = line.x + octave.place * line.y;
    sweep.ratio = line.z + octave.place * line.w;
#ifdef EFFECT_INNER
    f_slope = ray.escapes ? f_slope : -f_slope;   // delta grows towards the other radial direction there
#endif
    sweep.along = sweep.cos_phi * (line.w * f_slope * s - sweep.ratio * c) - sweep.ratio * s * line.y * f_slope;
    return sweep;
}
