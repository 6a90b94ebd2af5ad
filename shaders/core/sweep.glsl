// What a method of tracing delivers for a ray that reaches the sky: the swept angle phi, as cos(phi) and sin(phi)/sin(alpha),
// both smooth through radial rays. The sky direction is (cos(phi) - cos(alpha) ratio) e + ratio n.
struct Sweep {
    float cos_phi;
    float ratio;      // sin(phi) / sin(alpha)
    float along;      // d phi / d alpha, the stretch in the ray's plane (of use for filtering only)
};
