// Transfer of I, Q, U, V = (I, s) through matter that is even along a way:
//     dS/dl = j - K S,   K (I, s) = (alpha I + a.s, alpha s + a I + s x rho),
// a what is absorbed of polarised light, rho Faraday's conversion (Q, U) and rotation (V), rad; all three here times the way. It is solved in
// closed form, with K = depth + N, N a generator of Lorentz's group (Landi Degl'Innocenti and Landolfi, Polarization in Spectral Lines,
// 2004, section 8.3): exp(-K) and its mean along the way are cubic in N, whose eigenvalues are +-x and +-iy, (x + iy)^2 = (a + i rho)^2.
// Rays are followed from the camera: row.S of a row vector is what a detector there gets of the light S.
// Angles count from right to up; V > 0 turns with them, as the camera sees it (right-handed by IEEE and IAU).

#define STOKES_EVEN 0.02     // of x^2 + y^2 below which cubics are those of 0
#define STOKES_SMALL 0.01    // of x^2 and y^2, likewise for their own functions
#define STOKES_FIRST 10.0    // order of the moment from which lower ones are made
#define STOKES_DEEP 2.0      // optical depth up to which they are

// row.N
vec4 stokes_turned(vec4 row, vec3 a, vec3 rho) {
    vec3 s = vec3(row.y, row.z, row.w);
    vec3 turned = cross(rho, s);
    return vec4(dot(s, a), row.x * a.x + turned.x, row.x * a.y + turned.y, row.x * a.z + turned.z);
}

// Integrals of t^k exp(-depth t) over 0 ... 1, k = 0 ... 4.
struct StokesMoments {
    float m0;
    float m1;
    float m2;
    float m3;
    float m4;
};

StokesMoments stokes_moments(float depth) {
    float low = min(depth, STOKES_DEEP);
    float left = exp(-low);
    StokesMoments thin;
    thin.m4 = left * (1.0 + low / (STOKES_FIRST + 2.0)) / (STOKES_FIRST + 1.0);
    for (float k = STOKES_FIRST; k > 4.5; k -= 1.0) thin.m4 = (low * thin.m4 + left) / k;
    thin.m3 = 0.25 * (low * thin.m4 + left);
    thin.m2 = (low * thin.m3 + left) / 3.0;
    thin.m1 = 0.5 * (low * thin.m2 + left);
    thin.m0 = low * thin.m1 + left;
    float by = 1.0 / max(depth, STOKES_DEEP);
    left = exp(-depth);
    StokesMoments thick;
    thick.m0 = by - by * left;
    thick.m1 = by * (thick.m0 - left);
    thick.m2 = by * (2.0 * thick.m1 - left);
    thick.m3 = by * (3.0 * thick.m2 - left);
    thick.m4 = by * (4.0 * thick.m3 - left);
    if (depth < STOKES_DEEP) return thin;
    return thick;
}

// (1 - exp(-z))/z by z >= 0 and exp(-z).
float stokes_mean(float z, float left) {
    float small = 1.0 - z * (0.5 - z * (1.0 / 6.0 - z * (1.0 / 24.0)));
    return z < 0.05 ? small : (1.0 - left) / z;
}

// Factors of 1, N, N^2, N^3 in exp(-K), and in the mean of exp(-t K) over t = 0 ... 1.
struct StokesFactors {
    vec4 behind;
    vec4 mean;
};

// A cubic that takes even(z) + z odd(z) at z = +-x and +-iy. over: 1/(x^2 + y^2).
vec4 stokes_cubic(vec2 at_x, vec2 at_y, float x2, float y2, float over) {
    return over * vec4(y2 * at_x.x + x2 * at_y.x, y2 * at_x.y + x2 * at_y.y, at_x.x - at_y.x, at_x.y - at_y.y);
}

// apart: a^2 - rho^2; along: a.rho.
StokesFactors stokes_factors(float depth, float apart, float along) {
    float both = sqrt(apart * apart + 4.0 * along * along);   // x^2 + y^2
    float more = 0.5 * (both + abs(apart));
    float less = along * along / max(more, 1.0e-30);
    float x2 = min(apart > 0.0 ? more : less, depth * depth);   // matter does not shine by absorption
    float y2 = apart > 0.0 ? less : more;
    float left = exp(-depth);
    StokesMoments m = stokes_moments(depth);
    bool small = x2 < STOKES_SMALL;
    float x = sqrt(max(x2, STOKES_SMALL));
    float least = max(depth - x, 0.0);
    vec2 ends = vec2(exp(-least), exp(-depth - x));
    vec2 means = vec2(stokes_mean(least, ends.x), stokes_mean(depth + x, ends.y));
    vec2 behind_x = small ? left * vec2(1.0 + 0.5 * x2, -1.0 - x2 / 6.0) : 0.5 * vec2(ends.x + ends.y, (ends.y - ends.x) / x);
    vec2 mean_x = small ? vec2(m.m0 + 0.5 * x2 * m.m2, -m.m1 - x2 * m.m3 / 6.0) : 0.5 * vec2(means.x + means.y, (means.y - means.x) / x);
    small = y2 < STOKES_SMALL;
    float y = sqrt(max(y2, STOKES_SMALL));
    float half_sine = sin(0.5 * y);
    float turned = left * sin(y);
    float turned_out = 2.0 * left * half_sine * half_sine;
    float gone = depth * m.m0 + turned_out;   // 1 - exp(-depth) cos(y)
    float by = 1.0 / (depth * depth + y * y);
    vec2 behind_y = small ? left * vec2(1.0 - 0.5 * y2, -1.0 + y2 / 6.0) : vec2(left - turned_out, -turned / y);
    vec2 mean_y = small ? vec2(m.m0 - 0.5 * y2 * m.m2, -m.m1 + y2 * m.m3 / 6.0) : by * vec2(gone * depth + turned * y, turned * depth / y - gone);
    StokesFactors found;
    if (both < STOKES_EVEN) {
        found.behind = left * vec4(1.0, -1.0, 0.5 + apart / 24.0, -1.0 / 6.0);
        found.mean = vec4(m.m0, -m.m1, 0.5 * m.m2 + apart * m.m4 / 24.0, -m.m3 / 6.0);
    } else {
        float over = 1.0 / both;
        found.behind = stokes_cubic(behind_x, behind_y, x2, y2, over);
        found.mean = stokes_cubic(mean_x, mean_y, x2, y2, over);
    }
    return found;
}

// mean: times emission and way, what the row gets of this matter's light. behind: the row for light from behind it.
struct StokesRows {
    vec4 mean;
    vec4 behind;
};

StokesRows stokes_rows(vec4 row, StokesFactors factors, vec3 a, vec3 rho) {
    vec4 once = stokes_turned(row, a, rho);
    vec4 twice = stokes_turned(once, a, rho);
    vec4 thrice = stokes_turned(twice, a, rho);
    StokesRows rows;
    rows.mean = factors.mean.x * row + factors.mean.y * once + factors.mean.z * twice + factors.mean.w * thrice;
    rows.behind = factors.behind.x * row + factors.behind.y * once + factors.behind.z * twice + factors.behind.w * thrice;
    return rows;
}
