#include "shaderlib/projection_text.h"

#include "scene/projection_table.h"

namespace nullscope {
namespace {

std::string is_number(int number) { return "frame.projection.x == " + std::to_string(number) + ".0"; }

std::string is_circle() {
    std::string any;
    for (int i = 0; i < kProjections; ++i)
        if (projection_row(static_cast<Projection>(i)).circle) any += (any.empty() ? "" : " || ") + is_number(i);
    return any;
}

}  // namespace

ProjectionText projection_text(const std::vector<Projection>& projections) {
    ProjectionText text;
    if (projections.empty()) return text;
    text.files = "float beyond_view(vec2 place) {\n    float way = " + is_circle() +
                 " ? sqrt(dot(place, place)) : abs(place.y);\n    return way - frame.projection.y;\n}\n";
    for (const Projection projection : projections) {
        const std::string name(projection_row(projection).name),
            chosen = "    if (" + is_number(static_cast<int>(projection)) + ") return " + name;
        text.files += "#include \"projection/" + name + ".glsl\"\n";
        text.view += chosen + "_view(place);\n";
        text.place += chosen + "_place(view);\n";
    }
    return text;
}

}  // namespace nullscope
