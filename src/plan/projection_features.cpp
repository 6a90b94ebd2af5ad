// Features of the camera's projections: of each row of scene/projection_table.h but the pinhole's.
#include <fmt/format.h>

#include <utility>

#include "plan/feature.h"
#include "scene/projection.h"

namespace nullscope {
namespace {

template <Projection projection>
Reason projection_is(const FrameFacts& f) {
    return reason_if(f.scene.camera.projection == projection,
                     fmt::format("camera.projection = \"{}\"", projection_name(projection)));
}
template <Projection projection>
void set_projection(Scene& s) {
    s.camera.projection = projection;
    set_field_of_view(s.camera, usual_field_of_view(projection));
}

template <Projection projection>
Feature projection_feature() {
    const ProjectionRow& row = projection_row(projection);
    return {{projection_effect(projection), row.effect, row.define, row.help,
             kept(fmt::format("camera.projection is \"{}\"", row.name)), row.cost},
            projection_is<projection>,
            set_projection<Projection::kPinhole>,
            nothing,
            set_projection<projection>};
}

template <int... number>
std::vector<Feature> all_but_the_first(std::integer_sequence<int, number...>) {
    return {projection_feature<static_cast<Projection>(number + 1)>()...};
}

}  // namespace

std::span<const Feature> projection_features() {
    static const std::vector<Feature> features = all_but_the_first(std::make_integer_sequence<int, kProjections - 1>());
    return features;
}

}  // namespace nullscope
