// One pixel's ray about a rotating hole, from the camera to its end (mino/kerr.glsl). In place of planar/trace.glsl, where rays stay in planes:
// the same Trace as far as a sky asks for it. Reads the global `frame` (FrameData).
#ifdef NEEDS_SCREEN
#include "core/screen.glsl"
#endif
#ifdef NEEDS_FOOTPRINT
#include "core/pixel_sides.glsl"
#include "effect/sampling.glsl"
#include "shared/quad_step.glsl"
#endif
#include "core/trig.glsl"
#include "mino/kept_crossings.glsl"
#include "mino/ray.glsl"
#include "mino/step.glsl"
#ifdef METHOD_KERR_SCHILD
#include "generated/method"
#else
#include "mino/walk.glsl"
#endif
#include "shared/frame.glsl"

struct Trace {
    float doppler;        // frequency in the camera over that in the observer's frame
    float pixel_angle;    // angle that one pixel spans here, rad, in the observer's frame
    bool escapes;
    vec3 sky;             // direction on the celestial sphere, world axes, unit to rounding; of use if escapes
    float stretch_along;  // how fast the sky direction moves: of the footprint's sides the longer ...
    float stretch_across; // ... and the area over it
#ifdef NEEDS_FOOTPRINT
    PixelSides sky_sides; // and the same to the right and upward
#endif
    int steps;
    float travel_time;    // T, of a ray that escapes; 0 where light times are not asked for
    float momentum;       // of the photon over its frequency in the observer's frame
    float energy;
    KeptCrossings kept;   // of the disc
#ifdef NEEDS_SCREEN
    vec2 screen_phase;
#endif
#ifdef NEEDS_PLACE
    SolidHit solid;       // the first body
#ifdef NEEDS_FOOTPRINT
    PixelSides solid_sides;   // how it moves from pixel to pixel, to the right and upward
#endif
#endif
};

#ifdef NEEDS_PLACE
SolidHit solid_hit(Trace trace, float blur) { return trace.solid; }
#endif

// What every kind of path says of its rays (planar/trace.glsl).
float path_spin() { return frame.spin_hole.x; }
float path_steps(Trace trace) { return float(trace.steps); }
float swept_angle(float along) { return 0.0; }   // Mino's time is none
float path_angle(Trace trace) { return 0.0; }
#ifdef EFFECT_ZOOM
float ring_part(float phi, float all) { return 0.0; }   // the walk counts it
#endif
#ifdef EFFECT_REFINE
float path_way(Trace trace) { return kept_way(trace.kept, trace.escapes); }
#endif

// g: the camera's frequency over that at infinity.
float g_of(Trace trace) { return trace.doppler / max(trace.energy, 1.0e-6); }

Trace trace_start(SpinView view, SpinRay ray) {
    Trace trace;
    trace.doppler = view.doppler;
    trace.pixel_angle = view.pixel_angle;
    trace.escapes = false;
    trace.sky = -view.direction;
    trace.steps = 0;
    trace.travel_time = 0.0;
    trace.momentum = -ray.momentum;
    trace.energy = -ray.energy;
    trace.kept = kept_none();
#ifdef NEEDS_SCREEN
    trace.screen_phase = screen_phase(pixel_view(view.pixel));
#endif
    return trace;
}

#ifdef NEEDS_LIGHT_TIMES
float sky_travel_time(SpinState sky) { return sky.travel_time + (sky.afar == AFAR_NOT ? 0.0 : frame.delay.w); }
#else
float sky_travel_time(SpinState sky) { return 0.0; }
#endif

#ifdef NEEDS_FOOTPRINT
Trace trace_sides(Trace trace) {
    QuadStep sky = quad_step(vec4(trace.sky, 0.0));
    trace.sky_sides.along = sky.along.xyz * sampling_share();
    trace.sky_sides.across = sky.across.xyz * sampling_share();
    vec2 stretched = sides_stretch(trace.sky_sides, trace.pixel_angle);
    trace.stretch_along = stretched.x;
    trace.stretch_across = stretched.y;
    trace.kept = kept_footprints(trace.kept, trace.pixel_angle);
    return trace;
}
#else
Trace trace_sides(Trace trace) {
    trace.stretch_along = 1.0;
    trace.stretch_across = 1.0;
    return trace;
}
#endif

#ifdef METHOD_KERR_SCHILD
Trace trace_along(Trace trace, SpinRay ray, vec3 n) {
    vec4 marched = kerr_schild_march(ray, n);
    trace.steps = int(abs(marched.w));
    trace.escapes = marched.w > 0.0;
    trace.sky = trace.escapes ? vec3(marched.x, marched.y, marched.z) : -n;
    return trace_sides(trace);
}
#else
#ifdef NEEDS_PLACE
#ifdef NEEDS_FOOTPRINT
Trace trace_solid_sides(Trace trace, float way) {
    QuadStep solid = quad_step(vec4(trace.solid.place.at, float(trace.solid.object)));
    trace.solid_sides.along = solid.along.xyz * sampling_share();
    trace.solid_sides.across = solid.across.xyz * sampling_share();
    float side = trace.pixel_angle * way;
    if (abs(solid.along.w) + abs(solid.across.w) > 0.0) {   // straight light, across it
        vec3 ahead = normalize(trace.solid.place.velocity);
        trace.solid_sides.along = side * normalize(cross(ahead, abs(ahead.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
        trace.solid_sides.across = cross(trace.solid_sides.along, ahead);
    }
    return trace;
}
#else
Trace trace_solid_sides(Trace trace, float way) { return trace; }
#endif

Trace trace_solid(Trace trace, SolidSearch search) {
    trace.solid = solid_found(search);
    return trace_solid_sides(trace, search.length);
}
#else
Trace trace_solid(Trace trace, SolidSearch search) { return trace; }
#endif

Trace trace_along(Trace trace, SpinRay ray, vec3 n) {
    SpinWalk walk = walk_all(walk_start(ray, n, trace.pixel_angle), ray);
    SpinState sky = spin_to_sky(ray, walk.now);
    trace.steps = SPIN_MOST_STEPS - walk.left;
    trace.escapes = walk.now.y.w <= 0.0 && trace.energy > 0.0;
    trace.travel_time = sky_travel_time(sky);
    vec2 turn = sine_cosine(sky.psi);
    trace.sky =
        trace.escapes ? vec3(turn.y * sky.y.x - turn.x * sky.y.y, turn.x * sky.y.x + turn.y * sky.y.y, sky.y.z) : -n;
    trace.kept = walk.kept;
    return trace_solid(trace_sides(trace), walk.search);
}
#endif

Trace trace_pixel(vec2 pixel) {
    SpinView view = spin_view(pixel);
    SpinRay ray = spin_ray(view);
    return trace_along(trace_start(view, ray), ray, view.direction);
}

#ifdef NEEDS_FOOTPRINT
PixelSides sky_sides(Trace trace) { return trace.sky_sides; }
#ifdef NEEDS_PLACE
PixelSides solid_sides(Trace trace, RayPlace place) { return trace.solid_sides; }
#endif
#endif
