// Where a ray's orbital plane meets a plane through the centre (the disc's): the swept angles phi_1, phi_1 + pi, ...

struct PlaneMeeting {
    float phi;        // first crossing after leaving the camera, (0, pi]; pi for a camera in the plane
    vec3 direction;   // unit vector from the centre to it (crossing k: times (-1)^k)
};

// n: unit look direction; e: outward radial; s = |n x e|; normal of the plane, height = normal . e (exactly 0 in the plane).
PlaneMeeting plane_meet(vec3 n, vec3 e, float s, vec3 normal, float height) {
    float side = height < 0.0 ? -1.0 : 1.0;
    float slope = dot(normal, n);                       // ray's direction against the normal
    float c = dot(n, e);
    // cos and sin of phi_1, both times |N x (n x e)|: position cos(phi) e + sin(phi) t has normal component 0.
    float x = -side * (slope - c * height);
    float y = side * height * s;
    PlaneMeeting meeting;
    float phi = arc_tangent2(y, x);
    vec3 at = side * (height * n - slope * e);
    if (height == 0.0) {                                // leaving the plane: the first meeting is half a turn away
        phi = 3.14159265358979323846;
        at = -e;
    }
    meeting.phi = phi;
    meeting.direction = at * inversesqrt(max(dot(at, at), 1.0e-30));
    return meeting;
}
