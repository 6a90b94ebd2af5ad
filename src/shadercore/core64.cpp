// The shader core in double.
#include "shadercore/core_includes.inl"

namespace nullscope {
namespace {
using Real = double;
#include "shadercore/core_precision.inl"
}  // namespace

RayPixel trace_core64(const CoreInput& input, double x, double y) { return dispatch(input).one(input, x, y); }

void list_core64(const CoreInput& input, const ListedCrossings& asked, std::span<const RayNumbers> rays,
                 ListedRay* found) {
    dispatch(input).list(input, asked, rays, found);
}

}  // namespace nullscope
