// The light of one body: this text is written once for each of a scene's bodies, with BODY its name.
#include "object/solid.glsl"
#include "shared/frame.glsl"

// at: about the body's middle.
vec3 BODY_light(Trace trace, RayPlace place, vec3 at, vec3 normal) {
    SolidSpot spot = solid_spot(trace, place, normal);
    return BODY_paint(at, spot.along, spot.across) * solid_limb(frame.BODY_colour.w, spot.cosine);
}
