// What a FITS file of a picture says: its coordinates and how it was made.
#pragma once
#include <string>

#include "image/image_file.h"
#include "scene/scene.h"

namespace nullscope::cli {

// Where a place of the picture is, in degrees (docs/fits.md). Of a camera whose picture has a scale (observer/picture_scale.h), about an object
// of known mass and distance: on the sky of Earth, the picture's top north and its left east, by PictureScale::length_per_px(); else the
// camera's own directions, to the right and up; no coordinates where a picture is no pinhole's, is warped, or is two.
// scene: with the camera and the size that were drawn. several: two pictures are side by side.
void add_coordinates(const Scene& scene, bool several, FitsHeader& header);

// The object, spacetime and camera.
void add_scene(const Scene& scene, FitsHeader& header);

}  // namespace nullscope::cli
