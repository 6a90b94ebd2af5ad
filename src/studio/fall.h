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
    void stop() { line_.reset(), runs_ = false, least_ = 1.0, slowing_ = 0.0; }
    bool active() const { return line_.has_value(); }
    bool runs() const { return runs_; }
    bool ended() const { return active() && !runs_ && left() <= 0.0; }  // it has come to its end
    void run(bool on) { runs_ = on && active(); }
    // Proper time per second, r_s/c: of a fall that ends it falls with what is left, so that from any radius the end comes after 20 s, the last
    // r_s/c of them slowly; else 1. haste: a factor on it, of the hand's.
    double rate() const { return haste * (least_ + slowing_ * left()); }
    double haste = 1.0;
    double tau() const { return tau_; }
    const Worldline& line() const { return *line_; }  // while active
    // Puts the camera where it is at that proper time, and the scene's clock with it; lens and size stay.
    void seek(Scene& scene, double tau);
    // The clock goes on by dt_s seconds. A camera that a hand has turned or moved since falls on from there. True if it moved.
    bool step(Scene& scene, double dt_s);

private:
    double left() const { return line_ ? line_->last() - tau_ : 0.0; }
    std::optional<Worldline> line_;
    CameraSpec shown_;  // as it was written last
    double tau_ = 0.0;
    double least_ = 1.0, slowing_ = 0.0;          // r_s/c a second, 1/s
    double start_time_ = 0.0, shown_time_ = 0.0;  // Scene::time when let go; as it was written last
    bool runs_ = false;
};

}  // namespace nullscope::viewer
