// What the page shows: a scene, and what the user has changed of it.
#pragma once
#include "scene/scene.h"
#include "studio/fall.h"

namespace nullscope::web {

struct Session {
    Scene scene;
    viewer::Fall fall;  // of the camera, once it was let go
};
Session& session();

}  // namespace nullscope::web
