// Annotations as small pictures, laid over a displayed one.
#pragma once
#include <string>
#include <vector>

#include "annotate/annotations.h"
#include "image/image.h"

namespace nullscope {

// White with a soft dark outline. Top left corner in the picture, beyond whose edges it may reach; rgba: straight
// alpha.
struct Mark {
    int x = 0, y = 0;
    Image<unsigned char> rgba;
};

struct Marks {
    std::vector<Mark> marks;
    std::string note;  // why there are no letters, if there should be some
};

// Of a picture of width by height px: the line between the halves, the labels on either side `top` px below its top, the bar
// `bottom` px above its lower right corner. Letters are a fortieth of the height, at least 11 px. Pictures with a side
// below 64 px get nothing. Without a font: the line alone. With lay_over some 30 ms at 3840x2160.
Marks make_marks(const Annotations& annotations, int width, int height, int top = 0, int bottom = 0);

// picture: 3 channels, display-encoded.
void lay_over(const std::vector<Mark>& marks, Image<unsigned char>& picture);
void lay_over(const std::vector<Mark>& marks, Image<unsigned short>& picture);

}  // namespace nullscope
