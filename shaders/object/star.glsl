// A star's surface: squares of 15 degrees, filtered by the footprint. Two colours, so that turned and mirrored images tell themselves
// apart by the darker northern half.

float star_square(float angle, float width) {   // -1 and 1 by turns, every 15 degrees; averaged over width, rad
    float place = angle * 3.81971863420548805845;   // 12/pi
    float from_edge = abs(fract(0.5 * place + 0.25) - 0.5) - 0.25;   // a zero at every edge, a quarter between
    return clamp(from_edge / max(0.5 * 1.90985931710274402923 * width, 1.0e-6), -1.0, 1.0) * clamp(0.5 / max(width, 1.0e-6), 0.0, 1.0);
}

vec3 star_surface(Trace trace) {
    vec3 place = normalize(trace.sky);
    float axis = sqrt(place.x * place.x + place.y * place.y);
    float latitude = arc_tangent2(axis, place.z);
    float longitude = arc_tangent2(abs(place.y), place.x);
    longitude = place.y < 0.0 ? 6.28318530717958647693 - longitude : longitude;
    float width = max(abs(trace.stretch_along), abs(trace.stretch_across)) * trace.pixel_angle;
    float square = star_square(latitude, width) * star_square(longitude, width / max(axis, 1.0e-3));
    vec3 colour = place.z > 0.0 ? vec3(0.20, 0.32, 0.62) : vec3(0.62, 0.36, 0.16);
    return colour * (1.0 + 0.6 * square);
}
