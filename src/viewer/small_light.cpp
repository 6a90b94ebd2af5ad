#include "viewer/small_light.h"

#include <algorithm>
#include <cmath>

namespace nullscope::viewer {

Scene in_fewer_pixels(Scene scene, int side) {
    CameraSpec& camera = scene.camera;
    const double smaller = std::max(1.0, static_cast<double>(std::max(camera.width, camera.height)) / side);
    camera.width = std::max(1, static_cast<int>(std::lround(camera.width / smaller)));
    camera.height = std::max(1, static_cast<int>(std::lround(camera.height / smaller)));
    return scene;
}

Scene small_scene(const Scene& scene, int side) {
    Scene small = in_fewer_pixels(scene, side);
    small.picture.samples = 1, small.picture.refine = false, small.picture.ticks = false;
    return small;
}

Image<float> SmallLight::draw(const PaintJob& job, int side, const StarField::Search& search) {
    if (renderer_ == nullptr) {
        renderer_ = std::make_unique<Renderer>();
        renderer_->follow_camera();
    }
    renderer_->search_stars(search);
    renderer_->draft(search.quick);
    renderer_->set_method(job.method);
    if (job.scene.split || !renderer_->prepare(small_scene(job.scene, side))) return {};
    return renderer_->picture();
}

}  // namespace nullscope::viewer
