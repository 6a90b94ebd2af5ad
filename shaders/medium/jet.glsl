// A jet: matter that flows out in two cones about the spin axis. Density (r/inner)^-falloff, across a cone (1 - (sin theta/sin opening)^2)^2.
#include "generated/medium_matter"
#include "medium/matter.glsl"
#include "medium/motion.glsl"
#include "medium/place.glsl"
#include "medium/warmth.glsl"

MediumMatter medium_matter(MediumPlace place) {
    float sine2 = (place.at.x * place.at.x + place.at.y * place.at.y) / (place.r * place.r);
    float across = max(1.0 - sine2 / (JET_SINE * JET_SINE), 0.0);
    float x = log(place.r) - JET_BEGIN;
    float rim = clamp(min(x, JET_LENGTH - x) / JET_RIM, 0.0, 1.0);
    float step = place.r * min(JET_ACROSS, JET_ALONG);
    MediumMatter matter = medium_nothing_there(min(step, medium_to_horizon(place)));
    matter.density = JET_DENSITY * across * across * rim * rim * (3.0 - 2.0 * rim) * exp(clamp(-JET_FALLOFF * x, -80.0, 80.0));
    return medium_moving(place, medium_warm(place, matter), vec3(JET_SPEED, 0.0, 0.0));
}

float medium_free(float r, float cosine) {
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    float beside = r * (sine * JET_COSINE - abs(cosine) * JET_SINE);
    return max(max(JET_INNER - r, r - JET_OUTER), beside);
}
