// Streamlines of polarisation over a picture that is drawn (annotate/streamlines.h).
#pragma once
#include "gl/gl.h"
#include "render/renderer.h"

namespace nullscope::viewer {

bool shows_streamlines(const Scene& scene);  // not in split screens

// Over the scene's picture in a target of RGBA8, which is read back for it. The renderer, of this scene, is prepared for another size.
void lay_streamlines(Renderer& renderer, const Scene& scene, const gl::Target& picture);

}  // namespace nullscope::viewer
