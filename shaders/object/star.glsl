// A star's surface: cells of equal area, 24 in longitude by 12 rings of equal height, filtered by the footprint. Two colours, so that
// the images of both poles tell themselves apart.
#include "path/trace"

// 1 and -1 by turns from one whole number to the next; averaged over a width, given as 1/width.
float star_square(float place, float per_width) {
    float from_edge = abs(fract(0.5 * place + 0.25) - 0.5) - 0.25;
    return clamp(4.0 * from_edge * per_width, -1.0, 1.0) * clamp(2.0 * per_width, 0.0, 1.0);
}

vec3 star_surface(Trace trace) {
    vec3 place = trace.sky;   // unit to rounding
    float width = max(abs(trace.stretch_along), abs(trace.stretch_across)) * trace.pixel_angle;
    float axis2 = max(place.x * place.x + place.y * place.y, 1.0e-20), inverse_axis = inversesqrt(axis2);
    // Rings of equal height, from the nearer pole: 1 - |z| keeps its digits there, and changes by sin(theta) for each radian.
    float rings = 6.0 * axis2 / (1.0 + abs(place.z));
    float per_ring = 1.0 / max(6.0 * width * (axis2 * inverse_axis + 0.5 * width), 1.0e-9);
    // sin(12 longitude), the twelfth power of a complex number, stands for the longitude's squares: it is 0 where they change.
    float x = place.x * inverse_axis, y = place.y * inverse_axis;
    float x2 = x * x - y * y, y2 = 2.0 * x * y;
    float x3 = x2 * x - y2 * y, y3 = x2 * y + y2 * x;
    float x6 = x3 * x3 - y3 * y3, y6 = 2.0 * x3 * y3;
    float per_column = 1.0 / max(width * 3.81971863420548805845 * inverse_axis, 1.0e-6);
    float square = clamp((-4.0 / 3.14159265358979323846) * x6 * y6 * per_column, -1.0, 1.0) * clamp(2.0 * per_column, 0.0, 1.0) *
                   (place.z > 0.0 ? -1.0 : 1.0) * star_square(rings, per_ring);
    vec3 colour = place.z > 0.0 ? vec3(0.20, 0.32, 0.62) : vec3(0.62, 0.36, 0.16);
    return colour + (0.6 * square) * colour;
}
