#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "reference/frame_tracer.h"
#include "reference/reference.h"

namespace nullscope::reference {

Result<RayFrame> trace_frame(const Scene& scene, const std::function<void(long long)>& done) {
    auto tracer = FrameTracer::make(scene);
    if (!tracer) return tracer.error();
    const int width = scene.camera.width, height = scene.camera.height;
    RayFrame frame{width, height, std::vector<RayPixel>(static_cast<std::size_t>(width) * height)};
    tbb::parallel_for(tbb::blocked_range<int>(0, height), [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y < rows.end(); ++y) {
            RayPixel* row = frame.pixels.data() + static_cast<std::size_t>(y) * width;
            for (int x = 0; x < width; ++x) row[x] = tracer->pixel(x + 0.5, y + 0.5);
            if (done) done(width);
        }
    });
    return frame;
}

Result<std::vector<RayPixel>> trace_pixels(const Scene& scene, const std::vector<std::array<double, 2>>& positions) {
    auto tracer = FrameTracer::make(scene);
    if (!tracer) return tracer.error();
    for (const auto& position : positions) {
        if (!std::isfinite(position[0]) || !std::isfinite(position[1]))
            return bad_input("pixel positions must be finite");
    }
    std::vector<RayPixel> pixels(positions.size());
    tbb::parallel_for(std::size_t{0}, positions.size(),
                      [&](std::size_t i) { pixels[i] = tracer->pixel(positions[i][0], positions[i][1]); });
    return pixels;
}

}  // namespace nullscope::reference
