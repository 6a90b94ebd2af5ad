// Where the middle of the pixel that is drawn lies in the framebuffer, px from the left and from below: of a fragment, or of a thread.
#ifdef BY_COMPUTE
#include "shared/thread.glsl"

vec2 fragment_at() { return vec2(thread_pixel()) + 0.5; }
#else
vec2 fragment_at() { return gl_FragCoord.xy; }
#endif
