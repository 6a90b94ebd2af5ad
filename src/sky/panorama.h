// Images of the whole sphere: where a direction lies in them, and their resampling into a cube map.
#pragma once
#include "base/image.h"
#include "base/result.h"
#include "sky/sky.h"

namespace nullscope {

// Position in pixels (corner of the image = 0, centre of the first pixel = 0.5) of a direction in an equirectangular
// image: azimuth 0 in the middle of the columns and growing to the left, row 0 at the north pole.
struct PanoramaPosition {
    double x, y;
};
PanoramaPosition equirectangular_position(int width, int height, Vec3 direction);

// Fills the faces from the image files of the spec: bilinear, averaged over as many samples a texel as an image finer
// than the face needs. Errors: an image that load_image refuses; a band latitude outside (0, pi/2).
// Cost: 0.7 s for 2048 and an image of up to 9600 columns on two cores, and the time to load it; in proportion to the
// pixels of finer images.
Status draw_image(SkyCube& sky, const SkySpec& spec, const Mat3& world_from_sky);

// Fills the faces with the Milky Way: the equirectangular map of surface brightness that ships (linear when loaded, its
// peak 1), times brightness. Smooth: a cubic B-spline on the map. Errors: a map that load_image refuses.
Status draw_milky_way(SkyCube& sky, const std::filesystem::path& map, const Mat3& world_from_sky, double brightness);

}  // namespace nullscope
