// The picture: the light of each pixel's rays.
#include "stage/traced_pixel.glsl"

out vec4 colour;

void main() { colour = traced_pixel(); }
