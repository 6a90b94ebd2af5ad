// The orbit table: where a ray is after a swept angle, for every ray of this frame's zeta0. Bicubic Hermite patches over
//   across: octave cells of u as in strip.glsl, 12 an octave (each octave has 13 columns, its own copy of both ends),
//   along:  v = swept angle / phi_end, ORBIT_ROWS cells.
// Texels: (Z, dZ/dx, dZ/dv, d2Z/dxdv), derivatives per cell. Z = zeta for captured rays, zeta/(1-v) for rays to the sky, so that
// a distant disc keeps its relative accuracy. Segments below each other: sky first. Through a wormhole Z is W/(1-v) of all rays
// (table/throat_orbit.h), and zeta is W.
#include "core/patch.glsl"
#include "core/strip.glsl"

#ifndef __cplusplus
// With delays the map's texels lie beside theirs (table/orbit_table.h).
uniform highp sampler2D orbit_texture;
#ifdef EFFECT_LIGHT_TIMES
vec4 orbit_fetch(int x, int y) { return texelFetch(orbit_texture, ivec2(2 * x, y), 0); }
vec4 delay_fetch(int x, int y) { return texelFetch(orbit_texture, ivec2(2 * x + 1, y), 0); }
#else
vec4 orbit_fetch(int x, int y) { return texelFetch(orbit_texture, ivec2(x, y), 0); }
#endif
#endif

// As RayFamily::orbit_cells and orbit_rows.
#ifdef EFFECT_ZOOM
#define ORBIT_CELLS_PER_OCTAVE 24
#define ORBIT_ROWS 256
#else
#define ORBIT_CELLS_PER_OCTAVE 12
#define ORBIT_ROWS 128
#endif

struct OrbitPoint {
    float zeta;         // r_s / r
    float along;        // d zeta / d phi at fixed view direction
    float across;       // d zeta / d |delta| at fixed phi
};

// The cell of the map, and the place in it, 0 ... 1.
struct OrbitCell {
    int column;
    int row;
    float across;
    float along;
    float start;        // of the octave: a power of two
};

OrbitCell orbit_cell(bool escapes, float u, float phi, float phi_end) {
    Octave octave = octave_cell(u, ORBIT_CELLS_PER_OCTAVE);
    float position = min(phi / phi_end, 1.0) * float(ORBIT_ROWS);
    int row = int(min(position, float(ORBIT_ROWS) - 0.5));
    OrbitCell cell;
    cell.column = octave.cell + octave.cell / ORBIT_CELLS_PER_OCTAVE;
    int row_inward = row + (ORBIT_ROWS + 1);
    cell.row = escapes ? row : row_inward;
    cell.across = octave.place;
    cell.along = position - float(row);
    cell.start = octave.start;
    return cell;
}

// u, u_slope: as in StripRay. phi: swept angle < phi_end; phi_end_slope: d phi_end / d |delta|.
OrbitPoint orbit_point(bool escapes, float u, float u_slope, float phi, float phi_end, float phi_end_slope) {
    phi_end = max(phi_end, 1.0e-9);   // a radial ray sweeps nothing
    OrbitCell cell = orbit_cell(escapes, u, phi, phi_end);
    float v = min(phi / phi_end, 1.0);
    float f = cell.across;
    float g = cell.along;
    vec4 t00 = orbit_fetch(cell.column, cell.row);
    vec4 t10 = orbit_fetch(cell.column + 1, cell.row);
    vec4 t01 = orbit_fetch(cell.column, cell.row + 1);
    vec4 t11 = orbit_fetch(cell.column + 1, cell.row + 1);

    vec4 edges = patch_edges(f, t00, t10, t01, t11);
    float d1 = 6.0 * f * (1.0 - f);
    float d2 = 1.0 + f * (3.0 * f - 4.0);
    float d3 = f * (3.0 * f - 2.0);
    float low_x = d1 * (t10.x - t00.x) + d2 * t00.y + d3 * t10.y;
    float high_x = d1 * (t11.x - t01.x) + d2 * t01.y + d3 * t11.y;
    float value = patch_value(edges, g);
    float slope_v = 6.0 * g * (1.0 - g) * (edges.z - edges.x) + (1.0 + g * (3.0 * g - 4.0)) * edges.y + g * (3.0 * g - 2.0) * edges.w;
    slope_v *= float(ORBIT_ROWS);
    float slope_x = low_x + g * g * (3.0 - 2.0 * g) * (high_x - low_x);   // slopes of slopes left out: for footprints only
    float slope_delta = slope_x * (float(ORBIT_CELLS_PER_OCTAVE) / cell.start) * u_slope;

#ifdef EFFECT_SIDES
    float rest = 1.0 - v;
#else
    float rest_to_sky = 1.0 - v;
    float rest = escapes ? rest_to_sky : 1.0;
#endif
    OrbitPoint point;
    point.zeta = value * rest;
#ifdef EFFECT_SIDES
    float zeta_v = slope_v * rest - value;
#else
    float less = escapes ? value : 0.0;
    float zeta_v = slope_v * rest - less;
#endif
    point.along = zeta_v / phi_end;
    point.across = slope_delta * rest - zeta_v * v * phi_end_slope / phi_end;
    return point;
}
