// Bicubic Hermite patches: a cell of a table by its corners.

// Hermite across: value and slope along v at the lower and the upper edge, where the patch is entered and left. The corners: (value, d/dx,
// d/dv, d2/dxdv), per cell.
vec4 patch_edges(float f, vec4 t00, vec4 t10, vec4 t01, vec4 t11) {
    float h1 = f * f * (3.0 - 2.0 * f);
    float h2 = f * (1.0 - f) * (1.0 - f);
    float h3 = f * f * (f - 1.0);
    return vec4(t00.x + h1 * (t10.x - t00.x) + h2 * t00.y + h3 * t10.y, t00.z + h1 * (t10.z - t00.z) + h2 * t00.w + h3 * t10.w,
                t01.x + h1 * (t11.x - t01.x) + h2 * t01.y + h3 * t11.y, t01.z + h1 * (t11.z - t01.z) + h2 * t01.w + h3 * t11.w);
}

float patch_value(vec4 edges, float g) {
    return edges.x + g * g * (3.0 - 2.0 * g) * (edges.z - edges.x) + g * (1.0 - g) * (1.0 - g) * edges.y + g * g * (g - 1.0) * edges.w;
}
