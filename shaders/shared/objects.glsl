// The bodies and hot spots of a scene, as many as there are: a uniform block of their own. shaderlib/body_text.h has the order of bodies.
#include "generated/objects"   // OBJECT_VECTORS, BODIES_FROM; of scenes with spots SPOT_FROM, SPOT_COUNT; with balls that move BALL_PATH_FIRST

layout(std140) uniform ObjectBlock { vec4 objects[OBJECT_VECTORS]; };

vec4 body_form(int i) { return objects[5 * i]; }   // each kind has its own: shaders/object
