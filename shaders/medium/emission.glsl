// What matter emits and absorbs that is known by its density, temperature, magnetic field and motion: a power law, a black body, or thermal
// synchrotron radiation.
#ifdef EFFECT_MEDIUM_BLACK_BODY
#include "effect/black_body.glsl"
#endif
#ifdef EFFECT_MEDIUM_SYNCHROTRON
#include "medium/synchrotron.glsl"
#endif
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

#define EMISSION_DEEPEST 0.7    // optical depth of a sample ...
#define EMISSION_LEAST 0.0625   // ... that is not shorter than this part of the longest
#define EMISSION_MOST 1.0e30
#define EMISSION_MOST_LOG2 99.0

// The light's direction of travel and frequency (over the camera's) for the observer of no angular momentum.
vec4 medium_photon(MediumPlace place) {
    float a = frame.medium_hole.x;
    float r2 = place.r * place.r;
    float r2a2 = r2 + a * a;
    float cosine2 = place.cosine * place.cosine;
    float sine = sqrt(max(1.0 - cosine2, 1.0e-12));
    float delta = max((place.r - frame.medium_hole.y) * (place.r - frame.medium_hole.z), 1.0e-12);
    float sigma = r2 + a * a * cosine2;
    float area = r2a2 * r2a2 - a * a * delta * sine * sine;
    float drag = a * (r2a2 - delta);   // 2 m(r) r a
    float energy = max((place.energy * area - place.momentum * drag) * inversesqrt(sigma * delta * area), 1.0e-6);
    float east = clamp(place.momentum * sqrt(sigma / area) / (sine * energy), -1.0, 1.0);
    // The ray is followed backward.
    vec3 outward = place.at / place.r;
    float across = max(sqrt(outward.x * outward.x + outward.y * outward.y), 1.0e-6);
    vec3 south = vec3(outward.z * outward.x / across, outward.z * outward.y / across, -across);
    vec2 meridian = vec2(-dot(place.way, outward) * sqrt(r2 / delta), -dot(place.way, south));   // over sqrt(sigma)/r
    meridian *= sqrt(max(1.0 - east * east, 0.0)) * inversesqrt(max(dot(meridian, meridian), 1.0e-24));
    return vec4(meridian.x, meridian.y, east, energy);
}

#ifdef EFFECT_MEDIUM_BLACK_BODY
vec3 medium_glow(float temperature, float g) { return seen_black_body(log2(clamp(temperature, 1.0, 1.0e12)), g, frame.medium_law.x); }
#endif

float emission_number(float logarithm) { return logarithm > -120.0 ? exp2(min(logarithm, EMISSION_MOST_LOG2)) : 0.0; }

MediumLight medium_emission(MediumPlace place, MediumMatter matter, float inside) {
    vec4 photon = medium_photon(place);
    vec3 light_way = vec3(photon.x, photon.y, photon.z);
    vec3 u = matter.velocity;
    float gamma = sqrt(1.0 + dot(u, u));
    float doppler = max(gamma - dot(u, light_way), 1.0e-6);
    float g = 1.0 / (photon.w * doppler);
    float log_g = log2(g);
    MediumLight light;
#ifdef EFFECT_MEDIUM_BLACK_BODY
    light.absorption = min(inside * matter.density * frame.medium_law.y / g, EMISSION_MOST);
    light.emission = min(light.absorption * frame.medium_colour.rgb * medium_glow(matter.temperature, g), vec3(EMISSION_MOST));
#else
    // As logarithms: what dense matter emits, and what each of its particles does, may both have no room in a float.
    float log_density = log2(max(matter.density, 1.0e-37));
#ifdef EFFECT_MEDIUM_SYNCHROTRON
    vec3 seen = (light_way + u * (dot(u, light_way) / (1.0 + gamma) - 1.0)) / doppler;   // by who goes with the matter
    float frequency = frame.medium_law.x * exp2(-frame.medium_seen.x * log_g);
    float log_emitted = log_density + frame.medium_law.y + log2_synchrotron(matter, seen, frequency) - log_g;
    float log_black = frame.medium_law.z - 2.0 * frame.medium_seen.x * log_g + log2_planck_temperature(matter.temperature, frequency);
    float log_emission = log_emitted + frame.medium_seen.y * log_g;
    float log_absorption = log_emitted - log_black;
    bool shines = matter.density > 0.0 && matter.temperature >= COLDEST_K && matter.field > 0.0;
#else
    float log_emission = log_density + frame.medium_law.w + frame.medium_law.x * log_g;
    float log_absorption = log_density + frame.medium_law.z + frame.medium_law.y * log_g;
    bool shines = matter.density > 0.0;
#endif
    float beyond = max(log_absorption - EMISSION_MOST_LOG2, 0.0);   // opaque, and as bright
    inside = shines ? inside : 0.0;
    light.absorption = inside * emission_number(log_absorption - beyond);
    light.emission = inside * emission_number(log_emission - beyond) * frame.medium_colour.rgb;
#endif
    float longest = frame.medium_extent.z;
    longest = frame.medium_hole.y > 0.0 ? min(longest, medium_to_horizon(place)) : longest;
    light.step = clamp(EMISSION_DEEPEST / max(light.absorption * g, 1.0e-6), EMISSION_LEAST * longest, longest);
    return light;
}

// The part of a sample that lies within the sphere and the slab where matter is; exact where the sample is straight.
float medium_inside(MediumPlace place) {
    float radius = frame.medium_extent.x;
    float length2 = max(dot(place.way, place.way), 1.0e-20);
    float middle = -dot(place.begin, place.way) / length2;   // of the chord; the sample is from 0 to 1
    float r = sqrt(max(dot(place.begin, place.begin), 1.0e-12));
    float half2 = middle * middle - (r - radius) * (r + radius) / length2;
    float chord = sqrt(max(half2, 0.0));
    float up = abs(place.way.z) < 1.0e-10 ? 1.0e-10 : place.way.z;
    float top = (frame.medium_extent.y - place.begin.z) / up;
    float bottom = (-frame.medium_extent.y - place.begin.z) / up;
    float from = max(max(middle - chord, min(top, bottom)), 0.0);
    float to = min(min(middle + chord, max(top, bottom)), 1.0);
    return max(to - from, 0.0);
}

float medium_free(float r, float cosine) { return max(r - frame.medium_extent.x, abs(r * cosine) - frame.medium_extent.y); }
