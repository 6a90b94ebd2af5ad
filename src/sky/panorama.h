// Images of the whole sphere, resampled into a cube map.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "image/image.h"
#include "scene/scene.h"
#include "sky/sky_rows.h"

namespace nullscope {

// Pixels per radian of the images of a sky, along the finest of their axes. Errors: as Panorama::load.
Result<double> panorama_density(const SkySpec& spec);

// A sky from the image files of the spec: bilinear, averaged over as many samples a texel as an image finer than the face needs.
class Panorama {
public:
    // Errors: an image that load_image refuses; a band latitude outside (0, pi/2).
    static Result<Panorama> load(const SkySpec& spec, const Mat3& world_from_sky, int face_size);

    // Writes the rows. Cost: 1.4 s on one core for all of 2048 and an image of up to 9600 columns; in proportion to the pixels of finer
    // images.
    void paint(SkyRows& rows) const;

    // No light of paint() exceeds it.
    double largest() const { return largest_; }

    // What was done to images that are finer than the faces can show, a line each.
    const std::vector<std::string>& notes() const { return notes_; }

private:
    Vec3 sample(Vec3 sky_direction) const;  // any length
    Vec3 sample_band_and_caps(Vec3 sky_direction) const;

    SkyMapping mapping_ = SkyMapping::kEquirectangular;
    Image<float> image_, north_, south_;  // the whole sphere, or the band and its caps
    double band_latitude_ = 0.0, brightness_ = 1.0, largest_ = 0.0;
    int samples_ = 1;  // along each side of a texel
    Mat3 sky_from_world_;
    std::vector<std::string> notes_;
};

}  // namespace nullscope
