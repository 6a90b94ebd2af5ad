// Matter of a file as a texture (scene/medium_grid.h, shaders/medium/grid.glsl): a layer for each azimuth, a row for each polar angle, and
// in it two texels for each node.
#pragma once
#include <memory>
#include <optional>

#include "base/result.h"
#include "gl/gl.h"
#include "scene/medium_grid.h"
#include "scene/scene.h"

namespace nullscope {

class MediumTexture {
public:
    // Empty where the scene has no such medium. Errors: medium_grid_at()'s, and a grid too large for the driver's textures.
    Status update(const Scene& scene, const gl::Info& info);
    const gl::Texture& texture() const { return texture_; }
    const MediumGrid* grid() const { return form_ ? &*form_ : nullptr; }  // without its numbers; nullptr: empty

private:
    std::weak_ptr<const MediumGrid> of_;  // dumps are kept elsewhere, as long as they are needed
    std::optional<MediumGrid> form_;
    gl::Texture texture_;
};

}  // namespace nullscope
