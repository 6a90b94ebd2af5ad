// Polarisation of the light of electrons that are not thermal, and Faraday's rotation and conversion by them, by the same table as their light
// (src/table/synchrotron_kernels.h has the sources). Signs as medium/synchrotron_stokes.glsl.
#include "generated/medium_matter"
#include "medium/electron_table.glsl"
#include "medium/light.glsl"
#include "medium/matter.glsl"
#include "medium/motion.glsl"
#include "medium/place.glsl"
#include "medium/screen.glsl"

#define ELECTRON_TURN_LOG2 -0.945904533   // log2 of 2 e^2/(m c) 1e-9, in units of LAW_UNIT and of its frequency squared

// Of the light that is polarised along `way` by `linear`, with V within what is left.
vec3 electron_stokes(vec2 way, float linear, float circular) {
    float share = clamp(linear, 0.0, 1.0);
    float most = sqrt(max(1.0 - share * share, 0.0));
    return vec3(share * way, clamp(circular, -most, most));
}

MediumStokes medium_stokes(MediumPlace place, MediumMatter matter, vec2 phase) {
    vec3 seen = medium_seen(place, matter);
    float log_g = log2(matter.g);
    float frequency = LAW_FREQUENCY * exp2(-LAW_SHIFT * log_g);
    float cosine = clamp(dot(seen, matter.field_way), -1.0, 1.0);
    float sine = electron_sine(seen, matter.field_way);
    ElectronScale scale = electron_scale(matter, frequency, sine);
    vec2 linear = electron_row(scale.at, 0).zw;
    vec4 row = electron_row(scale.at, 1);
    vec2 circular = exp2(clamp(row.xy - scale.wide, -90.0, 90.0)) * (4.0 * cosine / (3.0 * sine));
    vec2 way = screen_direction(place, matter, seen, phase);
    MediumStokes stokes;
    stokes.emitted = electron_stokes(way, linear.x, circular.x);
    stokes.absorbed = electron_stokes(way, linear.y, circular.y);
    stokes.turned = vec3(0.0);
#ifdef MEDIUM_FARADAY
    float log_turn = medium_log_density(matter) + LAW_UNIT + ELECTRON_TURN_LOG2 + log2(scale.gyro) + (2.0 * LAW_SHIFT - 1.0) * log_g;
    float turn = matter.density > 0.0 ? matter.inside * emission_number(log_turn) : 0.0;
    vec2 means = exp2(electron_row(scale.means, 2).zw);
    float rotation = means.x + exp2(clamp(scale.number - 2.0 * scale.wide, -90.0, 90.0)) * electron_row(scale.at, 2).x;
    float conversion = exp2(clamp(scale.number + scale.wide + row.z, -90.0, 90.0)) * clamp(row.w, -1.0, 1.5) - means.y;
    stokes.turned = turn * vec3(0.5 * sine * sine * (scale.gyro / frequency) * conversion * way, cosine * max(rotation, 0.0));
#endif
    return stokes;
}
