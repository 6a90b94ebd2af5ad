#include "fit/picture_model.h"

#include <utility>

#include "command/sky_light.h"
#include "image/luminance.h"
#include "telescope/flux.h"

namespace nullscope::fit {

PictureModel::PictureModel(std::shared_ptr<ScenePainter> painter, const PictureData& data, int samples)
    : PaintedModel(std::move(painter), {data.light.width, data.light.height, samples}), of_sky_(data.of_sky) {
    for (std::size_t i = 0; i < data.sigma.data.size(); ++i)
        if (data.sigma.data[i] > 0) pixels_.push_back(i);
}

Result<Prediction> PictureModel::predict(const std::vector<double>& values) {
    TRY(painted, paint(values));
    Prediction prediction;
    prediction.reserve(pixels_.size());
    if (of_sky_) {
        const Image<float> planes = cli::sky_planes(painted->captured, flux_unit(painted->scene, false));
        for (const std::size_t pixel : pixels_)
            prediction.push_back(planes.data[pixel * static_cast<std::size_t>(planes.channels)]);
    } else {
        for (const std::size_t pixel : pixels_)
            prediction.push_back(luminance_of(&painted->captured.linear.data[3 * pixel]));
    }
    return prediction;
}

}  // namespace nullscope::fit
