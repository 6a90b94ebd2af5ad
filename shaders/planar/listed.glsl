// What a list of rays asks of one in a plane (stage/ray_list.glsl): its crossings of the disc's plane, and where it is after a swept angle.
#include "planar/disc.glsl"
#include "planar/trace.glsl"
#include "shared/frame.glsl"

struct ListedCrossing {
    bool there;
    vec2 place;     // disc (x, y), r_s
    float climb;    // d zeta/d phi
    float along;    // swept angle
};

// Crossing k from the first on that is asked for.
ListedCrossing listed_crossing(Trace trace, int k) {
    PlaneMeeting meeting = disc_meeting(trace);
    int number = int(frame.disc_surface.w) + k;
    DiscCrossing met = disc_cross(trace, meeting, number, 0.0);
    ListedCrossing crossing;
    crossing.there = disc_reachable(trace, meeting, number) && number < DISC_MOST_CROSSINGS;
    crossing.place = met.place;
    crossing.climb = met.zeta_slope;
    crossing.along = met.phi;
    return crossing;
}

// Behind those that are listed ray_data() looks for the disc by itself.
bool listed_more(Trace trace) { return false; }
float listed_passed() { return 0.0; }

// zeta after a swept angle; 0 beyond the end.
float listed_at(Trace trace, float angle) {
    PlaneMeeting meeting = disc_meeting(trace);
    meeting.phi = angle;
    DiscCrossing place = disc_cross(trace, meeting, 0, 0.0);
    return disc_reachable(trace, meeting, 0) ? 1.0 / place.r : 0.0;
}
