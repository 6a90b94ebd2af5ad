// Where a ray's orbital plane meets a plane through the centre (the disc's): the swept angles phi_1, phi_1 + pi, ...
#include "core/trig.glsl"

struct PlaneMeeting {
    float phi;        // first crossing after leaving the camera, (0, pi]; pi for a camera in the plane
    vec3 direction;   // unit vector from the centre to it (crossing k: times (-1)^k)
};

// crossed = n x e of the unit view direction n and the outward radial e, s = |crossed|; normal of the plane, height = normal . e
// (exactly 0 in the plane). The meeting lies along normal x crossed: formed from crossed, not from n, it keeps its digits for a
// camera so far away that all rays of interest are nearly radial.
PlaneMeeting plane_meet(vec3 crossed, vec3 e, float s, vec3 normal, float height) {
    float side = height < 0.0 ? -1.0 : 1.0;
    vec3 at = side * cross(normal, crossed);
    // cos and sin of phi_1, both times |at|: the position cos(phi) e + sin(phi) t has no component along the normal.
    float phi = arc_tangent2(side * height * s, dot(at, e));
    if (height == 0.0) {                                // leaving the plane: the first meeting is half a turn away
        phi = 3.14159265358979323846;
        at = -e;
    }
    PlaneMeeting meeting;
    meeting.phi = phi;
    meeting.direction = at * inversesqrt(max(dot(at, at), 1.0e-30));
    return meeting;
}
