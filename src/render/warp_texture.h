// A camera's mesh as a texture (scene/warp_mesh.h, shaders/effect/warp.glsl).
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "base/result.h"
#include "gl/gl.h"
#include "scene/warp_mesh.h"

namespace nullscope {

// Rows of kWarpRow texels of four numbers, by number. First the bins by place on the screen and those by place in the picture, each: the
// lower left corner and how many there are in a length, right and up; numbers of bins, the first one's texel. Then `half`; and of each
// kind of bins: of each bin its first cell and how many it has; of each of these the first texels of its four nodes. At last the nodes:
// place and how far from there the place in the picture is; light. Lengths are half heights of the screen.
inline constexpr int kWarpRow = 1024;
// half: input_half().
std::vector<float> warp_texels(const WarpMesh& mesh, std::array<double, 2> half);

class WarpTexture {
public:
    // Empty where the camera has no mesh. Errors: load_warp_mesh()'s, and a mesh too large for the driver's textures of this side.
    Status update(const CameraSpec& camera, int largest);
    const gl::Texture& texture() const { return texture_; }
    int rows() const { return rows_; }

private:
    std::shared_ptr<const WarpMesh> mesh_;
    std::array<double, 2> half_{};
    gl::Texture texture_;
    int rows_ = 0;
};

}  // namespace nullscope
