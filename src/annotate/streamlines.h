// A texture of lines over a displayed picture, along the electric vector of its light, as published pictures of M87* have it.
#pragma once
#include <vector>

#include "annotate/marks.h"
#include "image/image.h"
#include "scene/scene.h"

namespace nullscope {

// The same view in a picture of at most 360 px along its smaller side, whose Stokes parameters the lines are made of.
Scene streamline_scene(Scene scene, int width, int height);

// stokes: I, Q, U, V of streamline_scene(). Noise of a 330th of the picture's smaller side, at least 2.2 px, averaged over a seventh of that side along
// each line, darkens the picture: by at most 70 %, in proportion to the polarised fraction, and less in proportion where light is below a twentieth of the
// brightest; not where I, Q or U is not finite. The same for the same light and size. Cost: 1.6 core-s at 1280x720 (m87-swirl); for larger pictures this texture
// is enlarged.
std::vector<Mark> streamline_marks(const Image<float>& stokes, int width, int height);

}  // namespace nullscope
