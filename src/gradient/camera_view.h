// What a scene's camera sees through a place of its picture, as ray_gradient() takes it, and how a scene's keys move that.
#pragma once
#include "base/result.h"
#include "gradient/flow.h"
#include "gradient/parameter.h"
#include "scene/scene.h"

namespace nullscope {

class CameraView {
public:
    // flow: of the scene's spacetime; outlives this. Errors: another observer than one at rest or without angular momentum, not of a pinhole, light whose
    // parts are switched off.
    static Result<CameraView> make(const Scene& scene, const Flow& flow);

    struct Seen {
        LookedAlong own;  // along the axes outward, southward, eastward of the camera, which moves
        Launch launch;    // derivatives by aside and across are by turns of `own`
        Number shift;     // frequency in the camera over that of an observer without angular momentum there
    };
    Seen seen(double x, double y) const;  // px from the picture's upper left corner

    // By how much a key moves what is seen there.
    Change change(ParameterKind kind, const Seen& seen) const;
    // One px in this direction of the picture, x to the right, y downward.
    Change moved(const Seen& seen, double x, double y, double by_x, double by_y) const;
    // Where light that runs straight outward comes from. Nothing: from behind the camera.
    std::optional<std::array<double, 2>> hole() const;

private:
    CameraView(const Scene& scene, const Flow& flow) : scene_(&scene), flow_(&flow) {}
    Number azimuthal_speed() const;
    const Scene* scene_;
    const Flow* flow_;
};

}  // namespace nullscope
