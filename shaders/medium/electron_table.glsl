// Electrons of a power law or of a kappa distribution: their scale, and what a table of integrals over their energies says
// (src/table/electron_table.h has its rows). ELECTRON_FIRST, ELECTRON_RATE, ELECTRON_KAPPA: generated/medium_matter.
#include "generated/medium_matter"
#include "medium/electrons.glsl"
#include "medium/matter.glsl"
#include "shared/frame.glsl"

uniform highp sampler2D electron_texture;

#define ELECTRON_CELLS 1024
#define ELECTRON_COLDEST -4.0             // log2 of w
#define ELECTRON_PER_OCTAVE 53.8947368
#define ELECTRON_MOST 4000.0              // cells beyond the table, of lines that go on
#define ELECTRON_LOG2 -0.58540163   // log2 of sqrt(3)/2 e^2/c 1e9, in units of LAW_UNIT

// at: in cells from the first texel; beyond the row its last lines go on.
vec4 electron_row(float at, int row) {
    int i = int(clamp(floor(at), 0.0, float(ELECTRON_CELLS) - 1.0));
    vec4 low = texelFetch(electron_texture, ivec2(i, row), 0);
    vec4 high = texelFetch(electron_texture, ivec2(i + 1, row), 0);
    return low + clamp(at - float(i), -ELECTRON_MOST, ELECTRON_MOST) * (high - low);
}

struct ElectronScale {
    float at;       // cell of the frequency
    float gyro;     // GHz
    float number;   // log2 of how many there are, as the table counts them
    float wide;     // log2 of the scale of gamma
    float means;    // cell of w
};

// frequency in GHz. sine: of the angle between light and field; 1 of a field of every direction.
ElectronScale electron_scale(MediumMatter matter, float frequency, float sine) {
    ElectronScale scale;
    scale.gyro = GYRO_GHZ * clamp(matter.field, 1.0e-6, 1.0e9);
    scale.number = 0.0;
    scale.wide = 0.0;
    scale.means = 0.0;
#ifdef ELECTRONS_KAPPA
    float w = clamp(matter.temperature, COLDEST_K, 1.0e14) / ELECTRON_K;
    float width = ELECTRON_KAPPA * w;
    float wide = max(width - 1.0, 1.0);
    scale.wide = log2(wide);
    scale.means = (log2(w) - ELECTRON_COLDEST) * ELECTRON_PER_OCTAVE;
    scale.number = electron_row(scale.means, 2).y + 3.0 * log2(wide / w) + (ELECTRON_KAPPA + 1.0) * log2(width / wide);
#endif
    scale.at = (log2(frequency) - log2(1.5 * scale.gyro * sine) - 2.0 * scale.wide - ELECTRON_FIRST) * ELECTRON_RATE;
    return scale;
}
