#include "shared/frame.glsl"

// By no more is the disc widened for rims that cover a pixel in part, r_s.
float disc_rim() { return 0.125 * min(frame.disc_y.w - frame.disc_x.w, frame.disc_x.w); }
