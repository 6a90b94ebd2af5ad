// Which way on the camera's screen the electric vector of light points that matter emits across its field, anywhere about the hole: by the
// constant of observer/screen_form.h, kappa = (r - i a cos(theta)) (k^t f^r - k^r f^t + i (k^theta f^phi - k^phi f^theta)) in Carter's frame.
#include "core/polarisation.glsl"
#include "medium/matter.glsl"
#include "medium/motion.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

// Cosine and sine of twice its angle. seen: medium_seen(). phase: screen_phase() of the ray.
vec2 screen_direction(MediumPlace place, MediumMatter matter, vec3 seen, vec2 phase) {
    vec4 photon = medium_photon(place);
    vec3 u = matter.velocity;
    vec4 f = carried_by(vec4(u, sqrt(1.0 + dot(u, u))), cross(seen, matter.field_way));
    // Carter's frame moves along e_phi, with this speed for the observer of no angular momentum.
    float a = frame.medium_hole.x;
    float delta = max((place.r - frame.medium_hole.y) * (place.r - frame.medium_hole.z), 0.0);
    float sine = sqrt(max(1.0 - place.cosine * place.cosine, 0.0));
    float speed = a * sine * sqrt(delta) / (place.r * place.r + a * a);
    float k_t = 1.0 - speed * photon.z;
    float k_phi = photon.z - speed;
    float f_t = f.w - speed * f.z;
    float f_phi = f.z - speed * f.w;
    vec2 form = vec2(k_t * f.x - photon.x * f_t, photon.y * f_phi - k_phi * f.y);
    float turn = a * place.cosine;
    return stokes_direction(phase, vec2(place.r * form.x + turn * form.y, place.r * form.y - turn * form.x));
}
