// The sky at the other end of a wormhole where the near one is dark or painted (both: object/celestial_sphere.glsl).
#include "object/sky_face.glsl"
#include "path/trace"
#include "shared/frame.glsl"

uniform highp sampler2DArray other_side_texture;

vec3 other_side(Trace trace, SkyFetches fetches) {
    SkyFace face = sky_face(trace.sky);
    vec3 light = vec3(0.0);
    float part = 0.5;
    do {
        vec3 at = trace.sky + fetches.longer * (part / fetches.count - 0.5);
        light += textureLod(other_side_texture, sky_face_place(face, at), fetches.level).rgb;
        part += 1.0;
    } while (part < fetches.count);
    return light * (frame.sky.z / fetches.count);
}
