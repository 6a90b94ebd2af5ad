// How far along its way a ray that passes a ball by is clear of it. Not about a rotating hole, whose steps ask for what is near before and
// behind a place; not through a throat.
#include "path/place"

#define PASSING_LEFT 0.8     // of what is left beside the ball a ray may use up by bending
#define PASSING_PIXELS 6.0   // closer to its silhouette the way is stepped: its rim may cover a part of the pixel
#define PASSING_SLOWER 2.0   // of light's slowness: where r is half as much, r > PASSING_LEAST
#define PASSING_LEAST 3.0    // closer to the hole ways are not taken to be straight
#define PASSING_BEND 6.0     // 3/(2 r^2) a length, the most that light bends, where r is half as much: bodies are listed for no longer ways

// offset: from the ball's middle, r_s; course: by how much it changes a length of the way, bend: and that. room: the distance to the ball's
// surface, of use where nothing else is known. No ray that is `beside` it on a straight course is off that by more than bend length^2/2.
float passing_room(RayPlace place, vec3 offset, float radius, vec3 course, float bend, float room) {
    float course2 = max(dot(course, course), 1.0e-12);
    float ahead = min(dot(offset, course), 0.0);
    float beside = sqrt(max(dot(offset, offset) - ahead * ahead / course2, 0.0));
    float clear = beside - radius - PASSING_PIXELS * place.pixel;
    float way = max(room, sqrt(2.0 * PASSING_LEFT * max(clear, 0.0) / bend));
    float passing = clear > 0.0 ? way : room;
    return place.r > PASSING_LEAST ? passing : room;
}

vec3 passing_course(RayPlace place) { return place_velocity(place) / max(place_speed(place), 1.0e-20); }
float passing_bend(RayPlace place) { return PASSING_BEND / (place.r * place.r); }
