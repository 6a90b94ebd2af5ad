// From linear light to the display: exposure, a shoulder that keeps hues of bright light, sRGB encoding.

// IEC 61966-2-1 without pow: three square roots a channel, error below 1/800.
vec3 srgb_encode(vec3 c) {
    vec3 s1 = sqrt(c);
    vec3 s2 = sqrt(s1);
    vec3 s3 = sqrt(s2);
    return max(0.662002687 * s1 + 0.684122060 * s2 - 0.323583601 * s3 - 0.0225411470 * c, vec3(0.0));
}

vec3 display_encode(vec3 linear, float exposure) {
    vec3 c = linear * exposure;
    return srgb_encode(clamp(vec3(1.0) - exp(-c), 0.0, 1.0));
}
