// A camera beside a camera: an eye of a stereo picture.
//
// The eye lies at the end of the geodesic that leaves the camera in a direction of its own space (its tetrad's e_1 right, e_2 up, e_3
// backward: what it takes for simultaneous), at that proper length. It has the camera's tetrad, carried there in parallel. So eyes are at
// rest to each other and look the same way, in any metric and for any observer, inside a horizon and at a wormhole's throat too; where
// spacetime is flat they are parallel cameras side by side. The picture of an eye is what a camera shows that is there: nothing is
// neglected but what rounding leaves, some 1e-9 of the distance.
#pragma once
#include "base/result.h"
#include "base/vec.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

struct Eye {
    CameraSpec camera;  // place, velocity and turn are the eye's; the rest is as it was
    double later = 0;   // than the middle's Scene::time is the eye's, r_s/c; 0 of static cameras
};

// offset: r_s, along (right, up, backward). Some 0.5 ms. Errors: no such observer there; farther than kFarthestEye of the areal radius.
inline constexpr double kFarthestEye = 0.25;
Result<Eye> eye_beside(const Spacetime& spacetime, const CameraSpec& camera, Vec3 offset);

// Whether there is a place for the eyes of a stereo camera, all-round on the circle that they go round. Errors: of camera.eye_distance.
Status check_eyes(const Spacetime& spacetime, const CameraSpec& camera);

}  // namespace nullscope
