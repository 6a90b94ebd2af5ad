// Ticks over a displayed picture: along the electric vector of its light, as long as its fraction that is polarised.
#pragma once
#include <vector>

#include "annotate/marks.h"
#include "image/image.h"
#include "scene/scene.h"

namespace nullscope {

// How many ticks a picture of width by height px has along its sides: one for each 22nd part of the smaller side, at least 12 px apart.
struct TickGrid {
    int columns, rows;
};
TickGrid tick_grid(int width, int height);
// The same view in a picture of the grid's size, whose Stokes parameters ticks are made of.
Scene tick_scene(Scene scene, int width, int height);
double tick_thickness(int width, int height);  // px

struct Tick {
    double x, y;       // its middle, px from the picture's top left corner
    double right, up;  // from there to its end, px
};
// stokes: I, Q, U, V of a picture of the grid's size, angles from right towards up. The largest fraction is as long as ticks are apart, but for a gap;
// where light is below a fiftieth of the brightest, or the tick would be shorter than it is thick, there is none.
std::vector<Tick> ticks_of(const Image<float>& stokes, int width, int height);

std::vector<Mark> tick_marks(const Image<float>& stokes, int width, int height);  // of the same

}  // namespace nullscope
