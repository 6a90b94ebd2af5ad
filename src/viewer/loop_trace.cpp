#include "viewer/loop_trace.h"

#include <utility>

#include "render/picture_layers.h"

namespace nullscope::viewer {

void LoopTrace::begin(std::optional<LoopOrder> order) {
    order_ = std::move(order);
    loop_.clear();
    if (!order_) renderer_.reset();
}

const StokesLoop& LoopTrace::step() {
    if (renderer_ == nullptr) renderer_ = std::make_unique<Renderer>();
    Scene& scene = order_->scene;
    scene.time = order_->time(static_cast<int>(loop_.size()));
    if (!renderer_->prepare(scene)) {  // the picture says why
        order_.reset();
        return loop_;
    }
    loop_.push_back(
        stokes_sum(draw_stokes(*renderer_), scene.camera, {0, 0, scene.camera.width, scene.camera.height}, scene.time));
    if (loop_.size() == LoopOrder::kPoints) order_.reset();
    return loop_;
}

}  // namespace nullscope::viewer
