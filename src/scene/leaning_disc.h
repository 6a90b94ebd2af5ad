// The plane of a scene's disc, where its time has it.
#pragma once
#include "scene/disc_plane.h"
#include "scene/scene.h"

namespace nullscope {

// The equatorial plane where there is no disc.
inline DiscPlane disc_plane_of(const Scene& scene) {
    return scene.disc ? disc_plane(scene.disc->lean, scene.time) : DiscPlane{};
}
inline bool disc_leans(const Scene& scene) { return scene.disc && scene.disc->lean.tilt != 0.0; }
inline bool disc_precesses(const Scene& scene) {
    return scene.disc && scene.disc->lean.precession != 0.0 &&
           (scene.disc->lean.tilt != 0.0 || scene.disc->warp.bends());
}

}  // namespace nullscope
