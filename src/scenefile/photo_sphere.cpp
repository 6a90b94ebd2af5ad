#include "scenefile/photo_sphere.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/projection.h"

namespace nullscope {

std::string photo_sphere_packet(const CameraSpec& camera) {
    if (camera.projection != Projection::kEquirectangular || !camera.warp.empty() || camera.part ||
        camera.stereo != Stereo::kOff)
        return "";
    const double across = turn_px(camera), down = M_PI / camera.pixel();
    const long long full_width = std::max(std::llround(across), static_cast<long long>(camera.width)),
                    full_height = std::llround(down), spare = full_width - camera.width;
    const auto [ahead, horizon] = line_of_sight(camera);
    const long long turned = std::llround(0.5 * across - ahead), top = std::llround(0.5 * down - horizon),
                    left = turned >= 0 && turned <= spare ? turned : spare / 2;
    if (top < 0 || top + camera.height > full_height) return "";
    return fmt::format(
        "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>"
        "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">"
        "<rdf:Description rdf:about=\"\" xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\" "
        "GPano:UsePanoramaViewer=\"True\" GPano:ProjectionType=\"equirectangular\" "
        "GPano:FullPanoWidthPixels=\"{}\" GPano:FullPanoHeightPixels=\"{}\" "
        "GPano:CroppedAreaImageWidthPixels=\"{}\" GPano:CroppedAreaImageHeightPixels=\"{}\" "
        "GPano:CroppedAreaLeftPixels=\"{}\" GPano:CroppedAreaTopPixels=\"{}\"/></rdf:RDF></x:xmpmeta>"
        "<?xpacket end=\"r\"?>",
        full_width, full_height, camera.width, camera.height, left, top);
}

}  // namespace nullscope
