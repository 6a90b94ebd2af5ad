// Matter of a file as a texture (scene/medium_grid.h, shaders/medium/grid.glsl): a layer for each azimuth, a row for each polar angle, and
// in it two texels for each node. Of slow light it has all dumps that a picture shows (plan/dump_window.h), one above another: a film reads and
// uploads each once.
#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "gl/gl.h"
#include "scene/medium_dumps.h"
#include "scene/medium_grid.h"
#include "scene/scene.h"

namespace nullscope {

class Spacetime;

class MediumTexture {
public:
    // Empty where the scene has no such medium. Errors: medium_grid_at()'s, and a grid too large for the driver's textures.
    Status update(const Scene& scene, const Spacetime& matter, const gl::Info& info);
    const gl::Texture& texture() const { return texture_; }
    const MediumGrid* grid() const { return form_ ? &*form_ : nullptr; }  // without its numbers; nullptr: empty
    std::size_t dumps() const { return std::max<std::size_t>(dumps_.size(), 1); }  // that it has room for

private:
    Status update_slow(const Scene& scene, const Spacetime& matter, const gl::Info& info);
    std::weak_ptr<const MediumGrid> of_;  // dumps are kept elsewhere, as long as they are needed
    std::optional<MediumGrid> form_;
    gl::Texture texture_;
    std::optional<GridMatter> series_;               // of slow light
    std::vector<std::optional<DumpStamp>> dumps_{};  // in its slots
};

}  // namespace nullscope
