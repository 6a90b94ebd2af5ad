// Observers next to the photon sphere, where circular orbits come up to the speed of light.
#include "observer/observer.h"

#include <doctest/doctest.h>

#include <cmath>

#include "spacetime/registry.h"

using namespace nullscope;

TEST_CASE("observers: none is as fast as light, by rounding neither") {
    const auto hole = *make_spacetime("schwarzschild", {});
    int refused = 0, made = 0;
    for (double gap = 1.0; gap > 1e-17; gap *= 0.1)
        for (const double boost : {0.0, 0.9, 0.999999, -0.5}) {
            CameraSpec camera;
            camera.r = std::nextafter(1.5, 2.0) + gap, camera.observer = ObserverKind::kOrbit;
            camera.velocity = {0, 0, boost};
            const auto observer = observer_of(*hole, camera);
            CAPTURE(gap);
            CAPTURE(boost);
            if (observer) CHECK(length(observer->velocity) < 1.0);
            if (!observer) CHECK(observer.error().message().find("camera.observer") != std::string::npos);
            ++(observer ? made : refused);
        }
    CHECK(made > 20);
    CHECK(refused > 3);
}
