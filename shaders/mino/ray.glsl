// How a ray about a rotating hole starts at the camera (mino/kerr.glsl). View directions are along (e_r, e_theta, e_phi) of the observer's own
// frame (observer/spin_frame.h).
#ifdef EFFECT_ABERRATION
#include "core/aberration.glsl"
#endif
#include "core/view.glsl"
#ifdef EFFECT_DISC_LEAN
#include "mino/height.glsl"
#endif
#include "mino/kerr.glsl"
#include "shared/frame.glsl"

// Where a pixel looks.
struct SpinView {
    vec2 pixel;           // picture_place()
    vec3 direction;       // unit, along (e_r, e_theta, e_phi)
    float doppler;        // frequency in the camera over that in the observer's frame
    float pixel_angle;    // angle that one pixel spans there, rad, in the observer's frame
};

// pixel: picture_place().
SpinView spin_view(vec2 pixel) {
    SpinView view;
    view.pixel = pixel;
    PixelView seen = pixel_view(pixel);
    vec4 direction = view_form(frame.ray_0, frame.ray_x, frame.ray_y, seen);
    view.direction = vec3(direction.x, direction.y, direction.z);
    view.pixel_angle = seen.angle;
    view.doppler = 1.0;
#ifdef EFFECT_ABERRATION
    Aberration moved = aberrate(view.direction, vec3(frame.boost.x, frame.boost.y, frame.boost.z), frame.boost.w, frame.boost_colour.x);
    view.direction = moved.direction;
    view.doppler = moved.doppler;
    view.pixel_angle *= moved.squeeze;
#endif
    return view;
}

float spin_form(vec4 form, vec3 n) { return form.x + form.y * n.x + form.z * n.z; }

#ifdef EFFECT_SPIN_NEAR
// inward: the form at n_r = -1. What falls fast has large terms that all but cancel there: a form of 1 + n_r keeps its digits.
float spin_form(vec4 form, float inward, vec3 n) {
    float beside = (n.y * n.y + n.z * n.z) / max(1.0 - n.x, 1.0);
    float by_inward = inward + form.y * beside + form.z * n.z;
    float by_middle = spin_form(form, n);
    return n.x < 0.0 ? by_inward : by_middle;
}
float spin_energy(vec3 n) { return spin_form(frame.spin_energy, frame.spin_near_3.x, n); }
float spin_across(vec3 n) { return spin_form(frame.spin_across, frame.spin_near_3.y, n); }
float spin_climb(vec3 n) { return spin_form(frame.spin_climb, frame.spin_near_3.z, n); }
#else
float spin_energy(vec3 n) { return spin_form(frame.spin_energy, n); }
float spin_across(vec3 n) { return spin_form(frame.spin_across, n); }
float spin_climb(vec3 n) { return spin_form(frame.spin_climb, n); }
#endif

// Every constant is a product or a sum that keeps its digits.
SpinRay spin_ray(SpinView view) {
    vec3 n = view.direction;
    SpinRay ray;
    ray.a = frame.spin_hole.x;
    ray.outer = frame.spin_hole.z;
    ray.inner = frame.spin_hole.w;
    ray.energy = spin_energy(n);
    float w = frame.spin_across.w + frame.spin_climb.w * n.z;     // L/sin - a E sin
    float p_theta = frame.spin_energy.w * n.y;
    float across = spin_across(n);               // L/sin
    ray.momentum = across * frame.spin_place.x;
    ray.a2e2 = frame.spin_hole.y * ray.energy * ray.energy;
    ray.k = p_theta * p_theta + w * w;
    ray.j2 = p_theta * p_theta + across * across - ray.a2e2 * frame.spin_place.y * frame.spin_place.y;
    // Q = p_theta^2 + cos^2 (L^2/sin^2 - a^2 E^2), not J^2 - L^2.
    float a2q = frame.spin_hole.y * (p_theta * p_theta + frame.spin_place.y * frame.spin_place.y * (across * across - ray.a2e2));
    ray.cubic = a2q + frame.spin_turn.z * ray.k;
    ray.pull = ray.a * ray.momentum + frame.spin_turn.z * ray.energy;
    ray.a2c = ray.a * ray.a + frame.spin_turn.z;
#ifdef EFFECT_SPIN_RING
    ray.barrier = ring_barrier(view.pixel, ray.j2 - ray.a2e2, ray.k, ray.cubic, ray.outer);
#endif
#ifdef EFFECT_SPIN_NEAR
    ray.near.outer = ray.outer;
    ray.near.inner = ray.inner;
    ray.near.gap = frame.spin_near.w;
    ray.near.x = spin_form(frame.spin_near, frame.spin_near_3.w, n);
    ray.near.twist = ray.a * (w * frame.spin_place.x - ray.a * ray.energy * frame.spin_place.y * frame.spin_place.y);
#endif
    return ray;
}

SpinState spin_start(SpinRay ray, vec3 n) {
    float sine = frame.spin_place.x;
    float cosine = frame.spin_place.y;
    float c = frame.spin_place.z;
    float s = frame.spin_place.w;
    float p_theta = frame.spin_energy.w * n.y;
    float across = spin_across(n);
    SpinState at;
    at.y = vec4(sine * c, sine * s, cosine, frame.shift.y);
    at.v = vec4(p_theta * cosine * c - across * s, p_theta * cosine * s + across * c, -p_theta * sine, spin_climb(n));
#ifdef NEEDS_FINE_ZETA
    at.fine = 0.0;
#endif
#ifdef EFFECT_SPIN_NEAR
    at.fine = near_fine(ray.near, at.y.w);
#endif
    at.f = spin_force(ray, at.y, spin_fine_of(at));
    at.psi = 0.0;
#ifdef NEEDS_LIGHT_TIMES
    at.travel_time = 0.0;
    at.afar = frame.delay.y > 0.0 && at.v.w > 0.0 ? AFAR_INWARD : AFAR_NOT;
#endif
#ifdef EFFECT_SPIN_FALL
    at.ingoing = ingoing_stays(ray, at);
    at.psi = at.ingoing ? 0.0 : -frame.spin_turn.x;
#endif
    at.drag = spin_turning_at(ray, at);
#ifdef EFFECT_DISC_LEAN
    at.height = leaning_end(ray, at);
#endif
    return at;
}
