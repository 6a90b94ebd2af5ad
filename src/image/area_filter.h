// Makes pictures smaller while they stream by: every new pixel is the mean of the area it covers.
#pragma once
#include <utility>
#include <vector>

#include "image/image.h"

namespace nullscope {

// Rows go in from the top, each once; the picture that comes out is never larger. Colours are weighted by alpha where there are four
// channels. Holds the new picture and two rows. Of the same size in and out: every value comes out as it went in (colours of an
// alpha above 0).
class AreaFilter {
public:
    // 0 < to_width <= width, 0 < to_height <= height; channels 3 or 4.
    AreaFilter(int width, int height, int channels, int to_width, int to_height);
    void add_row(const float* row);  // width * channels numbers, linear light
    Image<float> take() { return std::move(image_); }

private:
    struct Part {
        int first;           // new column or row
        float here, beyond;  // weights there and in the one after
    };
    static std::vector<Part> parts_of(int from, int to);

    int channels_;
    std::vector<Part> columns_, rows_;
    std::vector<float> line_, sum_, next_;
    std::size_t row_ = 0;
    Image<float> image_;
};

// The size of a picture whose longer side is at most max_side; its own if that is so.
struct FittedSize {
    int width, height;
};
FittedSize fitted_size(int width, int height, int max_side);

}  // namespace nullscope
