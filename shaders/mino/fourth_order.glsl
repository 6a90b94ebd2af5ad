// The fourth-order alternative to the step of mino/step.glsl, for skies alone: Nystroem's step (1925), the classic Runge-Kutta weights for y'' = f(y),
// three new forces. The dragging takes the weights and the places of the speed, and so the same order.
#include "mino/kerr.glsl"

SpinState spin_step(SpinRay ray, SpinState from, float h) {
    float hh = h * h;
    vec4 v = h * from.v;
    vec4 f0 = hh * from.f;
    float fine = spin_fine_of(from);
    vec4 y1 = from.y + 0.5 * v + 0.125 * f0;
    vec4 f1 = hh * spin_force(ray, y1, fine);
    vec4 y2 = from.y + v + 0.5 * f1;
    SpinState to;
    to.y = from.y + v + (f0 + 2.0 * f1) * (1.0 / 6.0);
    to.v = from.v + (f0 + 4.0 * f1 + hh * spin_force(ray, y2, fine)) * (1.0 / 6.0) / h;
#ifdef NEEDS_FINE_ZETA
    to.fine = fine;
#endif
    to.f = spin_force(ray, to.y, fine);
    to.drag = spin_drag(ray, to.y.w, fine);
    to.psi = from.psi + h * (from.drag + 4.0 * spin_drag(ray, y1.w, fine) + spin_drag(ray, y2.w, fine)) * (1.0 / 6.0);
    return to;
}
