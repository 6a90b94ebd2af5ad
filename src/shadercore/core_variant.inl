// One combination of effects of the shader core in one precision. Expects Real and the EFFECT_ macros.
#define NEEDS_PHI_END
#include "shadercore/core_types.inl"
#define float Real  // NOLINT: GLSL's float is this precision

struct Inputs {
    FrameBlock<vec4>::FrameData frame;
    TexelView strip, ends, orbit, delay;
};
thread_local Inputs inputs;
#define frame inputs.frame

// Nothing where there is no texel: a captured ray fetches from the strip of the sky too, which near the hole has fewer octaves
// than captured rays take, and does not use what it gets. (In GL such a fetch gives some value; 0 where access is robust.)
vec4 fetch(const TexelView& view, int x, int y) {
    if (x < 0 || x >= view.width || y < 0 || y >= view.height) return vec4(0);
    const auto* texel = view.data + 4 * (static_cast<std::size_t>(y) * view.width + x);
    return vec4(texel[0], texel[1], texel[2], texel[3]);
}
vec4 strip_fetch(int x, int y) { return fetch(inputs.strip, x, y); }
vec4 ends_fetch(int x, int y) { return fetch(inputs.ends, x, y); }
vec4 orbit_fetch(int x, int y) { return fetch(inputs.orbit, x, y); }
vec4 delay_fetch(int x, int y) { return fetch(inputs.delay, x, y); }

#include "core/trig.glsl"
#include "core/aberration.glsl"
#ifdef EFFECT_SPIN
#include "core/kerr.glsl"
#include "core/spin_leg.glsl"
#include "core/spin_ray.glsl"
#include "core/spin_trace.glsl"
#include "object/spin_disc.glsl"
#else
#include "core/strip.glsl"
#include "core/orbit.glsl"
#include "core/plane.glsl"
#include "core/sweep.glsl"
#ifdef STRIP_CUBIC
#include "method/strip_cubic.glsl"
#else
#include "method/strip.glsl"
#endif
#include "core/trace.glsl"
#include "core/delay.glsl"
#include "object/disc.glsl"
#endif
#include "core/raydata.glsl"

#undef frame
#undef float

RayPixel trace_one(const CoreInput& input, double x, double y) {
    std::array<vec4, kFrameVectors> members;
    std::ranges::transform(vectors_of(input.frame), members.begin(),
                           [](const FrameVector& v) { return vec4(v.x, v.y, v.z, v.w); });
    inputs.frame = std::bit_cast<FrameBlock<vec4>::FrameData>(members);
    inputs.strip = input.strip;
    inputs.ends = input.ends;
    inputs.orbit = input.orbit;
    inputs.delay = input.delay;
    const PixelData data = pixel_data(vec2(static_cast<Real>(x), static_cast<Real>(y)));
    RayPixel pixel;
    pixel.fate = static_cast<Fate>(static_cast<int>(data.fate));
    pixel.sky = {data.sky.x, data.sky.y, data.sky.z};
    pixel.g = data.g;
    pixel.delay = input.delay.data != nullptr || !input.lensing ? data.delay : 0.0;
    pixel.angle = data.angle;
    pixel.order = static_cast<int>(std::floor(pixel.angle / M_PI));
    pixel.hit = static_cast<int>(data.hit);
#ifdef EFFECT_SPIN
    pixel.steps = static_cast<int>(data.steps);
#endif
    pixel.u = data.place.x;
    pixel.v = data.place.y;
    pixel.w = data.place.z;
    return pixel;
}

#undef STRIP_CELLS_PER_OCTAVE
#undef ENDS_CELLS_PER_OCTAVE
#undef ENDS_ROW_SKY
#undef ENDS_ROW_CAPTURED
#undef ENDS_ROW_COS
#undef ENDS_ROW_RATIO
#undef ENDS_ROW_INNER
#undef ENDS_ROW_CENTRE
#undef ORBIT_CELLS_PER_OCTAVE
#undef ORBIT_ROWS
#undef DISC_MOST_CROSSINGS
#undef SPIN_STEP
#undef LOBATTO_POINT
#undef SPIN_MOST_STEPS
#undef SPIN_GROW_AFTER
#undef SPIN_GROWTH
#undef SPIN_CROSSINGS
#undef SPIN_RIM
#undef SPIN_FARTHEST
#undef INGOING_DELTA
#undef INGOING_SLOW
#undef INGOING_DEEP
#undef NEEDS_PHI_END
