// The light of bodies that have one kind and one texture: this text is written once for each such group, with BODY its name, KIND its kind's.
#include "object/material.glsl"
#include "object/solid.glsl"
#include "shared/objects.glsl"

vec3 BODY_light(int i, Trace trace, RayPlace place) {
    Material material = Material(objects[5 * i + 1], objects[5 * i + 2], objects[5 * i + 3], KIND_size(i));
    vec3 normal = KIND_normal(i, place);
    SolidSpot spot = solid_spot(trace, place, normal);
    return BODY_pattern(material, place.at - KIND_middle(i, place), spot.along, spot.across) * (solid_limb(material.colour.w, spot.cosine) * solid_day(objects[5 * i + 4], normal));
}
