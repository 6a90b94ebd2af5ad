// Warp meshes that are made, not read: each pixel's ray is told by itself, to the rounding of the shader's floats, 1e-7 of the picture.
#pragma once
#include <filesystem>
#include <memory>

#include "scene/warp_mesh.h"

namespace nullscope {

// While it lives, a camera whose `warp` is its name has this mesh instead of a file's. Thread-safe.
class HeldMesh {
public:
    explicit HeldMesh(WarpMesh mesh);
    ~HeldMesh();
    HeldMesh(const HeldMesh&) = delete;
    HeldMesh& operator=(const HeldMesh&) = delete;
    const std::filesystem::path& name() const { return name_; }

private:
    std::filesystem::path name_;
};

std::shared_ptr<const WarpMesh> held_mesh(const std::filesystem::path& name);  // null: there is none of this name

}  // namespace nullscope
