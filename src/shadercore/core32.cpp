// The shader core in float. Compiled with -fsingle-precision-constant, so that literals are float as in GLSL.
#include "shadercore/core_includes.inl"

namespace nullscope {
namespace {
using Real = float;
#include "shadercore/core_precision.inl"
}  // namespace

RayPixel trace_core32(const CoreInput& input, double x, double y) { return dispatch(input).one(input, x, y); }

void list_core32(const CoreInput& input, const ListedCrossings& asked, std::span<const RayNumbers> rays,
                 ListedRay* found) {
    dispatch(input).list(input, asked, rays, found);
}

}  // namespace nullscope
