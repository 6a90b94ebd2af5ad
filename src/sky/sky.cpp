#include "sky/sky.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "sky/sky_painter.h"

namespace nullscope {

Mat3 sky_rotation(const SkySpec& spec) {
    const double cy = std::cos(spec.yaw), sy = std::sin(spec.yaw), ct = std::cos(spec.tilt), st = std::sin(spec.tilt);
    return Mat3{{cy, sy, 0}, {-sy, cy, 0}, {0, 0, 1}} * Mat3{{1, 0, 0}, {0, ct, st}, {0, -st, ct}};
}

Result<SkyCube> build_sky(const SkySpec& spec, const std::filesystem::path& assets, int face_size) {
    TRY(painter, SkyPainter::make(spec, assets, face_size, 0));
    return painted_sky(*painter);
}

SkyCube painted_sky(const SkyPainter& painter) {
    constexpr int kRows = 16;  // a task's: the smallest face's all
    SkyCube sky;
    sky.size = painter.face_size();
    sky.notes = painter.notes();
    tbb::parallel_for(std::size_t{0}, sky.faces.size(),
                      [&](std::size_t face) { sky.faces[face] = Image<float>(sky.size, sky.size, 3); });
    tbb::enumerable_thread_specific<SkyRows> scratch;
    const int tasks = sky.size / kRows;
    tbb::parallel_for(0, 6 * tasks, [&](int task) {
        SkyRows& rows = scratch.local();
        painter.paint(task / tasks, task % tasks * kRows, kRows, rows);
        float* out = sky.faces[static_cast<std::size_t>(rows.face)].at(0, rows.first);
        for (std::size_t i = 0; i < rows.texels(); ++i)
            for (const std::vector<float>& plane : rows.planes) *out++ = plane[i];
    });
    return sky;
}

}  // namespace nullscope
