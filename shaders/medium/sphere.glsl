// Matter within a sphere and a slab, which may end sharply there.
#include "generated/medium_matter"
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

#define SAMPLE_LEAST 0.0625   // the shortest sample, of the longest

// The part of a sample that lies within the sphere and the slab where matter is; exact where the sample is straight.
float medium_inside(MediumPlace place) {
    float radius = SPHERE_RADIUS;
    float length2 = max(dot(place.way, place.way), 1.0e-20);
    float middle = -dot(place.begin, place.way) / length2;   // of the chord; the sample is from 0 to 1
    float r = sqrt(max(dot(place.begin, place.begin), 1.0e-12));
    float half2 = middle * middle - (r - radius) * (r + radius) / length2;
    float chord = sqrt(max(half2, 0.0));
    float up = abs(place.way.z) < 1.0e-10 ? 1.0e-10 : place.way.z;
    float top = (SPHERE_HEIGHT - place.begin.z) / up;
    float bottom = (-SPHERE_HEIGHT - place.begin.z) / up;
    float from = max(max(middle - chord, min(top, bottom)), 0.0);
    float to = min(min(middle + chord, max(top, bottom)), 1.0);
    return max(to - from, 0.0);
}

// A sample of what is there, of unit density.
MediumMatter medium_in_sphere(MediumPlace place) {
    float longest = SPHERE_STEP;
    longest = frame.medium_hole.y > 0.0 ? min(longest, medium_to_horizon(place)) : longest;
    MediumMatter matter = medium_nothing_there(longest);
    matter.shortest = SAMPLE_LEAST * longest;
    matter.inside = medium_inside(place);
    return matter;
}

float medium_free(float r, float cosine) { return max(r - SPHERE_RADIUS, abs(r * cosine) - SPHERE_HEIGHT); }
