// A sphere about the centre that keeps its size; its form: radius, 1/radius, sine and cosine of the silhouette's angle from the outward radial
// (sine below 0: the critical ray). The first swept angle with zeta = 1/R.
//
// Seen from outside, zeta grows from zeta0 until the ray turns or ends. Which rays reach the sphere is a question of their
// direction alone: sine and cosine of the silhouette's, z and w of its form, are formed in double. Below the photon sphere's
// zeta the orbit is concave (zeta'' = -V'/2 < 0), so Newton's steps from the camera never overshoot; beyond it a bracket holds them.
#include "planar/place.glsl"
#include "object/solid_hit.glsl"
#include "object/round.glsl"
#include "object/sphere.glsl"
#include "shared/objects.glsl"

#define SPHERE_MOST_STEPS 16

// Half a pixel's share of rays on either side of the silhouette: 0 ... 1. blur: pixels, 0 for a sharp edge.
float sphere_cover(int i, Trace trace, float blur) {
    float sine = body_form(i).z;
    if (sine < 0.0) {   // the silhouette is the critical ray itself
        return trace.escapes ? 0.0 : 1.0;
    }
    if (blur > 0.0 && sine < trace.pixel_angle && body_form(i).w < 0.0)   // narrower than a pixel
        return trace.c < 0.0 ? round_cover(sine / trace.pixel_angle, trace.s / trace.pixel_angle) : 0.0;
    if (!trace.escapes) return 1.0;
    float inside = (trace.s * body_form(i).w - trace.c * sine) / trace.pixel_angle;   // sine of the angle beyond the silhouette's
    return blur > 0.0 ? clamp(0.5 + inside / blur, 0.0, 1.0) : (inside > 0.0 ? 1.0 : 0.0);
}

SolidHit sphere_hit(int i, Trace trace, vec3 tangent, float blur) {
    SolidHit hit;
    hit.object = 0;
    hit.phi = trace.phi_end;
    hit.covered = sphere_cover(i, trace, blur);
    if (hit.covered <= 0.0) return hit;
    float target = body_form(i).y;   // 1/R
    float low = 0.0;
    float high = max(trace.phi_end, 1.0e-9);
    float phi = 0.0;
    int left = SPHERE_MOST_STEPS;
    float before = -1.0;
    do {
        RayPlace place = place_of(trace, tangent, phi);
        float zeta = 1.0 / place.r;
        float slope = -place.r_along * zeta * zeta;
        float rest = target - zeta;
        bool turned = slope <= 0.0 && trace.escapes;
        if (rest > 0.0 && !turned) low = max(low, phi);
        else high = min(high, phi);
        before = phi;
        float next = phi + rest / max(slope, 1.0e-6 * target);
        phi = next > low && next < high ? next : 0.5 * (low + high);
        if (rest == 0.0) phi = before;
    } while (--left > 0 && abs(phi - before) > 1.0e-7 * phi);
    hit.object = BODIES_FROM + i;
    hit.phi = phi;
    return hit;
}
