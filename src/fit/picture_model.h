// Pixels of a picture, as a scene predicts them.
#pragma once
#include <memory>
#include <vector>

#include "fit/model.h"
#include "fit/picture_data.h"
#include "fit/scene_painter.h"

namespace nullscope::fit {

inline constexpr int kMostSamples = 16;

class PictureModel final : public Model {
public:
    PictureModel(std::shared_ptr<ScenePainter> painter, const PictureData& data, int samples);
    Result<Prediction> predict(const std::vector<double>& values) override;
    void set_samples(int samples) { size_.samples = samples; }
    int samples() const { return size_.samples; }

private:
    std::shared_ptr<ScenePainter> painter_;
    PaintedSize size_;
    bool of_sky_;
    std::vector<std::size_t> pixels_;  // that count
};

}  // namespace nullscope::fit
