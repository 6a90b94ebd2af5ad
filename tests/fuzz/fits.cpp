// FITS pictures.
#include <cmath>

#include "fuzz.h"
#include "image/fits_input.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    const auto picture = parse_fits(fuzz::text_of(data, size), "picture.fits");
    if (!picture) {
        fuzz::must_be_a_good_error(picture.error());
        return 0;
    }
    const Image<double>& planes = picture->planes;
    fuzz::must(planes.width > 0 && planes.height > 0 && (planes.channels == 1 || planes.channels == 4),
               "it is a picture");
    fuzz::must(planes.data.size() * 4 <= size, "its numbers are in the file");
    for (const double value : planes.data) fuzz::must(std::isfinite(value), "its numbers are finite");
    return 0;
}
