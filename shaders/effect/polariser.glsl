// A linear polariser before the camera.
#include "shared/frame.glsl"

// Of light with these Q and U over I, over the half that passes of unpolarised light.
#ifdef EFFECT_POLARISER
float polariser_share(vec2 polarised) { return 1.0 + dot(polarised, vec2(frame.polariser.x, frame.polariser.y)); }
#else
float polariser_share(vec2 polarised) { return 1.0; }
#endif
