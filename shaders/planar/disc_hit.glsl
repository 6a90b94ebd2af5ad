// Where a ray that stays in a plane crosses a disc.
struct DiscCrossing {
    bool hit;
    float r;          // r_s
    vec2 place;       // in the disc's plane (x, y), of a warped one its ring's, r_s
    float phi;        // swept angle
    vec2 along;       // footprint of one pixel on the disc in (x, y), r_s: image of its side along the ray's plane
    vec2 across;      // ... and of the side across it
#ifdef NEEDS_ZETA_SLOPE
    float zeta_slope; // d zeta / d phi along the ray
#endif
#ifdef EFFECT_DISC_WARP
    vec3 axis;        // of the ring, world axes
    vec3 outward;     // unit, world axes
#endif
};
