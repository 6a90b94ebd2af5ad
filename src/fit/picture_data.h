// A picture that is to be fitted: linear light of one channel, its errors, and which pixels count.
#pragma once
#include <optional>
#include <string>

#include "base/result.h"
#include "fit/model.h"
#include "image/image.h"

namespace nullscope::fit {

struct PictureData {
    Image<double> light, sigma;  // one channel each, top row first; sigma is 0 where a pixel does not count
    bool of_sky = false;         // of a FITS file: in its unit, else the luminance of colours
    std::size_t count() const;   // of pixels that count
    Observed observed(const std::string& name) const;  // row by row
};

struct PictureSources {
    std::string data;   // PNG, EXR, FITS and what else load_image() reads
    std::string sigma;  // a number, a number and % (of the brightest pixel), or a picture of the same size
    std::string mask;   // a picture of the same size whose pixels above one half count; empty: all
};
// Errors (bad input): those of the files, sizes that differ, a pixel that counts without a finite number or with an error that is not above 0, too
// many pixels, none.
Result<PictureData> load_picture_data(const PictureSources& sources);

// Means of squares of factor x factor pixels, with the errors of these means; a square counts where all of its pixels do. Nothing where sides are no
// multiples of it, or fewer than half of the pixels would count.
std::optional<PictureData> coarser(const PictureData& picture, int factor);

}  // namespace nullscope::fit
