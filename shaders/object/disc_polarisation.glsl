// Linear polarisation of the disc's light and of its hot spots': Q and U over I on the camera's screen.
#include "core/polarisation.glsl"
#include "path/disc"
#include "path/trace"
#include "shared/frame.glsl"

// u: velocity of the matter (disc_g) over `scale`. lapses: of the matter, and of the light, which is 1 where it runs straight: u^phi is then over
// the matter's.
vec2 disc_polarised(Trace trace, DiscCrossing crossing, vec3 u, vec2 lapses, float scale) {
    float a = path_spin();
    float r = max(crossing.r, 1.0e-6);
    vec4 photon = disc_photon(trace, crossing);   // E, L_z, p_r lapse^2, p_theta
    vec4 k = local_photon(photon.x, photon.y, photon.z, photon.w, r, a, max(lapses.y, 1.0e-6));
    vec4 matter = scale * local_matter(vec3(u.x, u.y * lapses.x / max(lapses.y, 1.0e-6), u.z), r, a, lapses.x);
    vec3 field = vec3(frame.polarisation.x, frame.polarisation.y, frame.polarisation.z);
    float fraction = frame.polarisation.w;
    if (fraction < 0.0) {   // scattering
        vec3 way = seen_from(matter, k);
        fraction = scattering_fraction(min(abs(way.y) * inversesqrt(max(dot(way, way), 1.0e-30)), 1.0));
    }
    return fraction * stokes_direction(trace.screen_phase, emitted_kappa(k, matter, field));
}
