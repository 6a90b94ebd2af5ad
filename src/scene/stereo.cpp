#include "scene/stereo.h"

#include <algorithm>
#include <cmath>

#include "scene/projection.h"

namespace nullscope {
namespace {

constexpr int kMargin_px = 2;  // about a strip: the neighbours that edges are found by

void append_strips(const CameraSpec& whole, EyeSide side, int top, std::vector<EyePart>& parts) {
    for (int left = 0; left < whole.width; left += kStrip_px) {
        const int right = std::min(left + kStrip_px, whole.width), from = std::max(left - kMargin_px, 0),
                  to = std::min(right + kMargin_px, whole.width);
        EyePart part{whole, eye_offset(whole, side, 0.5 * (left + right)), left - from, right - left, left, top};
        part.camera.part = PicturePart{from, 0, whole.width, whole.height};
        part.camera.width = to - from;
        parts.push_back(part);
    }
}

}  // namespace

std::array<int, 2> stereo_size(const CameraSpec& camera) {
    return {camera.width * (camera.stereo == Stereo::kPair ? 2 : 1),
            camera.height * (camera.stereo == Stereo::kAllRound ? 2 : 1)};
}

double seam_px(const CameraSpec& camera, double distance) {
    return 0.5 * camera.eye_distance * kStrip_px * camera.pixel_aspect / distance;
}

Vec3 eye_offset(const CameraSpec& camera, EyeSide side, double x) {
    const double half = (side == EyeSide::kLeft ? -0.5 : 0.5) * camera.eye_distance;
    if (camera.stereo != Stereo::kAllRound) return {half, 0, 0};
    const double longitude = (x - line_of_sight(camera)[0]) * camera.pixel_aspect * camera.pixel();
    return {half * std::cos(longitude), 0, half * std::sin(longitude)};
}

std::vector<EyePart> eye_parts(const CameraSpec& camera) {
    std::vector<EyePart> parts;
    for (const EyeSide side : {EyeSide::kLeft, EyeSide::kRight}) {
        const bool right = side == EyeSide::kRight;
        if (camera.stereo == Stereo::kPair)
            parts.push_back({camera, eye_offset(camera, side, 0), 0, camera.width, right ? camera.width : 0, 0});
        else
            append_strips(camera, side, right ? camera.height : 0, parts);
    }
    for (EyePart& part : parts) part.camera.stereo = Stereo::kOff;
    return parts;
}

}  // namespace nullscope
