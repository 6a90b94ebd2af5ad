// Where a fragment's ray goes.
#include "shared/frame.glsl"

// px from the image centre, y up.
vec2 fragment_pixel() {
#ifdef EFFECT_SAMPLES
    return gl_FragCoord.xy * frame.sampling.z + frame.sampling.xy;
#else
    return gl_FragCoord.xy - 0.5 * frame.image.xy;
#endif
}
