#include "gradient/picture_flux.h"

#include <cmath>

#include "gradient/light_spoke.h"

namespace nullscope {

Result<FluxGradient> flux_gradient(const PictureLight& light, const FluxRule& rule,
                                   const std::function<void(double)>& done) {
    TRY(picture, picture_about_hole(light.scene().camera, light.view()));
    const std::size_t keys = light.keys().size();
    const SpokeSum sum_of = [&](double angle, FluxGradient& sum) {
        const LightSpoke spoke = light_spoke(light, picture->from, angle,
                                             to_edge(*picture, std::cos(angle), std::sin(angle)), {rule.places});
        for (std::size_t i = 0; i < spoke.numbers.size(); i += place_numbers(keys)) {
            sum.flux += spoke.numbers[i + 1];
            for (std::size_t key = 0; key < keys; ++key) sum.by[key] += spoke.numbers[i + 2 + key];
        }
        sum.rays += spoke.rays;
    };
    return sum_of_spokes(*picture, keys, rule.tolerance, sum_of, done);
}

}  // namespace nullscope
