// A hot flow about the hole that shines by a power law: density exp(-((r/radius)^2 + (h cos theta)^2)/2), u_mu = u_t (-1, 0, 0, l),
// l = l0 R^1.5/(1 + R) with R = r sin theta in M (Gold et al. 2020, ApJ 897, 148, section 3.2). Its light is that at one frequency.
#include "medium/place.glsl"
#include "shared/frame.glsl"

#define FLOW_FARTHEST 6.0   // scales of density: exp(-18)
#define FLOW_STEP 0.25      // of such a scale
#define FLOW_INWARD 0.1     // of r

MediumLight medium_light(MediumPlace place) {
    float flattening = frame.medium_flow.y;
    float around = 2.0 * place.r * sqrt(max(1.0 - place.cosine * place.cosine, 0.0));   // R, M = r_s/2
    float l = 0.5 * frame.medium_flow.z * around * sqrt(around) / (1.0 + around);
    float x = place.r * frame.medium_flow.x;
    float height = flattening * place.cosine;
    float density = exp(-0.5 * (x * x + height * height));
    float log_g = log2(medium_g(place, l));
    MediumLight light;
    light.emission = density * exp2(frame.medium_powers.x * log_g) * frame.medium_colour.rgb;
    light.absorption = density * exp2(frame.medium_powers.y * log_g) * frame.medium_flow.w;
    float thick = place.r / max(flattening, 1.0);
    float across = flattening > 0.0 ? FLOW_STEP * thick : 1.0e6;
    light.step = min(min(FLOW_STEP / frame.medium_flow.x, FLOW_INWARD * place.r), min(across, medium_to_horizon(place)));
    return light;
}

float medium_free(float r, float cosine) {
    float flattening = frame.medium_flow.y;
    float above = flattening > FLOW_FARTHEST ? r * (abs(cosine) - FLOW_FARTHEST / flattening) : 0.0;
    return max(r - frame.medium_bound.x, above);
}
