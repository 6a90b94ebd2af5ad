#include "studio/timeline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scenefile/path_values.h"

namespace nullscope::viewer {
namespace {

constexpr double kRecordRate = 24.0;  // frames a second
constexpr int kKeyEvery = 4;          // frames: six keys a second, which smooth a hand's trembling
constexpr double kLeastRecord_s = 0.2;

CameraSpec between(const CameraSpec& a, const CameraSpec& b, double t) {
    CameraSpec camera = a;
    for (const auto number : kCameraNumbers) camera.*number = std::lerp(a.*number, b.*number, t);
    camera.velocity = (1.0 - t) * a.velocity + t * b.velocity;
    return camera;
}

}  // namespace

void Timeline::follow(const Scene& scene, bool scene_changed) {
    if (!scene_changed && of_ == scene.path && spacetime_ == scene.spacetime) return;
    if (scene_changed || !of_ || !scene.path) start_ = scene.camera, time_ = scene.time, frame = 0.0, plays_ = false;
    if (scene_changed || !of_ || !scene.path || of_->keyed != scene.path->keyed) values_ = path_values_of(scene);
    of_ = scene.path, spacetime_ = scene.spacetime;
    path_.reset();
    if (!scene.path) return;
    Scene from = scene;
    from.camera = start_;
    if (auto made = CameraPath::make(from)) path_ = std::move(*made);
    frame = std::min(frame, frames() - 1.0);
}

void Timeline::play(bool on) {
    plays_ = on && has_path();
    if (plays_ && frame >= frames() - 1.0) frame = 0.0;
}

void Timeline::seek(Scene& scene, double to) {
    if (!path_) return;
    frame = std::clamp(to, 0.0, path_->last());
    const CameraSpec now = std::exchange(scene.camera, path_->at(frame));
    scene.camera.width = now.width, scene.camera.height = now.height;
    scene.time = time_ + path_->clock(frame);
    set_path_values(scene, path_->values(frame));
    shown_ = scene.camera;
}

bool Timeline::step(Scene& scene, double dt_s) {
    if (!plays_ || !path_) return false;
    const double last = path_->last();
    double next = frame + dt_s * speed * scene.path->rate;
    if (next > last && loops) next = std::fmod(next, last);
    plays_ = loops || next < last;
    seek(scene, next);
    return true;
}

Scene Timeline::to_save(Scene scene) const {
    if (!path_) return scene;
    const bool on_path =
        scene.camera.r == shown_.r && scene.camera.phi == shown_.phi && scene.camera.theta == shown_.theta;
    if (!on_path || frame == 0.0) return scene;
    const CameraSpec now = std::exchange(scene.camera, start_);
    scene.camera.width = now.width, scene.camera.height = now.height;
    scene.time = time_;
    set_path_values(scene, values_);
    return scene;
}

void Timeline::record(const Scene& scene) {
    plays_ = false;
    records_ = true;
    samples_ = {{0.0, scene.camera, scene.time}};
}

bool Timeline::sample(const Scene& scene, double dt_s) {
    if (!records_) return true;
    if (scene.camera.observer != samples_.back().camera.observer) {
        record(scene);
        return false;
    }
    Sample next{samples_.back().at_s + dt_s, scene.camera, scene.time};
    unwrap_angles(samples_.back().camera, next.camera);
    samples_.push_back(next);
    return true;
}

bool Timeline::stop_record(Scene& scene) {
    records_ = false;
    const std::vector<Sample> samples = std::move(samples_);
    samples_.clear();
    if (samples.size() < 2 || samples.back().at_s < kLeastRecord_s) return false;
    PathSpec path;
    path.kind = PathKind::kKeys, path.rate = kRecordRate;
    const int last = static_cast<int>(samples.back().at_s * kRecordRate);
    path.frames = last + 1;
    auto after = samples.begin() + 1;
    for (int at = 0; at <= last; at = at < last ? std::min(at + kKeyEvery, last) : last + 1) {
        const double at_s = at / kRecordRate;
        while (after + 1 != samples.end() && after->at_s < at_s) ++after;
        const Sample& from = *(after - 1);
        const double t = std::clamp((at_s - from.at_s) / std::max(after->at_s - from.at_s, 1e-9), 0.0, 1.0);
        path.keys.push_back({static_cast<double>(at),
                             between(from.camera, after->camera, t),
                             std::lerp(from.time, after->time, t) - samples.front().time,
                             {}});
    }
    scene.time = samples.front().time;
    scene.camera = samples.front().camera;
    scene.path = std::move(path);
    return true;
}

bool Timeline::set_key(Scene& scene) {
    PathKey key{std::round(frame), scene.camera, scene.time - time_, path_values_of(scene)};
    if (!scene.path) {
        scene.path.emplace().kind = PathKind::kKeys;
        scene.path->keys = {{0.0, key.camera, 0.0, {}}, {scene.path->frames - 1.0, key.camera, 0.0, {}}};
        return true;
    }
    auto& keys = scene.path->keys;
    if (scene.path->kind != PathKind::kKeys || keys.front().camera.observer != key.camera.observer) return false;
    key.frame = eased(*scene.path, key.frame);
    const auto at = std::ranges::lower_bound(keys, key.frame, {}, &PathKey::frame);
    if (at != keys.begin()) unwrap_angles((at - 1)->camera, key.camera);
    if (at != keys.end() && at->frame == key.frame)
        *at = key;
    else
        keys.insert(at, key);
    return true;
}

bool Timeline::delete_key(Scene& scene) {
    if (!scene.path || scene.path->keys.size() <= 2) return false;
    auto& keys = scene.path->keys;
    keys.erase(std::ranges::min_element(
        keys, {}, [&](const PathKey& key) { return std::fabs(frame_of_key(*scene.path, key.frame) - frame); }));
    return true;
}

}  // namespace nullscope::viewer
