#include "scenefile/photo_sphere.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/projection.h"
#include "scene/stereo.h"

namespace nullscope {

namespace {

// px, of a panorama all round and of the picture in it.
struct SpherePart {
    long long full_width, full_height, left, top;
};

std::optional<SpherePart> sphere_part(const CameraSpec& camera) {
    if (camera.projection != Projection::kEquirectangular || !camera.warp.empty() || camera.part) return {};
    const double across = turn_px(camera), down = M_PI / camera.pixel();
    const long long full_width = std::max(std::llround(across), static_cast<long long>(camera.width)),
                    full_height = std::llround(down), spare = full_width - camera.width;
    const auto [ahead, horizon] = line_of_sight(camera);
    const long long turned = std::llround(0.5 * across - ahead), top = std::llround(0.5 * down - horizon),
                    left = turned >= 0 && turned <= spare ? turned : spare / 2;
    if (top < 0 || top + camera.height > full_height) return {};
    return SpherePart{full_width, full_height, left, top};
}

}  // namespace

std::string photo_sphere_packet(const CameraSpec& camera) {
    const auto part = sphere_part(camera);
    if (!part || camera.stereo != Stereo::kOff) return "";
    return fmt::format(
        "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>"
        "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">"
        "<rdf:Description rdf:about=\"\" xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\" "
        "GPano:UsePanoramaViewer=\"True\" GPano:ProjectionType=\"equirectangular\" "
        "GPano:FullPanoWidthPixels=\"{}\" GPano:FullPanoHeightPixels=\"{}\" "
        "GPano:CroppedAreaImageWidthPixels=\"{}\" GPano:CroppedAreaImageHeightPixels=\"{}\" "
        "GPano:CroppedAreaLeftPixels=\"{}\" GPano:CroppedAreaTopPixels=\"{}\"/></rdf:RDF></x:xmpmeta>"
        "<?xpacket end=\"r\"?>",
        part->full_width, part->full_height, camera.width, camera.height, part->left, part->top);
}

std::optional<FilmSphere> film_sphere(const CameraSpec& camera) {
    const auto part = sphere_part(camera);
    if (!part) return {};
    const auto [all_across, all_down] = stereo_size(camera);
    // An odd size loses its last column or row.
    const long long right = part->full_width - part->left - camera.width + all_across % 2,
                    bottom = part->full_height - part->top - camera.height + all_down % 2;
    const auto share = [](long long px, long long of) { return static_cast<double>(px) / static_cast<double>(of); };
    return FilmSphere{camera.stereo == Stereo::kOff        ? FilmEyes::kOne
                      : camera.stereo == Stereo::kAllRound ? FilmEyes::kLeftAbove
                                                           : FilmEyes::kLeftBeside,
                      share(part->top, part->full_height), share(bottom, part->full_height),
                      share(part->left, part->full_width), share(right, part->full_width)};
}

}  // namespace nullscope
