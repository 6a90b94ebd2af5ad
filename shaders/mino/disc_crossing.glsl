// A meeting of the ray with the disc's plane, the equatorial one or mino/leaning.glsl's; whether it is on the disc (hit) and the footprint are
// mino/disc.glsl's and trace.glsl's, or mino/interpolated_disc.glsl's.
struct DiscCrossing {
    bool hit;
    float number;     // 1 for the ray's first
    float r;          // r_s
    vec2 place;       // x and y, azimuth of Boyer and Lindquist, r_s
    float phi;        // Mino's time
    vec2 along;       // footprint of one pixel on the disc in (x, y), r_s: image of its side to the right
    vec2 across;      // ... and upward
    float climb;      // d zeta / d tau there: p_r of the photon is climb / (zeta^2 Delta)
#ifdef NEEDS_RISE
    float rise;       // d n_z / d tau there: p_theta of the photon, the root of Carter's constant; of a plane that leans that of the height over it
#endif
#ifdef NEEDS_LIGHT_TIMES
    float delay;       // how long ago, by the camera's clock, the light left
#endif
#ifdef EFFECT_DISC_LEAN
    float momentum;   // of the photon about the disc's axis
    float north;      // cos(theta) there
#endif
};

DiscCrossing no_crossing() {
    DiscCrossing none;
    none.hit = false;
    none.number = 0.0;
    none.r = 0.0;
    none.place = vec2(0.0, 0.0);
    none.phi = 0.0;
    none.along = vec2(0.0, 0.0);
    none.across = vec2(0.0, 0.0);
    none.climb = 0.0;
#ifdef NEEDS_RISE
    none.rise = 0.0;
#endif
#ifdef NEEDS_LIGHT_TIMES
    none.delay = 0.0;
#endif
#ifdef EFFECT_DISC_LEAN
    none.momentum = 0.0;
    none.north = 0.0;
#endif
    return none;
}
