// What shaders say of projections, from their rows (scene/projection_table.h). Of a pinhole all are empty. Links nothing: src/coretexts has it too.
#pragma once
#include <string>
#include <vector>

#include "scene/projection_kind.h"

namespace nullscope {

struct ProjectionText {
    // generated/projection: projection/NAME.glsl of each; float beyond_view(vec2 place), how far beyond what the picture shows a place is, px
    // of a pixel's height, negative within.
    std::string files;
    std::string view;   // generated/projection_view, within projection_view(place): NAME_view(place) of the camera's
    std::string place;  // generated/projection_place, within view_place(view): likewise NAME_place(view)
};
ProjectionText projection_text(const std::vector<Projection>& projections);

}  // namespace nullscope
