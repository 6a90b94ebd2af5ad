#include "plan/shutter.h"

#include <algorithm>
#include <cmath>

#include "observer/pose.h"
#include "plan/moving.h"

namespace nullscope {
namespace {

// The angle of the rotation from one camera's axes to the other's.
double turn_between(const CameraSpec& a, const CameraSpec& b) {
    const auto axes = [](const CameraSpec& c) { return world_from_static(c.theta, c.phi) * static_from_camera(c); };
    const Mat3 from = axes(a), to = axes(b);
    const double apart = length(Vec3{length(to.a - from.a), length(to.b - from.b), length(to.c - from.c)});
    return 2.0 * std::asin(std::min(apart / std::sqrt(8.0), 1.0));
}

}  // namespace

Exposure exposure_of(const std::function<Scene(double)>& at, int frame, bool varies) {
    Exposure shown(at(frame));
    const PictureSpec& picture = shown.scene.picture;
    if (picture.shutter == 0.0) return shown;
    const bool moves = changes_with_time(shown.scene);
    const double part = 1.0 / picture.sub_frames;
    for (int i = 0; i < picture.sub_frames; ++i) {
        Scene scene = at(frame + picture.shutter * ((i + 0.5) * part - 0.5));
        scene.camera.exposure_ev = shown.scene.camera.exposure_ev;  // of the mean
        if (!shown.sub_frames.empty()) {
            SubFrame& before = shown.sub_frames.back();
            if (!varies && before.scene.camera == scene.camera && (!moves || before.scene.time == scene.time)) {
                before.share += part;
                continue;
            }
        }
        shown.sub_frames.push_back({part, std::move(scene)});
    }
    if (shown.sub_frames.size() == 1) shown.sub_frames.clear();
    return shown;
}

std::vector<double> times_of(const Exposure& shown) {
    std::vector<double> times;
    for (const SubFrame& each : shown.sub_frames) times.push_back(each.scene.time);
    if (times.empty()) times.push_back(shown.scene.time);
    return times;
}

int smooth_sub_frames(const Exposure& shown) {
    if (shown.sub_frames.empty() || shown.scene.camera.zoom) return 1;
    double turned = 0, time = 1;  // between the middles of the first and the last
    for (std::size_t i = 0; i < shown.sub_frames.size(); ++i) {
        const auto& [share, scene] = shown.sub_frames[i];
        if (i == 0 || i + 1 == shown.sub_frames.size()) time -= 0.5 * share;
        if (i > 0) turned += turn_between(shown.sub_frames[i - 1].scene.camera, scene.camera);
    }
    return std::max(1, static_cast<int>(std::ceil(turned / time / shown.scene.camera.pixel() / kSmoothStep_px)));
}

}  // namespace nullscope
