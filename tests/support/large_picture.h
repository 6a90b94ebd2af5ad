// The rays of a picture that is too large to be traced whole: those of squares that lie apart.
#pragma once
#include <functional>

#include "support/gpu_session.h"

namespace nullscope::test {

// scene: with the whole picture's camera. f: of each ray, with its column and row in the whole picture.
inline void each_ray_of_squares(GpuSession& session, const Scene& scene,
                                const std::function<void(const RayPixel& ray, int column, int row)>& f) {
    constexpr int kSide = 64, kApart = 1016;  // px
    const CameraSpec& whole = scene.camera;
    for (int top = 0; top < whole.height; top += kApart)
        for (int left = 0; left < whole.width; left += kApart) {
            Scene part = scene;
            part.camera.part = PicturePart{left, top, whole.width, whole.height};
            part.camera.width = part.camera.height = kSide;
            const RayFrame frame = gl_ray_data(session, part);
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x < kSide; ++x) f(frame.at(x, y), left + x, top + y);
        }
}

}  // namespace nullscope::test
