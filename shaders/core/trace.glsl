// One pixel's ray from the camera to its end: set-up, aberration, lookup of the strip. Stage shaders and the C++ core share it.
// Reads the globals `frame` (FrameData) and strip_fetch / orbit_fetch.

struct Trace {
    vec3 n;               // unit look direction in the static frame, world axes
    float doppler;        // frequency in the camera over frequency in the static frame
    float pixel_angle;    // angle that one pixel spans here, rad, in the static frame
    vec3 crossed;         // n x e
    float s;              // |n x e|
    float c;              // n . e
    bool escapes;
    vec3 sky;             // direction on the celestial sphere, unit to rounding; of use if escapes
    float stretch_along;  // d phi / d alpha: how fast the sky direction moves in the ray's plane
    float stretch_across; // sin(phi) / sin(alpha): and across it
#ifdef NEEDS_PHI_END
    float phi_end;        // swept to the sky or to the horizon
    float phi_end_slope;  // d phi_end / d |delta|, core/strip.glsl
#ifdef EFFECT_LENSING
    StripRay ray;
#endif
#endif
};

vec3 radial_direction() { return vec3(frame.radial.x, frame.radial.y, frame.radial.z); }

// pixel: px from the image centre, x to the right, y up.
Trace trace_pixel(vec2 pixel) {
    Trace trace;
    vec4 ray4 = frame.ray_0 + pixel.x * frame.ray_x + pixel.y * frame.ray_y;
    vec3 long_n = vec3(ray4.x, ray4.y, ray4.z);
    float inverse_length = inversesqrt(dot(long_n, long_n));
    trace.n = long_n * inverse_length;
    trace.doppler = 1.0;
    trace.pixel_angle = frame.image.z * inverse_length * sqrt(inverse_length);
#ifdef EFFECT_ABERRATION
    Aberration seen = aberrate(trace.n, vec3(frame.boost.x, frame.boost.y, frame.boost.z), frame.boost.w);
    trace.n = seen.direction;
    trace.doppler = seen.doppler;
    trace.pixel_angle *= seen.doppler;
    trace.crossed = cross(trace.n, radial_direction());
    trace.c = dot(trace.n, radial_direction());
#else
    vec4 cross4 = frame.cross_0 + pixel.x * frame.cross_x + pixel.y * frame.cross_y;
    trace.crossed = vec3(cross4.x, cross4.y, cross4.z) * inverse_length;
    trace.c = ray4.w * inverse_length;
#endif
    trace.s = sqrt(dot(trace.crossed, trace.crossed));
#ifdef EFFECT_LENSING
    StripRay ray = strip_locate(trace.s, trace.c, frame.strip);
    Sweep sweep = sweep_to_sky(ray, trace.s, trace.c);
    trace.escapes = ray.escapes;
    trace.sky = (sweep.cos_phi - trace.c * sweep.ratio) * radial_direction() + sweep.ratio * trace.n;
    trace.stretch_along = sweep.along;
    trace.stretch_across = sweep.ratio;
#ifdef NEEDS_PHI_END
    Octave octave = octave_cell(ray.u, ENDS_CELLS_PER_OCTAVE);
    vec4 end_poly = ends_fetch(octave.cell, ray.escapes ? 0 : 1);
    float end_ratio = cubic(end_poly, octave.place);
    float end_slope = cubic_slope(end_poly, octave.place) * (float(ENDS_CELLS_PER_OCTAVE) / octave.start * ray.slope);
    trace.ray = ray;
    trace.phi_end = end_ratio * trace.s;
    trace.phi_end_slope = end_slope * trace.s + end_ratio * strip_s_slope(ray, trace.c);
#endif
#else
    trace.escapes = true;
    trace.sky = trace.n;
    trace.stretch_along = 1.0;
    trace.stretch_across = 1.0;
#ifdef NEEDS_PHI_END
    trace.phi_end = arc_tangent2(trace.s, trace.c);
    trace.phi_end_slope = 1.0;
#endif
#endif
    return trace;
}
