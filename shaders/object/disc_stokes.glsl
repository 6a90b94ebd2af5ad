// Q and U of the light of the disc and of its hot spots beside it, where something asks for them.
#ifdef NEEDS_POLARISATION
#include "effect/luminance.glsl"
#include "effect/polariser.glsl"
#include "object/disc_polarisation.glsl"
#ifdef EFFECT_THERMAL_DISC
#include "object/disc_matter.glsl"
#endif

// Of what disc_colour() gave last, in units of the light's luminance.
vec2 disc_stokes;
void disc_stokes_begin() { disc_stokes = vec2(0.0); }
void disc_stokes_times(float factor) { disc_stokes *= factor; }

// Light of this polarisation, as the polariser lets it through but for the half that it takes of all light.
vec3 polarised_light(vec3 light, vec2 polarised) {
    disc_stokes += luminance_of(light) * polarised;
    return light * polariser_share(polarised);
}

vec2 disc_matter_polarised(Trace trace, DiscCrossing crossing, DiscMatter matter) {
    return disc_polarised(trace, crossing, matter.u, vec2(matter.lapses.x, matter.lapses.y), matter.lapses.z);
}
#else
void disc_stokes_begin() {}
void disc_stokes_times(float factor) {}
#define polarised_light(light, polarised) (light)
#endif
