// The strip: the deflection table's row for this frame's zeta0, in cells that halve their width octave by octave towards the
// critical ray, so that every winding is resolved with the same number of cells.
//
//   w = 2 tan(delta/2), delta = angle from the critical direction: next to it the angle in rad, and formed without any inverse
//   trigonometry;  u = 1 + w/w0;  octave = floor(log2 u), equal cells within an octave: cell number and place in the cell are
//   the bits of the float u, exact, without a logarithm.
//
//   w: |.........|....|..|.||:   <- cells crowd towards the critical ray on either side   :||.|..|....|.........|
//                        critical ray
//
// strip_fetch: rays that reach the sky, 1024 cells an octave, one octave a row; texel (c0, c1, r0, r1):
//   cos(phi) = c0 + c1 f, sin(phi)/sin(alpha) = r0 + r1 f, 0 <= f < 1 across the cell. One fetch a ray.
//   Where rays that pass the critical direction end somewhere to see (EFFECT_INNER: a wormhole's other sky, a star), theirs follow
//   from row strip.w on. Where those come back to the same sky (EFFECT_BOUNCE) they are singular at the centre too: rays nearer to it
//   than to the critical direction follow from row series.z on, with w = 2 tan(beta/2), beta the angle from the centre.
// ends_fetch: 16 cells an octave, coefficients of 1, f, f^2, f^3. Rows: phi_end/sin(alpha) of rays to the sky, the same of captured
//   ones (phi_end: angle swept to the sky or to the horizon), cos(phi) and sin(phi)/sin(alpha). Needed by objects and strip:cubic.

#define STRIP_CELLS_PER_OCTAVE 1024
#define ENDS_CELLS_PER_OCTAVE 16
#define ENDS_ROW_SKY 0
#define ENDS_ROW_CAPTURED 1
#define ENDS_ROW_COS 2
#define ENDS_ROW_RATIO 3
#define ENDS_ROW_CENTRE 6   // of rays by their angle from the centre: phi_end/sin(alpha), cos(phi), sin(phi)/sin(alpha)
#define ENDS_ROW_INNER 2   // from ENDS_ROW_COS and _RATIO to the same of rays that pass the critical direction

struct Octave {
    int cell;      // number of the cell
    float place;   // 0 ... 1 in it
    float start;   // u where the octave starts: a power of two
};

#ifdef __cplusplus
inline Octave octave_cell(float u, int cells_per_octave) {
    int exponent;
    float mantissa = std::frexp(u, &exponent) * float(2.0) - float(1.0);  // 0 ... 1
    float position = mantissa * float(cells_per_octave);
    Octave result;
    result.cell = (exponent - 1) * cells_per_octave + int(position);
    result.place = position - std::floor(position);
    result.start = std::ldexp(float(1.0), exponent - 1);
    return result;
}
#else
// u >= 1. Exact where cells_per_octave is a power of two; else place is rounded to 1e-6.
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
#endif

float cubic(vec4 c, float f) { return c.x + f * (c.y + f * (c.z + f * c.w)); }
float cubic_slope(vec4 c, float f) { return c.y + f * (2.0 * c.z + f * (3.0 * c.w)); }

// delta from -pi to pi, positive for rays that reach the sky.
struct StripRay {
    bool escapes;     // reaches the sky
    float sine;       // sin(delta)
    float u;          // 1 + |w|/w0
    float slope;      // d u / d |delta|, 1/rad
#ifdef EFFECT_BOUNCE
    bool by_centre;   // u counts from the centre
#endif
};

// side, s = |side|, c: as in Trace. tangent: n along the critical direction's tangent; strip as in FrameData.
// sin(delta) = tangent - cos(critical) (s - side.x), and s - side.x = side.y^2 / (s + side.x): next to the meridian, on which the
// image's centre lies, no digit is lost however deep the zoom.
// centre: tan(beta/2) below which u counts from the centre; used with EFFECT_BOUNCE alone.
StripRay strip_locate(vec2 side, float s, float c, float tangent, vec4 strip, float centre) {
    StripRay ray;
    bool ahead = side.x > 0.0;
    float factor = ahead ? s + side.x : 1.0;
    float sine = tangent * factor - strip.x * (ahead ? side.y * side.y : s - side.x);   // sin(delta) times factor
    float cosine = strip.x * c + strip.y * s;
    ray.escapes = sine > 0.0;
    ray.sine = sine / factor;
    float a = abs(sine);
    float b = (1.0 + abs(cosine)) * factor;
    // tan(delta/2) = sin/(1 + cos) = (1 - cos)/sin, whichever does not cancel.
    float over = cosine > 0.0 ? a : b;
    float under = cosine > 0.0 ? b : max(a, 1.0e-30);
#ifdef EFFECT_BOUNCE
    // c < 0 there: tan(beta/2) = s/(1 - c); centre is tan(theta_c/4), where both are alike.
    float from_c = 1.0 + abs(c);
    ray.by_centre = !ray.escapes && s < centre * from_c;
    over = ray.by_centre ? s : over;
    under = ray.by_centre ? from_c : under;
#endif
    float half_tan = over / under;
    ray.u = 1.0 + half_tan * (2.0 * strip.z);
    ray.slope = (1.0 + half_tan * half_tan) * strip.z;
#ifdef EFFECT_BOUNCE
    ray.slope = ray.by_centre ? -ray.slope : ray.slope;
#endif
    return ray;
}

// d s / d |delta|.
float strip_s_slope(StripRay ray, float c) { return ray.escapes ? -c : c; }
