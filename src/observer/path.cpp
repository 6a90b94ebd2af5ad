#include "observer/path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "observer/pose.h"
#include "observer/turn.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

constexpr double kLongest = 1e4;  // r_s/c: of a fall to the end that does not come, an orbit

constexpr double Vec3::*kAxes[] = {&Vec3::x, &Vec3::y, &Vec3::z};

template <class Of>
double between_ends(const PathSpec& path, double frame, const Of& of) {
    if (path.easing == PathEasing::kNone || path.kind != PathKind::kKeys) return frame;
    const double first = path.keys.front().frame, last = path.keys.back().frame;
    if (frame < first || frame > last) return frame;
    return first + (last - first) * of((frame - first) / (last - first));
}

}  // namespace

Result<CameraPath> CameraPath::make(const Scene& scene) {
    if (!scene.path) return bad_input("the scene has no [path]", "a scene with one");
    CameraPath path;
    path.path_ = *scene.path;
    path.start_ = scene.camera;
    path.frames_ = scene.path->frames;
    if (scene.path->kind == PathKind::kKeys) {
        if (scene.path->closed) path.close();
        return path;
    }
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    const double wanted = scene.path->duration;
    TRY(line, Worldline::make(*spacetime, scene.camera, wanted > 0 ? wanted : kLongest));
    path.duration_ = wanted > 0 ? wanted : line->last();
    // What keeps its orientation keeps it in the frame of what falls: at the first frame the one that it has at rest or on an orbit.
    const CameraSpec first = line->at(0);
    path.start_.yaw = first.yaw, path.start_.pitch = first.pitch, path.start_.roll = first.roll;
    path.line_ = std::move(*line);
    return path;
}

// The last key before the first, and the first two after the last: the cubic joins with one slope. The clock goes on at the keys' mean rate.
void CameraPath::close() {
    std::vector<PathKey>& keys = path_.keys;
    const double first = keys.front().frame, span = keys.back().frame - first;
    turn_time_ = span > 0 ? (keys.back().time - keys.front().time) / span * frames_ : 0.0;
    const auto moved = [&](PathKey key, int turns) {
        key.frame += turns * frames_, key.time += turns * turn_time_;
        return key;
    };
    PathKey before = moved(keys.back(), -1), after = moved(keys[0], 1), beyond = moved(keys[1], 1);
    unwrap_angles(keys.front().camera, before.camera);
    unwrap_angles(keys.back().camera, after.camera);
    unwrap_angles(after.camera, beyond.camera);
    keys.insert(keys.begin(), std::move(before));
    keys.push_back(std::move(after));
    keys.push_back(std::move(beyond));
}

double CameraPath::in_turn(double frame) const {
    if (!path_.closed) return frame;
    const double first = path_.keys[1].frame;  // the one before is a copy
    return first + (frame - first) - frames_ * std::floor((frame - first) / frames_);
}

void unwrap_angles(const CameraSpec& before, CameraSpec& camera) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    for (const auto angle : {&CameraSpec::phi, &CameraSpec::yaw, &CameraSpec::roll})
        camera.*angle += kTurn * std::round((before.*angle - camera.*angle) / kTurn);
}

double eased(const PathSpec& path, double frame) {
    return between_ends(path, frame, [](double u) { return u * u * (3 - 2 * u); });
}

double frame_of_key(const PathSpec& path, double key_frame) {
    return between_ends(path, key_frame, [](double s) { return 0.5 - std::sin(std::asin(1 - 2 * s) / 3); });
}

double CameraPath::proper_time(double frame) const { return duration_ * std::clamp(frame / (frames_ - 1), 0.0, 1.0); }

CameraSpec CameraPath::at(double frame) const {
    if (!line_) return through_keys(frame);
    CameraSpec camera = line_->at(proper_time(frame));
    if (path_.orientation == PathOrientation::kCentre)
        camera.yaw = start_.yaw, camera.pitch = start_.pitch, camera.roll = start_.roll;
    return camera;
}

// Cubic Hermite between keys; slopes of the parabola through a key and its neighbours, straight at the ends. of: a number of a key. within: slopes
// are at most three times the lesser of the secants beside them, and 0 where these differ in sign: Fritsch and Carlson (1980).
template <class Of>
double CameraPath::between_keys(double frame, const Of& of, bool within) const {
    const auto& keys = path_.keys;
    const double t = std::clamp(frame, keys.front().frame, keys.back().frame);
    const std::size_t i = key_before(frame);
    const auto slope = [&](std::size_t k) {
        const std::size_t low = k > 0 ? k - 1 : k, high = std::min(k + 1, keys.size() - 1);
        const auto secant = [&](std::size_t a, std::size_t b) {
            return (of(keys[b]) - of(keys[a])) / (keys[b].frame - keys[a].frame);
        };
        if (low == k || high == k) return secant(low, high);
        const double before = keys[k].frame - keys[low].frame, beyond = keys[high].frame - keys[k].frame;
        const double left = secant(low, k), right = secant(k, high);
        const double parabola = (beyond * left + before * right) / (before + beyond);
        if (!within) return parabola;
        const double most = left * right > 0 ? 3 * std::min(std::abs(left), std::abs(right)) : 0.0;
        return std::clamp(parabola, -most, most);
    };
    const double h = keys[i + 1].frame - keys[i].frame, x = (t - keys[i].frame) / h, y = 1 - x;
    return std::lerp(of(keys[i]), of(keys[i + 1]), x * x * (1 + 2 * y)) +
           h * x * y * (y * slope(i) - x * slope(i + 1));  // equal numbers stay as they are
}

std::size_t CameraPath::key_before(double frame) const {
    const auto& keys = path_.keys;
    const auto after = std::upper_bound(keys.begin() + 1, keys.end() - 1, frame,
                                        [](double f, const PathKey& k) { return f < k.frame; });
    return static_cast<std::size_t>(after - keys.begin()) - 1;
}

double CameraPath::clock(double frame) const {
    if (line_) return line_->clock(proper_time(frame));
    const double at = in_turn(frame);
    const double turns = path_.closed ? std::round((frame - at) / frames_) : 0.0;
    return turns * turn_time_ + between_keys(eased(path_, at), [](const PathKey& key) { return key.time; });
}

std::vector<double> CameraPath::values(double frame) const {
    std::vector<double> found;
    for (std::size_t i = 0; i < path_.keyed.size(); ++i)
        found.push_back(between_keys(
            eased(path_, in_turn(frame)), [i](const PathKey& key) { return key.values[i]; }, true));
    return found;
}

// At its place: at a key as the key says.
void CameraPath::turn_between_keys(double frame, CameraSpec& camera) const {
    const PathKey *before = &path_.keys[key_before(frame)], *after = before + 1;
    if (frame > before->frame && frame < after->frame)
        set_world_axes(camera, axes_between(world_from_camera(before->camera), world_from_camera(after->camera),
                                            (frame - before->frame) / (after->frame - before->frame)));
}

CameraSpec CameraPath::through_keys(double at) const {
    const double frame = eased(path_, in_turn(at));
    CameraSpec camera = path_.keys[key_before(frame)].camera;
    for (const auto member : kCameraNumbers)
        camera.*member = between_keys(frame, [member](const PathKey& key) { return key.camera.*member; });
    for (const auto axis : kAxes)
        camera.velocity.*axis = between_keys(frame, [axis](const PathKey& key) { return key.camera.velocity.*axis; });
    if (camera.zoom)
        for (const auto member : {&ZoomSpec::depth, &ZoomSpec::angle})
            *camera.zoom.*member = between_keys(
                frame, [member](const PathKey& key) { return key.camera.zoom.value_or(ZoomSpec{}).*member; });
    else if (path_.turn == PathTurn::kShortest)
        turn_between_keys(frame, camera);
    return camera;
}

}  // namespace nullscope
