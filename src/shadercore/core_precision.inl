// The combinations of effects in one precision (Real) and their dispatch.
#include "shadercore/core_types.inl"

struct Texels {
    TexelView strip, ends, orbit, delay;
};
thread_local Texels texels;
thread_local int listed_first = 0, listed_most = 0;   // ListedCrossings

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

struct Variant {
    RayPixel (*one)(const CoreInput&, double, double);
    void (*list)(const CoreInput&, const ListedCrossings&, std::span<const RayNumbers>, ListedRay*);
};
#define VARIANT(name) Variant { name::trace_one, name::trace_list }   // NOLINT: of a namespace

// Delayed, moving.
#define VARIANTS(name)                                                                                                   \
    {{VARIANT(name), VARIANT(name##_moving)}, {VARIANT(name##_delayed), VARIANT(name##_delayed_moving)}}

const Variant& dispatch(const CoreInput& input) {
    static constexpr Variant kRotating[2][2][2][2] = {   // next to the ring, falling
        {VARIANTS(rotating), VARIANTS(rotating_falling)}, {VARIANTS(rotating_ring), VARIANTS(rotating_ring_falling)}};
    // Next to the horizon: delayed and moving; without either these add 0.
    static constexpr Variant kNear[2][2] = {{VARIANT(rotating_near), VARIANT(rotating_falling_near)},
                                            {VARIANT(rotating_ring_near), VARIANT(rotating_ring_falling_near)}};
    static constexpr Variant kPlane[3][2] = {{VARIANT(flat), VARIANT(flat_moving)},
                                             {VARIANT(lensed), VARIANT(lensed_moving)},
                                             {VARIANT(cubic), VARIANT(cubic_moving)}};
    static constexpr Variant kZoomed = VARIANT(zoomed_moving);
    if (input.spin && input.spin_near) return kNear[input.spin_ring][input.spin_fall];
    if (input.spin) return kRotating[input.spin_ring][input.spin_fall][input.spin_delay][input.aberration];
    if (input.zoom) return kZoomed;
    return kPlane[!input.lensing ? 0 : input.cubic ? 2 : 1][input.aberration];
}
#undef VARIANTS
#undef VARIANT
