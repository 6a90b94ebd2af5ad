// The combinations of effects in one precision (Real) and their dispatch. The disc's code is always compiled, and that of rays that
// pass the critical direction: where they end in a horizon they fetch nothing (core_variant.inl).
#define EFFECT_INNER
#define EFFECT_BOUNCE
#define EFFECT_STAR
#define EFFECT_DELAY
#define EFFECT_INNER_HORIZON
#define NEEDS_ZETA_SLOPE
namespace lensed {
#define EFFECT_DISC
#define EFFECT_LENSING
#include "shadercore/core_variant.inl"
}  // namespace lensed
namespace lensed_moving {
#define EFFECT_ABERRATION
#include "shadercore/core_variant.inl"
}  // namespace lensed_moving
#define STRIP_CUBIC
namespace cubic_moving {
#include "shadercore/core_variant.inl"
}  // namespace cubic_moving
#undef EFFECT_ABERRATION
namespace cubic {
#include "shadercore/core_variant.inl"
}  // namespace cubic
#undef STRIP_CUBIC
#undef EFFECT_LENSING
#define EFFECT_ABERRATION
namespace flat_moving {
#include "shadercore/core_variant.inl"
}  // namespace flat_moving
#undef EFFECT_ABERRATION
namespace flat {
#include "shadercore/core_variant.inl"
}  // namespace flat
#undef EFFECT_INNER
#undef EFFECT_STAR
#undef NEEDS_ZETA_SLOPE
#define EFFECT_SPIN
namespace spinning_delayed {
#include "shadercore/core_spinning.inl"
}  // namespace spinning_delayed
#undef EFFECT_DELAY
namespace spinning {
#include "shadercore/core_spinning.inl"
}  // namespace spinning
#undef EFFECT_SPIN
#undef EFFECT_DISC

RayPixel dispatch(const CoreInput& input, double x, double y) {
    if (input.spin) return (input.spin_delay ? spinning_delayed::dispatch : spinning::dispatch)(input, x, y);
    if (input.lensing && input.cubic) return (input.aberration ? cubic_moving::trace_one : cubic::trace_one)(input, x, y);
    if (input.lensing) return (input.aberration ? lensed_moving::trace_one : lensed::trace_one)(input, x, y);
    return (input.aberration ? flat_moving::trace_one : flat::trace_one)(input, x, y);
}
