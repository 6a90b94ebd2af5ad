// What the picture's tiles may show, as textures: the passes that draw it in tiles (shaderlib/passes.h) read them.
#pragma once
#include <functional>
#include <vector>

#include "gl/gl.h"
#include "shaderlib/passes.h"

namespace nullscope {

class PictureTiles {
public:
    // For a picture of this size by these passes; frees what they do not need. Binds textures of its own to unit 0.
    void resize(const std::vector<Pass>& passes, int width, int height, const EffectSet& effects);

    // Draws stage kRays, or one that finds_tiles(), after bind(): bodies in larger tiles first, then in tiles of these. draw: all of a target by the
    // program.
    void find(Stage stage, const gl::Program& program, const std::function<void(const gl::Target&)>& draw);

    // To units from first on, in the order of kSamplers.
    static constexpr const char* kSamplers[] = {"tile_texture", "ray_texture", "places_texture", "moves_texture"};
    void bind(int first);

private:
    int first_ = 0;     // unit
    gl::Target rays_;   // shaders/stage/tile_rays.glsl
    gl::Target tiles_;  // a texel each (shaders/stage/tile_kind.glsl)
    gl::Target large_;  // kFirstTiles a side: where bodies are looked for
    gl::Target none_;   // read while these are drawn
};

}  // namespace nullscope
