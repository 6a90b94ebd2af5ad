// The camera of every frame of a scene's path: a function of the frame alone.
#pragma once
#include <optional>

#include "base/result.h"
#include "observer/worldline.h"
#include "scene/scene.h"

namespace nullscope {

// Numbers of a camera that are interpolated; its velocity is as well.
inline constexpr double CameraSpec::*kCameraNumbers[] = {
    &CameraSpec::r,           &CameraSpec::theta,     &CameraSpec::phi,         &CameraSpec::yaw,
    &CameraSpec::pitch,       &CameraSpec::roll,      &CameraSpec::plane_width, &CameraSpec::focal_distance,
    &CameraSpec::exposure_ev, &CameraSpec::fall_from, &CameraSpec::energy,      &CameraSpec::shift_x,
    &CameraSpec::shift_y};

// Turns phi, yaw and roll by whole turns, so that none is more than half a turn from what it is before.
void unwrap_angles(const CameraSpec& before, CameraSpec& camera);

// Where among the keys' frames the path is in a frame, by its easing: u, of the way from the first key to the last, becomes 3u^2 - 2u^3.
// And the frame in which it is there. Of a fall, and beyond the keys, the same.
double eased(const PathSpec& path, double frame);
double frame_of_key(const PathSpec& path, double key_frame);

class CameraPath {
public:
    // Errors: the scene has no path; no such observer. A fall is integrated here: milliseconds.
    static Result<CameraPath> make(const Scene& scene);
    int frames() const { return frames_; }
    double last() const { return path_.closed ? frames_ : frames_ - 1; }  // where it ends, or begins again
    bool falls() const { return line_.has_value(); }
    CameraSpec at(double frame) const;  // from 0 to last(); beyond: the first and last, of a closed one the same again
    double clock(double frame) const;   // Scene::time then, later than the start's
    // Of PathSpec::keyed then: never beyond those of the keys about it, by slopes that are 0 where they would be.
    std::vector<double> values(double frame) const;

private:
    CameraPath() = default;
    double proper_time(double frame) const;  // of a fall
    CameraSpec through_keys(double frame) const;
    void close();
    double in_turn(double frame) const;  // of a closed path: where it is among the keys
    template <class Of>
    double between_keys(double frame, const Of& of, bool within = false) const;
    void turn_between_keys(double frame, CameraSpec& camera) const;
    std::size_t key_before(double frame) const;  // the last that is not the last of all
    PathSpec path_;
    CameraSpec start_;
    int frames_ = 0;
    double duration_ = 0, turn_time_ = 0;  // turn_time_: of a closed path, what the clock goes on by
    std::optional<Worldline> line_;
};

}  // namespace nullscope
