// Pixels of a picture, as a scene predicts them.
#pragma once
#include <memory>
#include <vector>

#include "fit/painted_model.h"
#include "fit/picture_data.h"

namespace nullscope::fit {

class PictureModel final : public PaintedModel {
public:
    PictureModel(std::shared_ptr<ScenePainter> painter, const PictureData& data, int samples);
    Result<Prediction> predict(const std::vector<double>& values) override;

private:
    bool of_sky_;
    std::vector<std::size_t> pixels_;  // that count
};

}  // namespace nullscope::fit
