// The shader core as C++: the same source text as the fragment shader, in double (core64) and in float (core32), with the real
// table. Three tracers tell where an error comes from: reference - core64 is table error, core64 - core32 float error,
// core32 - GL driver error.
#pragma once
#include <span>

#include "scene/ray.h"
#include "shadercore/frame_data.h"
#include "shadercore/listed_ray.h"

namespace nullscope {

// RGBA float texels, width * height * 4, row by row: what the GPU gets.
struct TexelView {
    const float* data = nullptr;
    int width = 0, height = 0;
};

struct CoreInput {
    FrameData frame;
    TexelView strip, ends, orbit, delay;  // delay: empty where nothing asks for light times
    bool cubic = false;                   // the strip's cubics instead of its lines (method strip:cubic)
    bool lensing = true, aberration = false, zoom = false, spin = false, spin_fall = false, spin_ring = false,
         spin_near = false,
         spin_delay = false;  // the effects compiled in (a scene without a disc has an empty range of radii)
};

// Ray data of the pixel at (x, y) px from the image centre, y up. Same result for the same input; thread-safe.
RayPixel trace_core64(const CoreInput& input, double x, double y);
RayPixel trace_core32(const CoreInput& input, double x, double y);

// Rays of a list that start as the input's camera, in one go on the calling thread; as many answers as rays. Thread-safe.
void list_core64(const CoreInput& input, const ListedCrossings& asked, std::span<const RayNumbers> rays,
                 ListedRay* found);
void list_core32(const CoreInput& input, const ListedCrossings& asked, std::span<const RayNumbers> rays,
                 ListedRay* found);

}  // namespace nullscope
