// A camera on its way as OpenGL draws it: what a step changes of the sky's directions beyond what it changes of the reference's.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "support/gpu_session.h"

namespace nullscope::test {

struct Jumps {
    double most = 0;  // of a direction, rad
    int fates = 0;    // pixels of another fate
    int judged = 0, skies = 0, not_finite = 0;

    // before: without pixels, only fates are judged.
    void judge(const RayFrame& gl_before, const RayFrame& gl, const RayFrame& exact_before, const RayFrame& exact) {
        constexpr double kWinds = 0.1;  // rad a step: rays that wind turn their sky by more, and nothing follows
        for (std::size_t i = 0; i < gl.pixels.size(); ++i) {
            const RayPixel &p = gl.pixels[i], &q = exact.pixels[i];
            not_finite += !std::isfinite(p.sky.x + p.sky.y + p.sky.z + p.g + p.u + p.v);
            fates += p.fate != q.fate;
            if (p.fate != Fate::kEscaped || q.fate != Fate::kEscaped) continue;
            ++skies;
            if (gl_before.pixels.empty() || gl_before.pixels[i].fate != Fate::kEscaped ||
                exact_before.pixels[i].fate != Fate::kEscaped)
                continue;
            const double step = angle_between(q.sky, exact_before.pixels[i].sky);
            if (step > kWinds) continue;
            ++judged;
            most = std::max(most, angle_between(p.sky, gl_before.pixels[i].sky) - step);
        }
    }
};

// Of the scenes at 0, every, 2 every, ... to steps; far_apart: the steps are too wide for more than fates.
inline Jumps jumps_of(GpuSession& session, int steps, int every, bool far_apart,
                      const std::function<Scene(int)>& scene_at) {
    Jumps jumps;
    RayFrame gl_before, exact_before;
    for (int i = 0; i <= steps; i += every) {
        const Scene scene = scene_at(i);
        RayFrame gl = gl_ray_data(session, scene), exact = reference_frame(scene);
        jumps.judge(gl_before, gl, exact_before, exact);
        if (!far_apart) gl_before = std::move(gl), exact_before = std::move(exact);
    }
    CHECK(jumps.fates == 0);
    CHECK(jumps.not_finite == 0);
    return jumps;
}

// That a case can fail: what it measures if OpenGL drew `there` a step before `here`.
inline double planted_jump(GpuSession& session, const Scene& here, const Scene& there) {
    Jumps planted;
    const RayFrame exact = reference_frame(here);
    planted.judge(gl_ray_data(session, there), gl_ray_data(session, here), exact, exact);
    return planted.most;
}

}  // namespace nullscope::test
