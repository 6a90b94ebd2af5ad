// A star's surface: cells of equal area, 24 in longitude by 12 rings of equal height, filtered by the footprint. Two colours, so that
// the images of both poles tell themselves apart.

// 1 and -1 by turns from one whole number to the next; averaged over width.
float star_square(float place, float width) {
    float from_edge = abs(fract(0.5 * place + 0.25) - 0.5) - 0.25;
    return clamp(4.0 * from_edge / max(width, 1.0e-6), -1.0, 1.0) * clamp(2.0 / max(width, 1.0e-6), 0.0, 1.0);
}

vec3 star_surface(Trace trace) {
    vec3 place = trace.sky;   // unit to rounding
    float width = max(abs(trace.stretch_along), abs(trace.stretch_across)) * trace.pixel_angle;
    float around = arc_tangent2(abs(place.y), place.x);   // mirrored: the squares are even in it, but for their colour
    float inverse_axis = inversesqrt(max(place.x * place.x + place.y * place.y, 1.0e-6));
    float square = star_square(around * 3.81971863420548805845, width * 3.81971863420548805845 * inverse_axis) *
                   star_square(6.0 * place.z, 6.0 * width);
    square = place.y < 0.0 ? -square : square;
    vec3 colour = place.z > 0.0 ? vec3(0.20, 0.32, 0.62) : vec3(0.62, 0.36, 0.16);
    return colour + (0.6 * square) * colour;
}
