#version 330 core
precision highp float;
precision highp int;
struct FrameData {
    vec4 image;
    vec4 sight;
    vec4 ray_0;
    vec4 ray_x;
    vec4 ray_y;
    vec4 polar_0;
    vec4 polar_x;
    vec4 polar_y;
    vec4 radial;
    vec4 meridian;
    vec4 transverse;
    vec4 shift;
    vec4 strip;
    vec4 orbit;
    vec4 series;
    vec4 sky;
};
layout(std140) uniform FrameBlock { FrameData frame; };
uniform highp sampler2D strip_texture;
vec4 strip_fetch(int x, int y) { return texelFetch(strip_texture, ivec2(x, y), 0); }
uniform highp sampler2DArray sky_texture;
float arc_tangent_unit(float t) {
    float z = t * t;
    float p = 0.0020492594004690575;
    p = p * z + -0.01265689523252287;
    p = p * z + 0.036702608213945609;
    p = p * z + -0.069461808065979916;
    p = p * z + 0.10344522437755749;
    p = p * z + -0.14114268577644762;
    p = p * z + 0.19978313127170089;
    p = p * z + -0.3333204390973229;
    p = p * z + 0.99999976853751105;
    return p * t;
}
float arc_tangent2(float y, float x) {
    float ax = abs(x);
    float high = max(max(ax, y), 1.0e-37);
    float a = arc_tangent_unit(min(ax, y) / high);
    a = y > ax ? 1.57079632679489661923 - a : a;
    return x < 0.0 ? 3.14159265358979323846 - a : a;
}
#define STRIP_CELLS_PER_OCTAVE 1024
#define ENDS_CELLS_PER_OCTAVE 16
#define ENDS_ROW_SKY 0
#define ENDS_ROW_CAPTURED 1
#define ENDS_ROW_COS 2
#define ENDS_ROW_RATIO 3
#define ENDS_ROW_INNER 2
struct Octave {
    int cell;
    float place;
    float start;
};
Octave octave_cell(float u, int cells_per_octave) {
    int bits = floatBitsToInt(u);
    float position = float(bits & 0x7FFFFF) * (float(cells_per_octave) * 1.1920928955078125e-7);
    int cell = int(position);
    Octave result;
    result.cell = ((bits >> 23) - 127) * cells_per_octave + cell;
    result.place = position - float(cell);
    result.start = intBitsToFloat(bits & 0x7F800000);
    return result;
}
float cubic(vec4 c, float f) { return c.x + f * (c.y + f * (c.z + f * c.w)); }
float cubic_slope(vec4 c, float f) { return c.y + f * (2.0 * c.z + f * (3.0 * c.w)); }
struct StripRay {
    bool escapes;
    float sine;
    float u;
    float slope;
};
StripRay strip_locate(vec2 side, float s, float c, float tangent, vec4 strip) {
    StripRay ray;
    bool ahead = side.x > 0.0;
    float factor = ahead ? s + side.x : 1.0;
    float sine = tangent * factor - strip.x * (ahead ? side.y * side.y : s - side.x);
    float cosine = strip.x * c + strip.y * s;
    ray.escapes = sine > 0.0;
    ray.sine = sine / factor;
    float a = abs(sine);
    float b = (1.0 + abs(cosine)) * factor;
    float half_tan = cosine > 0.0 ? a / b : b / max(a, 1.0e-30);
    ray.u = 1.0 + half_tan * (2.0 * strip.z);
    ray.slope = (1.0 + half_tan * half_tan) * strip.z;
    return ray;
}
float strip_s_slope(StripRay ray, float c) { return ray.escapes ? -c : c; }
struct Sweep {
    float cos_phi;
    float ratio;
    float along;
};
Sweep sweep_to_sky(StripRay ray, float s, float c) {
    Octave octave = octave_cell(ray.u, STRIP_CELLS_PER_OCTAVE);
    int row = octave.cell / STRIP_CELLS_PER_OCTAVE;
    vec4 line = strip_fetch(octave.cell & (STRIP_CELLS_PER_OCTAVE - 1), row);
    float f_slope = float(STRIP_CELLS_PER_OCTAVE) / octave.start * ray.slope;
    Sweep sweep;
    sweep.cos_phi = line.x + octave.place * line.y;
    sweep.ratio = line.z + octave.place * line.w;
    sweep.along = sweep.cos_phi * (line.w * f_slope * s - sweep.ratio * c) - sweep.ratio * s * line.y * f_slope;
    return sweep;
}
struct Trace {
    float doppler;
    float pixel_angle;
    vec2 side;
    float s;
    float c;
    bool escapes;
    vec3 sky;
    float stretch_along;
    float stretch_across;
};
vec3 radial_direction() { return vec3(frame.radial.x, frame.radial.y, frame.radial.z); }
vec3 sideways(vec2 side) {
    return side.x * vec3(frame.meridian.x, frame.meridian.y, frame.meridian.z) +
           side.y * vec3(frame.transverse.x, frame.transverse.y, frame.transverse.z);
}
vec3 crossed_direction(Trace trace) { return sideways(vec2(trace.side.y, -trace.side.x)); }
vec3 look_direction(vec2 pixel, float inverse_length) {
    vec4 ray = (frame.ray_0 + pixel.x * frame.ray_x + pixel.y * frame.ray_y) * inverse_length;
    return vec3(ray.x, ray.y, ray.z);
}
Trace trace_pixel(vec2 pixel) {
    Trace trace;
    float inverse_length = inversesqrt(1.0 + dot(pixel, pixel) * (frame.image.z * frame.image.z));
    trace.doppler = 1.0;
    trace.pixel_angle = frame.image.z * inverse_length * sqrt(inverse_length);
    vec4 polar = (frame.polar_0 + pixel.x * frame.polar_x + pixel.y * frame.polar_y) * inverse_length;
    trace.side = vec2(polar.x, polar.y);
    trace.c = polar.z;
    float tangent = polar.w;
    trace.s = sqrt(dot(trace.side, trace.side));
    StripRay ray = strip_locate(trace.side, trace.s, trace.c, tangent, frame.strip);
    Sweep sweep = sweep_to_sky(ray, trace.s, trace.c);
    trace.escapes = ray.escapes;
    trace.sky = sweep.cos_phi * radial_direction() + sideways(sweep.ratio * trace.side);
    trace.stretch_along = sweep.along;
    trace.stretch_across = sweep.ratio;
    return trace;
}
float footprint_detail(float area) { return float(floatBitsToInt(area)) * (0.5 / 8388608.0) - 63.4785; }
float footprint_level(float detail, float highest) {
    float level = clamp(detail, 0.0, highest);
    float whole = floor(level);
    return whole + clamp(2.5 * (level - whole) - 0.75, 0.0, 1.0);
}
float sky_level(Trace trace) {
    vec3 size = abs(trace.sky);
    float scale = trace.pixel_angle * (frame.sky.x / max(max(size.x, size.y), size.z));
    float along = abs(trace.stretch_along) * scale;
    float across = abs(trace.stretch_across) * scale;
    float wide = max(along, across);
    return footprint_level(footprint_detail(max(0.36 * wide * wide, along * across)), frame.sky.y);
}
vec3 celestial_sphere(Trace trace, float level) {
    vec3 d = trace.sky;
    vec3 size = abs(d);
    bool on_x = size.x >= max(size.y, size.z);
    bool on_y = !on_x && size.y >= size.z;
    float facing = (on_x ? d.x : on_y ? d.y : d.z) < 0.0 ? -1.0 : 1.0;
    float layer = (on_x ? 0.0 : on_y ? 2.0 : 4.0) + (0.5 - 0.5 * facing);
    float major = abs(on_x ? d.x : on_y ? d.y : d.z);
    vec2 place = on_x ? vec2(-facing * d.z, -d.y) : on_y ? vec2(d.x, facing * d.z) : vec2(facing * d.x, -d.y);
    vec3 light = textureLod(sky_texture, vec3(place * ((0.5 * 32.0 / 34.0) / major) + 0.5, layer), level).rgb * frame.sky.z;
    return light;
}
vec3 srgb_encode(vec3 c) {
    vec3 s1 = sqrt(c);
    vec3 s2 = sqrt(s1);
    vec3 s3 = sqrt(s2);
    vec3 curve = 0.642366773 * s1 + 0.712109149 * s2 - 0.336869386 * s3 - 0.0175634953 * c;
    return mix(curve, 12.92 * c, lessThan(c, vec3(0.0031308)));
}
vec3 display_encode(vec3 linear, float exposure) {
    vec3 c = min(linear * exposure, vec3(1.0e4));
    c = vec3(1.0) - exp(-c);
    c = srgb_encode(clamp(c, 0.0, 1.0));
    return c;
}
out vec4 colour;
void main() {
    Trace trace = trace_pixel(gl_FragCoord.xy - 0.5 * frame.image.xy);
    vec3 light = vec3(0.0);
    float through = 1.0;
    if (trace.escapes && through > 0.002) light += through * celestial_sphere(trace, sky_level(trace));
    light = display_encode(light, frame.image.w);
    colour = vec4(light, 1.0);
}
