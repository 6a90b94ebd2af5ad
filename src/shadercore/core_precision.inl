// The combinations of effects in one precision (Real) and their dispatch.
#include "shadercore/core_types.inl"

struct Texels {
    TexelView strip, ends, orbit, delay;
};
thread_local Texels texels;

// Nothing where there is no texel: a captured ray fetches from the strip of the sky too, which near the hole has fewer
// octaves than captured rays take, and does not use what it gets. (In GL such a fetch gives some value; 0 where access
// is robust.)
vec4 fetch(const TexelView& view, int x, int y) {
    if (x < 0 || x >= view.width || y < 0 || y >= view.height) return vec4(0);
    const auto* texel = view.data + 4 * (static_cast<std::size_t>(y) * view.width + x);
    return vec4(texel[0], texel[1], texel[2], texel[3]);
}
vec4 strip_fetch(int x, int y) { return fetch(texels.strip, x, y); }
vec4 ends_fetch(int x, int y) { return fetch(texels.ends, x, y); }
vec4 orbit_fetch(int x, int y) { return fetch(texels.orbit, x, y); }
vec4 delay_fetch(int x, int y) { return fetch(texels.delay, x, y); }

#define float Real  // NOLINT: GLSL's float is this precision
#include "shadercore/core_texts.inl"
#undef float

RayPixel dispatch(const CoreInput& input, double x, double y) {
    using TraceOne = RayPixel (*)(const CoreInput&, double, double);
    static constexpr TraceOne kRotating[2][2][2][2] = {   // next to the ring, falling, delayed, moving
        {{{rotating::trace_one, rotating_moving::trace_one},
          {rotating_delayed::trace_one, rotating_delayed_moving::trace_one}},
         {{rotating_falling::trace_one, rotating_falling_moving::trace_one},
          {rotating_falling_delayed::trace_one, rotating_falling_delayed_moving::trace_one}}},
        {{{rotating_ring::trace_one, rotating_ring_moving::trace_one},
          {rotating_ring_delayed::trace_one, rotating_ring_delayed_moving::trace_one}},
         {{rotating_ring_falling::trace_one, rotating_ring_falling_moving::trace_one},
          {rotating_ring_falling_delayed::trace_one, rotating_ring_falling_delayed_moving::trace_one}}}};
    static constexpr TraceOne kPlane[3][2] = {{flat::trace_one, flat_moving::trace_one},
                                              {lensed::trace_one, lensed_moving::trace_one},
                                              {cubic::trace_one, cubic_moving::trace_one}};
    if (input.spin)
        return kRotating[input.spin_ring][input.spin_fall][input.spin_delay][input.aberration](input, x, y);
    if (input.zoom) return zoomed_moving::trace_one(input, x, y);
    return kPlane[!input.lensing ? 0 : input.cubic ? 2 : 1][input.aberration](input, x, y);
}
