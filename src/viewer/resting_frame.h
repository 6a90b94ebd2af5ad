// When ray data of the frame on the screen are asked for: only of a frame that is looked at and rests.
#pragma once
#include "render/renderer.h"
#include "scene/scene.h"

namespace nullscope::viewer {

class RestingFrame {
public:
    bool frame_is(const Scene& scene,
                  const Method& method);  // on the screen from now on; true: its rays are other ones
    void update(bool wanted, bool moving);
    bool asks_for_rays() const { return asks_; }  // until they come
    bool takes(const Scene& scene);               // rays of it have come; false: they were not asked for
    bool has_rays() const { return has_rays_; }
    void forget_rays() { has_rays_ = false; }
    double wait() const;  // s until update() may ask; infinite: it will not
    const Scene& scene() const { return scene_; }

private:
    bool wanted_ = false, asks_ = false, has_rays_ = false;
    double changed_at_ = 0.0;
    Scene scene_;
    Method method_;
};

}  // namespace nullscope::viewer
