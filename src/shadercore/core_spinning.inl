// About a spinning hole: for cameras that fall or do not, with and without a boost.
namespace resting {
#include "shadercore/core_variant.inl"
}  // namespace resting
#define EFFECT_ABERRATION
namespace moving {
#include "shadercore/core_variant.inl"
}  // namespace moving
#define EFFECT_SPIN_FALL
namespace falling_moving {
#include "shadercore/core_variant.inl"
}  // namespace falling_moving
#undef EFFECT_ABERRATION
namespace falling {
#include "shadercore/core_variant.inl"
}  // namespace falling
#undef EFFECT_SPIN_FALL

RayPixel dispatch(const CoreInput& input, double x, double y) {
    if (input.spin_fall) return (input.aberration ? falling_moving::trace_one : falling::trace_one)(input, x, y);
    return (input.aberration ? moving::trace_one : resting::trace_one)(input, x, y);
}
