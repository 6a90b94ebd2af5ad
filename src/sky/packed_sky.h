// A sky as textures hold it: packed texels, all mip levels. Never as a whole on the host: rows are painted and packed while the rows
// before them are handed over.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "image/half_float.h"
#include "sky/sky_painter.h"

namespace nullscope {

// OpenGL's R11F_G11F_B10F, red in the lowest bits, for skies that are made: stars and clouds without an exact value. RGBA16F, alpha 1, for
// images: of them small floats would leave 1.6 % of a value, and blue not as red and green.
enum class SkyFormat { kSmallFloats, kHalfFloats };
inline constexpr std::size_t texel_bytes(SkyFormat format) { return format == SkyFormat::kHalfFloats ? 8 : 4; }

// Rounded to the nearest number of 6, 6 and 5 bits of mantissa; NaN and what is below 0 become 0, what is beyond the largest numbers, 65024
// and 64512, these.
std::uint32_t packed_light(float red, float green, float blue);

// The same of 10 bits each, at most 65504: red in the lowest 16 bits.
std::uint64_t half_light(float red, float green, float blue);

// What light is multiplied by before it is packed, so that the largest keeps below kMostHalf and the least its digits: a power of two. 1
// for small floats.
double packing_scale(SkyFormat format, double largest);

// Faces are layers of a texture (shaders/object/sky_face.glsl) and show beside them what lies there. Of kBorderOf texels of a face one on
// each side is border: half a texel of the level of 16 texels, the coarsest that is filtered without a seam. Below it are levels of 8 texels
// and fewer, border and all, for pictures of a few pixels.
inline constexpr int kBorderOf = 32;
constexpr int bordered_size(int face_size) { return face_size + 2 * (face_size / kBorderOf); }

// The largest face, a power of two, whose texture has at most so many px a side.
inline int largest_face(int texture_size) {
    return static_cast<int>(std::bit_floor(static_cast<unsigned>(texture_size / (kBorderOf + 2) * kBorderOf)));
}

// Down to one texel.
inline int sky_levels(int face_size) { return std::bit_width(static_cast<unsigned>(bordered_size(face_size))); }

// What is handed over: rows [first, first + count) of a level of a face, border included, packed.
struct PackedRows {
    int face, level, first, count, width;
    const void* texels;
};

// How a sky is packed: its light times scale.
struct SkyPacking {
    SkyFormat format = SkyFormat::kSmallFloats;
    double scale = 1.0;
};

// All of the sky once, each level in rows from the first: the mean of the level before it, in float, rounded once. `take` is called on this
// thread alone. The painter's border is bordered_size's. Parallel: 0.35 s of processor time for the stars at 2048. Memory at 2048: 7 MB for
// each thread, 13 MB of half floats.
using TakeRows = std::function<void(const PackedRows&)>;
void pack_sky(const SkyPainter& painter, const SkyPacking& packing, const TakeRows& take);

// The same in pieces, for who has other work between them: each is two rows of the level of 16 texels a thread, a fiftieth of the sky on one.
class SkyPacker {
public:
    SkyPacker(const SkyPainter& painter, const SkyPacking& packing);  // a view of the painter; paints the first piece
    ~SkyPacker();
    SkyPacker(const SkyPacker&) = delete;
    SkyPacker& operator=(const SkyPacker&) = delete;
    bool next(const TakeRows& take);  // hands over a piece while the next is painted; whether there is one

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

}  // namespace nullscope
