// A camera path in the viewer: recorded from what is flown, played, scrubbed, and changed key by key. Pure: no window, no OpenGL.
#pragma once
#include <optional>
#include <vector>

#include "observer/path.h"
#include "scene/scene.h"

namespace nullscope::viewer {

class Timeline {
public:
    // The scene's path may be another than before. scene_changed: another scene was opened, whose camera a fall begins with. Cost: compares;
    // a new fall is integrated, milliseconds.
    void follow(const Scene& scene, bool scene_changed);
    bool has_path() const { return path_.has_value(); }
    int frames() const { return path_ ? path_->frames() : 0; }

    double frame = 0.0;  // on the screen: 0 to frames() - 1
    bool loops = true;
    double speed = 1.0;  // 1: as the film
    bool plays() const { return plays_; }
    void play(bool on);

    // Puts the scene's camera and its clock where they are in that frame; lens and size of the window stay the path's and the window's.
    void seek(Scene& scene, double to);
    bool step(Scene& scene, double dt_s);  // true if it moved
    // As a file should have it: with the camera and the time of frame 0 while the camera is on the path.
    Scene to_save(Scene scene) const;

    // Recording: what the camera does from now on, one sample for each call.
    void record(const Scene& scene);
    bool records() const { return records_; }
    double recorded_s() const { return samples_.empty() ? 0.0 : samples_.back().at_s; }
    // False: the observer has changed, and the record has begun anew, for a path is of one observer.
    bool sample(const Scene& scene, double dt_s);
    // Ends it, and makes it the scene's path, in the frames of `rate` a second; false: too short.
    bool stop_record(Scene& scene);

    // A key of the path at the frame on the screen, with the scene's camera; a path where there is none, with this one key twice. False: the
    // path is a fall, or of another observer.
    bool set_key(Scene& scene);
    // The nearest key is removed; false: there are no more than two.
    bool delete_key(Scene& scene);

private:
    struct Sample {
        double at_s;
        CameraSpec camera;
        double time;
    };
    std::optional<CameraPath> path_;
    std::optional<PathSpec> of_;  // that path_ was made of
    SpacetimeSpec spacetime_;     // likewise
    CameraSpec start_, shown_;    // as the scene had it; as seek wrote it last
    std::vector<double> values_;  // that path_'s keys set, as the scene had them
    double time_ = 0.0;           // Scene::time of frame 0
    bool plays_ = false, records_ = false;
    std::vector<Sample> samples_;
};

}  // namespace nullscope::viewer
