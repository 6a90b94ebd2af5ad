// How matter sees the camera's light that moves in any direction, seen by the observer of no angular momentum. In metrics of Kerr's form and
// in those with A = Delta/r^2 (a = 0).
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

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

// gamma - u.n of a unit n, without a difference of nearly equal numbers where fast matter goes along with the light.
float medium_doppler(vec3 u, vec3 n) {
    float gamma = sqrt(1.0 + dot(u, u));
    float along = dot(u, n);
    vec3 beside = cross(u, n);
    float with_it = (1.0 + dot(beside, beside)) / (gamma + max(along, 0.0));
    return max(along > 0.0 ? with_it : gamma - along, 1.0e-6);
}

// Of matter of given four-velocity.
MediumMatter medium_moving(MediumPlace place, MediumMatter matter, vec3 velocity) {
    vec4 photon = medium_photon(place);
    float doppler = medium_doppler(velocity, vec3(photon.x, photon.y, photon.z));
    matter.velocity = velocity;
    matter.g = 1.0 / (photon.w * doppler);
    return matter;
}

// The light's direction for who goes with the matter.
vec3 medium_seen(MediumPlace place, MediumMatter matter) {
    vec4 photon = medium_photon(place);
    vec3 light_way = vec3(photon.x, photon.y, photon.z);
    vec3 u = matter.velocity;
    float gamma = sqrt(1.0 + dot(u, u));
    float doppler = medium_doppler(u, light_way);
    return (light_way + u * (dot(u, light_way) / (1.0 + gamma) - 1.0)) / doppler;
}
