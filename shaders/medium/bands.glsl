// Matter that is seen at two or three frequencies at once: the law is asked for each in turn, about the same matter, and light of the lowest is
// the picture's red, of the highest its blue (scene/medium_bands.h). law_band, MEDIUM_THREE_BANDS: generated/medium_matter.
#include "generated/medium_law"
#include "generated/medium_matter"
#include "medium/matter.glsl"
#include "medium/place.glsl"
#include "shared/frame.glsl"

struct MediumBands {
    vec3 absorption;   // as MediumLight's, of each: of two frequencies of the lower one twice
    float step;        // short enough for all
    vec3 low;          // emission
    vec3 middle;
    vec3 high;
};

MediumBands medium_bands(MediumPlace place, MediumMatter matter) {
    law_band = frame.medium_band_0;
    MediumLight low = medium_light(place, matter);
    law_band = frame.medium_band_1;
    MediumLight high = medium_light(place, matter);
    MediumLight middle = low;
#ifdef MEDIUM_THREE_BANDS
    middle = high;
    law_band = frame.medium_band_2;
    high = medium_light(place, matter);
#endif
    return MediumBands(vec3(low.absorption, middle.absorption, high.absorption), min(min(low.step, middle.step), high.step),
                       low.emission, middle.emission, high.emission);
}

// What the camera gets of it as red, green and blue. share: of each frequency's emission.
vec3 bands_colour(MediumBands bands, vec3 share) {
#ifdef MEDIUM_THREE_BANDS
    float green = share.g * bands.middle.g;
#else
    float green = 0.5 * (share.r * bands.low.g + share.b * bands.high.g);
#endif
    return vec3(share.r * bands.low.r, green, share.b * bands.high.b);
}
