// Next to a horizon nothing that moves is seen (plan/moving.h).
#include "shared/frame.glsl"

#define UNSEEN_STEEP 100.0   // a ball whose middle is there is unseen, by about the length in which g falls

// Below 0 outside of that.
float solid_unseen(float r) { return frame.march_shell.w - r; }
