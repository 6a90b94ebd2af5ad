// Chandrasekhar's law of limb darkening: light of a half-space of free electrons that scatter by Thomson's law, polarization included, and
// absorb nothing, summed over both polarizations, over the light of the same flux that is the same at all angles (Radiative Transfer,
// 1960, chapter X, table XXIV). Twice its mean times the cosine is 1: flux stays. Fit of the exact law with the terms that it begins with
// at 0; what it is off by is measured in docs/light.md.
float limb_darkening(float cosine) {
    float bent = cosine * log(max(cosine, 1.0e-12));
    return 0.4144341 + cosine * (0.5327763 + cosine * (0.2502492 + cosine * 0.0720002)) - bent * (0.2092401 + cosine * 0.2396106);
}
