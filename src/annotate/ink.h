// What annotations are drawn with: coverage, and the mark that it makes.
#pragma once
#include <cstddef>
#include <vector>

#include "annotate/marks.h"

namespace nullscope {

struct Sheet {  // coverage, 0 to 1
    int width, height;
    std::vector<float> data;
    Sheet(int w, int h) : width(w), height(h), data(static_cast<std::size_t>(w) * h) {}
    float& at(int x, int y) { return data[static_cast<std::size_t>(y) * width + x]; }
    float at(int x, int y) const { return data[static_cast<std::size_t>(y) * width + x]; }
};

// White ink with a soft dark outline. ink: its coverage, whose top left corner comes to x, y. em: size of what is drawn, px, by which the outline is
// wide. strength: of the white, [0, 1].
Mark outlined(const Sheet& ink, int x, int y, double em, double strength);

}  // namespace nullscope
