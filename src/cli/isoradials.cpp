#include "cli/isoradials.h"

#include <fmt/format.h>

#include "reference/isoradial.h"

namespace nullscope::cli {

Result<std::string> isoradials_svg(const Scene& scene) {
    constexpr int kPoints = 720;
    const CameraSpec& camera = scene.camera;
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        camera.width, camera.height);
    for (const int image : {1, 2})
        for (const double r : {3.0, 5.0, 10.0, 15.0}) {
            const auto curve = reference::isoradial(scene, r, image, kPoints);
            if (!curve) return curve.error();
            if (curve->empty()) continue;
            out += fmt::format("<polygon fill=\"none\" stroke-width=\"{}\" stroke=\"{}\" points=\"",
                               image == 1 ? 1.8 : 1.0, image == 1 ? "#c2410c" : "#1d4ed8");
            for (const auto& [x, y] : *curve) out += fmt::format("{:.2f},{:.2f} ", x, y);
            out += "\"/>\n";
            const auto& label = (*curve)[static_cast<std::size_t>(image == 1 ? 3 : 1) * curve->size() / 4];
            if (image == 1)
                out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\" fill=\"#18181b\">{:g} M</text>\n",
                                   label[0] + 4, label[1] - 4, 2 * r);
        }
    out += fmt::format(
        "<text x=\"16\" y=\"28\" font-size=\"16\" fill=\"#18181b\">Isoradials seen from {:.0f} degrees: direct images "
        "(red), second images (blue)</text>\n</svg>\n",
        camera.theta * 180 / M_PI);
    return out;
}

}  // namespace nullscope::cli
