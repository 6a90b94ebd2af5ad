// Linear polarisation of light, from the matter of a disc in the equatorial plane to the camera's screen (observer/screen_form.h has the
// theory). Vectors at a place: xyz along r, theta and phi, w along time, in the orthonormal frame that sees both families of principal light
// run radially: about a rotating hole Carter's, elsewhere that of an observer at rest. lapse: the root of Delta/r^2, of -g_tt where nothing
// rotates. Complex numbers are vec2.

// Of a photon with E, L_z, p_theta and p_r lapse^2 (as disc_g has it).
vec4 local_photon(float energy, float momentum, float climb, float p_theta, float r, float a, float lapse) {
    return vec4(climb / lapse, p_theta / r, (momentum - a * energy) / r, (energy + a * (a * energy - momentum) / (r * r)) / lapse);
}

// u: u^t, u^phi, g_rr u^r.
vec4 local_matter(vec3 u, float r, float a, float lapse) {
    return vec4(u.z * lapse, 0.0, r * u.y + a * (a * u.y - u.x) / r, lapse * (u.x - a * u.y));
}

// Spatial components of k in the rest frame of the four-velocity u, by the boost without rotation. carried_by: the inverse, of a vector without a
// component along time there.
vec3 seen_from(vec4 u, vec4 k) {
    vec3 v = vec3(u.x, u.y, u.z);
    vec3 way = vec3(k.x, k.y, k.z);
    return way + v * (dot(v, way) / (1.0 + u.w) - k.w);
}
vec4 carried_by(vec4 u, vec3 f) {
    vec3 v = vec3(u.x, u.y, u.z);
    float along = dot(v, f);
    return vec4(f + v * (along / (1.0 + u.w)), along);
}

// kappa/r of light whose electric vector in the matter's frame is across its direction and this field, in the equatorial plane. Its length
// counts for nothing.
vec2 emitted_kappa(vec4 k, vec4 u, vec3 field) {
    vec3 way = seen_from(u, k);
    vec4 f = carried_by(u, cross(way, field) * inversesqrt(max(dot(way, way), 1.0e-30)));
    return vec2(k.w * f.x - k.x * f.w, k.y * f.z - k.z * f.y);
}

// Q and U of light that is polarised all, by how the screen stands to kappa: (phase conj(kappa))^2 of unit length; 0 where there is no direction.
vec2 stokes_direction(vec2 phase, vec2 kappa) {
    vec2 turn = vec2(dot(phase, kappa), phase.y * kappa.x - phase.x * kappa.y);
    float square = dot(turn, turn);
    return vec2(turn.x * turn.x - turn.y * turn.y, 2.0 * turn.x * turn.y) / max(square, 1.0e-30);
}

// Polarised fraction of what leaves a half-space of electrons that scatter by Thomson's law and absorb nothing, across the normal, by the
// cosine of the angle to it (Chandrasekhar, Radiative Transfer, 1960, chapter X, table XXIV): a fit, off by 5e-6.
float scattering_fraction(float cosine) {
    float bent = cosine * log(max(cosine, 1.0e-12));
    return (1.0 - cosine) * (0.11712241 + cosine * (0.12242122 - cosine * (0.18440291 + cosine * 0.02588601)) + bent * (0.18226734 + cosine * 0.11998282));
}
