// Point stars on the GPU: the vertices of a sky, and their drawing, one pass an image (table/star_lens.h).
#pragma once
#include <optional>

#include "base/result.h"
#include "gl/gl.h"
#include "scene/scene.h"

namespace nullscope {

class StarField {
public:
    // Loads the stars of the scene's sky unless they are loaded; without `wanted` drops them. Errors: the catalogue cannot be read.
    // Some 30 ms for the catalogue, 100 ms for a million stars.
    Status update(const Scene& scene, bool wanted);
    // Adds the stars to a picture in linear light whose alpha says what shines through. images: how many of each star.
    void draw(const gl::Program& program, unsigned framebuffer, int width, int height, int images) const;
    int count() const { return stars_.count; }
    std::size_t bytes() const { return static_cast<std::size_t>(stars_.count) * 5 * sizeof(float); }

private:
    struct Key {
        SkySpec sky;
        bool bolometric = false;
        friend bool operator==(const Key&, const Key&) = default;
    };
    std::optional<Key> key_;
    gl::VertexList stars_;
};

}  // namespace nullscope
