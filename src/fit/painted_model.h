// A model that draws its scene: each pixel the mean of its rays, of which there may be more.
#pragma once
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fit/model.h"
#include "fit/scene_painter.h"

namespace nullscope::fit {

inline constexpr int kFirstSamples = 4, kMostSamples = 16;

class PaintedModel : public Model {
public:
    bool finer() {  // four times as many rays; false: that would be too many
        if (size_.samples >= kMostSamples) return false;
        size_.samples *= 2;
        return true;
    }
    int samples() const { return size_.samples; }

protected:
    PaintedModel(std::shared_ptr<ScenePainter> painter, PaintedSize size) : painter_(std::move(painter)), size_(size) {}
    Result<ScenePainter::Painted> paint(const std::vector<double>& values, std::optional<double> time = {}) {
        return painter_->paint(values, size_, time);
    }
    const SceneFamily& family() const { return painter_->family(); }
    Result<Scene> scene_at(const std::vector<double>& values) const { return painter_->family().at(values); }

private:
    std::shared_ptr<ScenePainter> painter_;
    PaintedSize size_;
};

}  // namespace nullscope::fit
