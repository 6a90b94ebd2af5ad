// What a picture asks of polarised light along a ray, as rows of core/stokes_transfer.glsl: its own row, which begins with what a polariser
// lets through, and for Stokes parameters those of Q, U and V.
#include "core/stokes_transfer.glsl"
#include "effect/luminance.glsl"
#include "shared/frame.glsl"

#define STOKES_MOST_TURN 1.0e4   // rad in a sample: more has no digits in a float

struct StokesSight {
    vec4 row;
    vec3 light;   // of the row
#ifdef NEEDS_STOKES
    vec4 row_q;
    vec4 row_u;
    vec4 row_v;
    vec3 stokes;  // Q, U and V, in units of the light's luminance
#endif
};

StokesSight stokes_nothing() {
    StokesSight sight;
#ifdef EFFECT_POLARISER
    sight.row = vec4(1.0, frame.polariser.x, frame.polariser.y, 0.0);
#else
    sight.row = vec4(1.0, 0.0, 0.0, 0.0);
#endif
    sight.light = vec3(0.0);
#ifdef NEEDS_STOKES
    sight.row_q = vec4(0.0, 1.0, 0.0, 0.0);
    sight.row_u = vec4(0.0, 0.0, 1.0, 0.0);
    sight.row_v = vec4(0.0, 0.0, 0.0, 1.0);
    sight.stokes = vec3(0.0);
#endif
    return sight;
}

// Through a sample: its light without absorption, optical depth, Q, U, V of that light over I, a and rho.
StokesSight stokes_through(StokesSight sight, vec3 light, float depth, vec3 emitted, vec3 a, vec3 rho) {
    StokesFactors factors = stokes_factors(depth, dot(a, a) - dot(rho, rho), dot(a, rho));
    vec4 source = vec4(1.0, emitted);
    StokesRows rows = stokes_rows(sight.row, factors, a, rho);
    sight.light += max(dot(rows.mean, source), 0.0) * light;
    sight.row = rows.behind;
#ifdef NEEDS_STOKES
    float luminance = luminance_of(light);
    StokesRows q = stokes_rows(sight.row_q, factors, a, rho);
    StokesRows u = stokes_rows(sight.row_u, factors, a, rho);
    StokesRows v = stokes_rows(sight.row_v, factors, a, rho);
    sight.stokes += luminance * vec3(dot(q.mean, source), dot(u.mean, source), dot(v.mean, source));
    sight.row_q = q.behind;
    sight.row_u = u.behind;
    sight.row_v = v.behind;
#endif
    return sight;
}

// With light from behind that is not polarised; the row's own is row.x times it.
StokesSight stokes_of_behind(StokesSight sight, vec3 light) {
#ifdef NEEDS_STOKES
    sight.stokes += luminance_of(light) * vec3(sight.row_q.x, sight.row_u.x, sight.row_v.x);
#endif
    return sight;
}

// Behind what hides `cover` of it.
StokesSight stokes_covered(StokesSight sight, float cover) {
    float left = max(1.0 - cover, 0.0);
    sight.row *= left;
#ifdef NEEDS_STOKES
    sight.row_q *= left;
    sight.row_u *= left;
    sight.row_v *= left;
#endif
    return sight;
}
