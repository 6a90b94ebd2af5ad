// What a draw of a list of rays reads and writes (shaders/stage/ray_list.frag): a fragment a ray, four texels of numbers each.
#pragma once
#include <span>
#include <vector>

#include "gl/gl.h"
#include "shadercore/listed_ray.h"

namespace nullscope {

inline constexpr std::size_t kRaysADraw = 65536;  // 4 MB of numbers, 6 MB of answers

class RayListTarget {
public:
    // crossings: whether the program tells of any (Effect::kDisc).
    RayListTarget(const ListedCrossings& asked, bool crossings) : asked_(asked), crossings_(crossings) {}
    // At most kRaysADraw rays; what the program reads.
    gl::Texture begin(std::span<const RayNumbers> rays);
    const gl::Target& target() const { return target_; }
    int rows() const;  // that hold a ray
    // bodies: their numbers (scene/ray.h), in the shader's order. found: as many as there were rays.
    void read(const std::vector<int>& bodies, ListedRay* found) const;

private:
    ListedCrossings asked_;
    bool crossings_;
    std::size_t count_ = 0;
    gl::Target target_;
};

}  // namespace nullscope
