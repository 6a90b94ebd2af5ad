// Images of the disc of high order: rings about the critical direction, each exp(pi) thinner than the one before, soon thinner
// than a pixel. Whether the pixel's middle meets one says nothing then; how much of the pixel a ring covers is known, because
// its rims lie at C exp(-phi_k / a) from the critical direction (table/critical_images.h): a thin ring is a line, not dashes.
//
//   signed angle from the critical direction:   ----|==|-----|=======|-------------->  to the sky
//                                          rings k+1 and k         [----pixel----]
#include "planar/disc_crossing.glsl"
#include "shared/frame.glsl"

#ifdef EFFECT_SPOT
#define DISC_THIN_PX 0.5      // what differs along a ring's width and in time is looked for as long as there are pixels to show it
#else
#define DISC_THIN_PX 6.0      // rays and rings whose outer rim is closer to the critical direction: further out one is 3 px wide and more
#endif
#define DISC_THIN_OFF 0.2     // px by which the limit may be off: rings further out than that are met by their rays. It is off by 2 (delta / critical angle)^2 delta
#define DISC_THIN_LEAST 0.002 // least covered part of a pixel that is drawn

// Covered part of the pixel if crossing `number` belongs to a thin ring; `thin` false if it does not. `more`: may this ring or a
// later one cover anything?
struct DiscThin {
    bool thin;
    bool more;
    float covered;
};

// The limit's next term, as far as it is small.
float critical_bent(float x, float constant, float logarithm) {
    float size = max(abs(x), 1.0e-30);
    return x * clamp(1.0 + size * (constant + logarithm * log2(size)), 0.8, 1.25);
}

DiscThin disc_thin(Trace trace, PlaneMeeting meeting, int number) {
    float phi = meeting.phi + 3.14159265358979323846 * float(number);
    float shrunk = exp2(-phi * frame.critical.z);
    float near = critical_bent(frame.critical.x * shrunk, frame.critical_bend.x, frame.critical_bend.y);
    float far = critical_bent(frame.critical.y * shrunk, frame.critical_bend.z, frame.critical_bend.w);
    float offset = (trace.ray.u - 1.0) / frame.strip.z;   // |delta|, the angle from the critical direction
    offset = trace.escapes ? offset : -offset;
    float low = offset - 0.5 * trace.pixel_angle;
    float high = offset + 0.5 * trace.pixel_angle;
    DiscThin ring;
    float reach = max(abs(near), abs(far));
    float part = reach / frame.strip.y;
    ring.thin = phi > frame.critical.w && max(far, abs(offset)) < DISC_THIN_PX * trace.pixel_angle &&
                2.0 * part * part * reach < DISC_THIN_OFF * trace.pixel_angle;
    ring.more = low < far && high > min(near, 0.0) && far - near > DISC_THIN_LEAST * trace.pixel_angle;
    ring.covered = max(min(high, far) - max(low, near), 0.0) / trace.pixel_angle;
    return ring;
}

// May the pixel be covered in part by the outermost of them?
bool disc_thin_near(Trace trace, PlaneMeeting meeting) {
    float number = ceil((frame.critical.w - meeting.phi) * (1.0 / 3.14159265358979323846));
    DiscThin ring = disc_thin(trace, meeting, int(max(number, 0.0)));
    DiscThin next = disc_thin(trace, meeting, int(max(number, 0.0)) + 1);
    return (ring.thin && ring.more) || (next.thin && next.more);
}

// What such a ring shows: the disc across half of its width, in the middle.
DiscCrossing disc_thin_crossing(PlaneMeeting meeting, int number) {
    float inner = frame.disc_x.w;
    float outer = frame.disc_y.w;
    vec2 outward = disc_outward(meeting, number);
    DiscCrossing crossing;
    crossing.hit = true;
    crossing.phi = meeting.phi + 3.14159265358979323846 * float(number);
    crossing.r = 2.0 * inner * outer / (inner + outer);   // rays are spread evenly in zeta, roughly
    crossing.r = clamp(crossing.r, inner + 0.25 * (outer - inner), outer - 0.25 * (outer - inner));
    crossing.place = crossing.r * outward;
    crossing.along = 0.5 * (outer - inner) * outward;
    crossing.across = vec2(0.0);
#ifdef NEEDS_ZETA_SLOPE
    crossing.zeta_slope = 0.0;
#endif
    return crossing;
}
