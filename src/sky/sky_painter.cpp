#include "sky/sky_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "sky/sky.h"

namespace nullscope {
namespace {

constexpr int kMinFaceSize = 16, kMaxFaceSize = 8192;

}  // namespace

Result<SkyPainter> SkyPainter::make(const SkySpec& spec, const std::filesystem::path& assets, int face_size,
                                    int border) {
    if (face_size < kMinFaceSize || face_size > kMaxFaceSize || !std::has_single_bit(static_cast<unsigned>(face_size)))
        return bad_input(
            fmt::format("sky: face size {} is not a power of two in [{}, {}]", face_size, kMinFaceSize, kMaxFaceSize));
    SkyPainter painter;
    painter.size_ = face_size;
    painter.border_ = border;
    const Mat3 world_from_sky = sky_rotation(spec);
    if (spec.kind == SkyKind::kStars) {
        TRY(stars, load_stars(spec.catalogue, assets));
        painter.stars_.emplace(*stars, world_from_sky, spec.brightness, face_size, border);
    }
    if (spec.kind == SkyKind::kStars || spec.kind == SkyKind::kPoints) {
        TRY(haze, MilkyWay::load(assets / "sky" / "milky-way.jpg", world_from_sky, spec.brightness, face_size, border));
        painter.haze_.emplace(std::move(*haze));
    }
    if (spec.kind == SkyKind::kNebula) {
        painter.nebula_.emplace(spec.nebula, world_from_sky, spec.brightness, face_size, border);
        painter.stars_.emplace(painter.nebula_->stars(), world_from_sky, spec.brightness, face_size, border);
    }
    if (spec.kind == SkyKind::kImage) {
        TRY(image, Panorama::load(spec, world_from_sky, face_size));
        painter.image_ = std::move(*image);
    }
    return painter;
}

void SkyPainter::paint(int face, int first, int count, SkyRows& rows) const {
    rows.face = face, rows.size = size_, rows.border = border_, rows.first = first, rows.count = count;
    for (std::vector<float>& plane : rows.planes)
        plane.resize(rows.texels());  // no page is touched anew for rows of the same size
    if (haze_)
        haze_->paint(rows);
    else if (nebula_)
        nebula_->paint(rows);
    else if (image_)
        image_->paint(rows);
    else
        for (std::vector<float>& plane : rows.planes) std::fill(plane.begin(), plane.end(), 0.0f);
    if (stars_) stars_->add(rows);
}

}  // namespace nullscope
