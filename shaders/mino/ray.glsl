// How a ray about a rotating hole starts at the camera (mino/kerr.glsl). View directions are along (e_r, e_theta, e_phi) of the observer's own
// frame (observer/spin_frame.h).
#ifdef EFFECT_ABERRATION
#include "core/aberration.glsl"
#endif
#include "core/view.glsl"
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

// Every constant is a product or a sum that keeps its digits.
SpinRay spin_ray(SpinView view) {
    vec3 n = view.direction;
    SpinRay ray;
    ray.a = frame.spin_hole.x;
    ray.outer = frame.spin_hole.z;
    ray.inner = frame.spin_hole.w;
    ray.energy = spin_form(frame.spin_energy, n);
    float w = frame.spin_across.w + frame.spin_climb.w * n.z;     // L/sin - a E sin
    float p_theta = frame.spin_energy.w * n.y;
    float across = spin_form(frame.spin_across, n);               // L/sin
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
    ray.barrier = ring_barrier(view.pixel, ray.energy, ray.j2 - ray.a2e2, ray.k, ray.cubic, ray.outer);
#endif
    return ray;
}

SpinState spin_start(SpinRay ray, vec3 n) {
    float sine = frame.spin_place.x;
    float cosine = frame.spin_place.y;
    float c = frame.spin_place.z;
    float s = frame.spin_place.w;
    float p_theta = frame.spin_energy.w * n.y;
    float across = spin_form(frame.spin_across, n);
    SpinState at;
    at.y = vec4(sine * c, sine * s, cosine, frame.shift.y);
    at.v = vec4(p_theta * cosine * c - across * s, p_theta * cosine * s + across * c, -p_theta * sine, spin_form(frame.spin_climb, n));
#ifdef EFFECT_SPIN_RING
    at.fine = 0.0;
#endif
    at.f = spin_force(ray, at.y, 0.0);
    at.psi = 0.0;
#ifdef NEEDS_LIGHT_TIMES
    at.travel_time = 0.0;
    at.afar = frame.delay.y > 0.0 && at.v.w > 0.0 ? AFAR_INWARD : AFAR_NOT;
#endif
#ifdef EFFECT_SPIN_FALL
    at.ingoing = ingoing_stays(ray, at.y.w, at.v.w);
    at.psi = at.ingoing ? 0.0 : -frame.spin_turn.x;
#endif
    at.drag = spin_turning_at(ray, at);
    return at;
}
