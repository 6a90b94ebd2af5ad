// What the page shows: a scene, and what the user has changed of it.
#pragma once
#include "base/result.h"
#include "scene/scene.h"
#include "shaderlib/method.h"
#include "studio/fall.h"

namespace nullscope::web {

struct Session {
    Scene scene;
    viewer::Fall fall;  // of the camera, once it was let go
};
Session& session();
// How its rays are traced: the method that capture and the window choose where nothing is asked for (view.cpp).
Result<Method> method_of(const Scene& scene);

}  // namespace nullscope::web
