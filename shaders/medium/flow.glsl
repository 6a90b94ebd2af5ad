// A hot flow about the hole: density exp(-((r/radius)^2 + (h cos theta)^2)/2), u_mu = u_t (-1, 0, 0, l),
// l = l0 R^1.5/(1 + R) with R = r sin theta in M (Gold et al. 2020, ApJ 897, 148, section 3.2).
#include "generated/medium_matter"
#include "medium/circles.glsl"
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "medium/warmth.glsl"

#define FLOW_SCALES 6.0     // of density, above the plane: exp(-18)
#define FLOW_STEP 0.25      // of such a scale
#define FLOW_FLAT 0.25       // rays that change their polar angle less than this by r have longer samples across the plane
#define FLOW_FLATTEST 0.025  // and no longer ones below this
#define FLOW_INWARD 0.1     // of r

MediumMatter medium_matter(MediumPlace place) {
    float around = 2.0 * place.r * sqrt(max(1.0 - place.cosine * place.cosine, 0.0));   // R, M = r_s/2
    float l = 0.5 * FLOW_MOMENTUM * around * sqrt(around) / (1.0 + around);
    float x = place.r * FLOW_SCALE;
    float height = FLOW_FLATTENING * place.cosine;
    float thick = place.r / max(FLOW_FLATTENING, 1.0);
    vec3 way = place.way * inversesqrt(max(dot(place.way, place.way), 1.0e-24));
    float turning = abs(way.z - place.cosine * dot(way, place.at) / place.r);
    float across = FLOW_FLATTENING > 0.0 ? FLOW_STEP * thick * max(FLOW_FLAT / max(turning, FLOW_FLATTEST), 1.0) : 1.0e6;
    MediumMatter matter = medium_nothing_there(min(min(FLOW_STEP / FLOW_SCALE, FLOW_INWARD * place.r), min(across, medium_to_horizon(place))));
    matter.density = FLOW_DENSITY * exp(-0.5 * (x * x + height * height));
    return medium_with_momentum(place, medium_warm(place, matter), l);
}

float medium_free(float r, float cosine) {
    float above = FLOW_FLATTENING > FLOW_SCALES ? r * (abs(cosine) - FLOW_SCALES / FLOW_FLATTENING) : 0.0;
    return max(r - FLOW_FARTHEST, above);
}
