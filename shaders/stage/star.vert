// One image of one star: where in the picture it is, and the light that its pixels share.
#include "path/stars"
#include "shared/frame.glsl"

layout(location = 0) in vec3 star_place;   // what star_point takes
layout(location = 1) in vec2 star_make;
flat out vec3 star_peak;
flat out vec2 star_middle;                 // px

void main() {
    StarPoint point = star_point(star_place, star_make);
    star_peak = point.peak;
    star_middle = point.pixel + 0.5 * frame.image.xy;
    float bright = max(max(star_peak.r, star_peak.g), star_peak.b) * frame.image.w;
    float reach2 = log2(bright * frame.point_stars.z) * frame.point_stars.y;
    bool seen_here = point.ahead > 0.0 && reach2 > 0.0;
    gl_PointSize = 2.0 * ceil(sqrt(max(reach2, 0.0))) + 1.0;
    gl_Position = seen_here ? vec4(point.pixel / (0.5 * frame.image.xy + frame.point_stars.w), 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
