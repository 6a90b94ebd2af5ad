#include "against_reference.h"

#include <algorithm>

namespace nullscope::test {

std::optional<RayMeasures> AgainstReference::frame(GpuSession& session, const std::string& name, const Scene& scene,
                                                   int row_step) {
    CAPTURE(name);
    drawn_ = gl_ray_data(session, scene, row_step);
    if (measured_.known(name, drawn_)) return {};
    const ExactTrace trace = promise_.which ? remembered(reference_trace(scene)) : reference_trace(scene);
    RayMeasures m = measure_rays(drawn_, scene.camera, trace, row_step, promise_.refine_above_px);
    const double finer = promise_.of_width > 0 ? promise_.of_width / scene.camera.width : 1;
    std::string line = fmt::format("{:<7} {}, {}:", session.context->kind(), topic_, name);
    const struct {
        const char* channel;
        const Spread& off;
        double most;
    } channels[] = {{"sky", m.sky_px, promise_.sky},
                    {"place", m.place_px, promise_.place},
                    {"swept", m.angle_px, promise_.swept},
                    {"g", m.g_px, promise_.g}};
    for (const auto& one : channels) {
        CAPTURE(one.channel);
        const double most = finer * one.off.max;
        if (one.off.count > 0)
            line += fmt::format(" {} {:.1e} / {:.1e} / {:.1e}", one.channel, most, finer * one.off.p999,
                                finer * one.off.median);
        CHECK(most <= one.most);
    }
    fmt::print("{} px (max / 99.9 % / median); {} skies, {} hits, fate errors {}, forgiven {}\n", line, m.sky_px.count,
               m.place_px.count, m.fate_errors, m.forgiven);
    CHECK(m.fate_errors == 0);
    CHECK(m.not_finite == 0);
    CHECK(m.sky_px.count >= promise_.least_skies);
    CHECK(m.place_px.count >= promise_.least_hits);
    if (promise_.which) {
        const RayFrame exact = exact_frame(scene.camera, trace);
        long long others = 0;
        for (std::size_t i = 0; i < exact.pixels.size(); ++i) others += exact.pixels[i].hit != drawn_.pixels[i].hit;
        CHECK(others <= m.forgiven);
    }
    return m;
}

void AgainstReference::frames(GpuSession& session, Selection selection, const std::vector<FrameCase>& cases) {
    for (const auto& [name, scene] : cases)
        if (selection.takes_next()) frame(session, name, scene);
}

Apart apart(const RayFrame& one, const RayFrame& other, const CameraSpec& camera) {
    Apart result;
    const double pixel = camera.plane_width / 1920, finer = 1920.0 / camera.width;
    for (int y = 1; y + 1 < one.height; ++y)
        for (int x = 1; x + 1 < one.width; ++x) {
            const RayPixel &a = one.at(x, y), &b = other.at(x, y), &right = one.at(x + 1, y), &down = one.at(x, y + 1);
            result.fates += a.fate != b.fate;
            if (a.fate != Fate::kEscaped || b.fate != a.fate || right.fate != a.fate || down.fate != a.fate) continue;
            const double sway = std::max(
                {length(right.sky - a.sky) / (finer * pixel), length(down.sky - a.sky) / (finer * pixel), 1.0});
            result.most_px = std::max(result.most_px, length(a.sky - b.sky) / sway / pixel);
            ++result.skies;
        }
    return result;
}

}  // namespace nullscope::test
