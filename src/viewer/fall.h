// A camera that was let go: its worldline, the place on it, and whether its clock runs. Pure: no window, no OpenGL.
#pragma once
#include <optional>

#include "observer/worldline.h"
#include "scene/scene.h"

namespace nullscope::viewer {

class Fall {
public:
    // From the scene's camera, its clock at 0 and running. Errors: no such observer.
    Status let_go(const Scene& scene);
    void stop() { line_.reset(), runs_ = false; }
    bool active() const { return line_.has_value(); }
    bool runs() const { return runs_; }
    void run(bool on) { runs_ = on && active(); }
    double rate = 1.0;  // proper time per second, r_s/c
    double tau() const { return tau_; }
    const Worldline& line() const { return *line_; }  // while active
    // Puts the camera where it is at that proper time, and the scene's clock with it; lens and size stay.
    void seek(Scene& scene, double tau);
    // The clock goes on by dt_s seconds. A camera that a hand has turned or moved since falls on from there. True if it moved.
    bool step(Scene& scene, double dt_s);

private:
    std::optional<Worldline> line_;
    CameraSpec shown_;  // as it was written last
    double tau_ = 0.0;
    double start_time_ = 0.0, shown_time_ = 0.0;  // Scene::time when let go; as it was written last
    bool runs_ = false;
};

}  // namespace nullscope::viewer
