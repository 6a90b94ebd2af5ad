// How far along its way a ray that passes a ball by is clear of it. Not about a rotating hole, whose steps ask for what is near before and
// behind a place; not through a throat.
#include "object/room.glsl"
#include "path/place"

#define PASSING_LEFT 0.8     // of what is left beside the ball a ray may use up by bending
#define PASSING_PIXELS 4.0   // closer to its silhouette the way is stepped: its rim may cover a part of the pixel
#define PASSING_SLOWER 2.0   // of light's slowness: where r is half as much, r > PASSING_LEAST
#define PASSING_LEAST 3.0    // closer to the hole ways are not taken to be straight
#define PASSING_BEND 6.0     // 3/(2 r^2) a length, the most that light bends, where r is half as much: bodies are listed for no longer ways

// How far on nothing of the ball is met, and how far on the next sample may be: within the ball where the ray hits it.
struct Passing {
    float room;
    float stride;
};

// offset: from the ball's middle, r_s; course: by how much it changes a length of the way, bend: and that. room: the distance to the ball's
// surface, of use where nothing else is known. No ray that is `beside` it on a straight course is off that by more than bend length^2/2.
Passing passing_ball(RayPlace place, vec3 offset, float radius, vec3 course, float bend, float room) {
    float course2 = max(dot(course, course), 1.0e-12);
    float ahead = min(dot(offset, course), 0.0);
    float beside = sqrt(max(dot(offset, offset) - ahead * ahead / course2, 0.0));
    float rim = PASSING_PIXELS * place.pixel;
    float clear = beside - radius - rim;
    float depth = radius - rim - beside;
    float straight = sqrt(2.0 * PASSING_LEFT * max(max(clear, depth), 0.0) / bend);   // the way that bends by no more
    float middle = -ahead / course2;
    bool far = place.r > PASSING_LEAST;
    Passing passing;
    passing.room = far && clear > 0.0 ? max(room, straight) : room;
    passing.stride = far && depth > 0.0 && room > 0.0 && middle < straight ? middle / ROOM_PART : passing.room;
    return passing;
}

vec3 passing_course(RayPlace place) { return place_velocity(place) / max(place_speed(place), 1.0e-20); }
float passing_bend(RayPlace place) { return PASSING_BEND / (place.r * place.r); }
