// A sky as textures hold it: texels of 32 bits, all mip levels. Never as a whole on the host: rows are painted and packed while the rows
// before them are handed over.
#pragma once
#include <bit>
#include <cstdint>
#include <functional>

#include "sky/sky_painter.h"

namespace nullscope {

// OpenGL's R11F_G11F_B10F: red in the lowest bits. Numbers are cut off after 6, 6 and 5 bits, as Mesa does with floats; NaN and what
// is below 0 become 0, what is beyond the largest numbers, 65024 and 64512, these.
std::uint32_t packed_light(float red, float green, float blue);

// The mean of every 2 x 2 texels of a picture: width/2 texels a row.
void halve_packed(const std::uint32_t* from, int width, int rows, std::uint32_t* to);

// Faces in textures that are no cube maps (shaders/object/celestial_sphere.glsl) show beside them what lies there. Of kBorderOf texels of
// a face one on each side is border: half a texel of the level of 16 texels, the coarsest that is filtered without a seam.
inline constexpr int kBorderOf = 32;
inline int bordered_size(int face_size) { return face_size + 2 * (face_size / kBorderOf); }

// Levels down to one texel; with a border down to a face of 16.
inline int sky_levels(int face_size, bool bordered) {
    return std::bit_width(static_cast<unsigned>(bordered ? face_size / 16 : face_size));
}

// What is handed over: rows [first, first + count) of a level of a face, border included, packed.
struct PackedRows {
    int face, level, first, count, width;
    const std::uint32_t* texels;
};

// All of the sky once, each level in rows from the first. `take` is called on this thread alone. Parallel: 0.35 s of processor time for
// the stars at 2048. Memory: 7 MB for each thread at 2048.
void pack_sky(const SkyPainter& painter, const std::function<void(const PackedRows&)>& take);

}  // namespace nullscope
