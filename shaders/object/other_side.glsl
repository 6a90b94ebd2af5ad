// The sky at the other end of a wormhole where the near one is dark or painted (both: object/celestial_sphere.glsl).
#include "path/trace"
#include "shared/frame.glsl"

uniform samplerCube other_side_texture;

vec3 other_side(Trace trace, SkyFetches fetches) {
    vec3 light = vec3(0.0);
    float part = 0.5;
    do {
        light += textureLod(other_side_texture, trace.sky + fetches.longer * (part / fetches.count - 0.5), fetches.level).rgb;
        part += 1.0;
    } while (part < fetches.count);
    return light * (frame.sky.z / fetches.count);
}
