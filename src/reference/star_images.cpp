#include "reference/star_images.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "observer/pose.h"
#include "reference/root.h"
#include "reference/seen_light.h"
#include "scene/projection.h"
#include "scene/warp_mesh.h"

namespace nullscope::reference {
namespace {

constexpr int kOrders = 4;  // images that a picture has; the next is e^-pi dimmer, and some pixels of the shadow's rim
constexpr double kStep_px = 1e-3;  // of the Jacobian's differences
constexpr int kSamples = 8000;     // rays that bracket every image: the closer, the fewer are needed to find it

}  // namespace

double StarImages::swept(double alpha) const {
    const auto orbit = tracer_.plane_rays()->orbit_of({std::cos(alpha), std::sin(alpha), 0});
    return orbit->fate() == Fate::kEscaped ? orbit->angle() : std::nan("");
}

StarImages::StarImages(const FrameTracer& tracer, const Scene& scene, int orders)
    : tracer_(tracer), camera_(scene.camera), orders_(orders) {
    double sky = 1e-12, lost = M_PI;  // the last ray that reaches the sky lies between
    if (std::isnan(swept(M_PI - 1e-12))) {
        for (int i = 0; i < 200 && lost - sky > 1e-16 * lost; ++i) {
            const double middle = 0.5 * (sky + lost);
            (std::isnan(swept(middle)) ? lost : sky) = middle;
        }
    } else {
        sky = M_PI - 1e-12;
        orders_ = 1;
    }
    samples_.push_back({0.0, 0.0});
    for (int i = 0; i <= kSamples; ++i) {  // crowded towards the last ray
        const double alpha = sky * (1 - std::pow(10.0, -13.0 * i / kSamples)), angle = swept(alpha);
        if (angle > samples_.back().swept) samples_.push_back({alpha, angle});
    }
}

std::vector<StarImage> StarImages::of(Vec3 direction, double margin_px) const {
    const Mat3 axes = world_from_static(camera_.theta, camera_.phi);
    const Vec3 local{dot(direction, axes.a), dot(direction, axes.b), dot(direction, axes.c)};
    const double across = std::hypot(local.y, local.z), theta = std::atan2(across, local.x);
    std::vector<StarImage> images;
    for (int order = 0; order < orders_; ++order) {
        const bool odd = order % 2 == 1;
        const double wanted = odd ? (order + 1) * M_PI - theta : order * M_PI + theta;
        if (!(wanted < samples_.back().swept)) break;
        const auto next = std::upper_bound(samples_.begin() + 1, samples_.end() - 1, wanted,
                                           [](double w, const Sample& s) { return w < s.swept; });
        const double alpha = root_of([&](double a) { return swept(a) - wanted; }, (next - 1)->alpha, next->alpha,
                                     (next - 1)->swept - wanted, next->swept - wanted, 50),
                     side = (odd ? -1 : 1) * std::sin(alpha) / std::max(across, 1e-300);
        const auto position = tracer_.plane_rays()->position({std::cos(alpha), side * local.y, side * local.z});
        if (!position) continue;
        const double turn = turn_px(camera_);
        add_image((*position)[0], (*position)[1], order, margin_px, images);
        for (const double by : {-turn, turn})
            if (turn > 0) add_image((*position)[0] + by, (*position)[1], order, margin_px, images);
    }
    return images;
}

// If the picture shows it, or its margin does.
void StarImages::add_image(double x, double y, int order, double margin_px, std::vector<StarImage>& images) const {
    if (!(x > -margin_px && x < camera_.width + margin_px && y > -margin_px && y < camera_.height + margin_px)) return;
    const auto sky = [&](double dx, double dy) { return tracer_.ray(x + dx, y + dy)->end_direction(); };
    const Vec3 by_x = (sky(kStep_px, 0) - sky(-kStep_px, 0)) / (2 * kStep_px),
               by_y = (sky(0, kStep_px) - sky(0, -kStep_px)) / (2 * kStep_px);
    const double solid_angle = length(cross(by_x, by_y));
    if (std::isfinite(solid_angle) && solid_angle > 0)
        images.push_back({x, y, order, solid_angle, tracer_.ray(x, y)->g});
}

Vec3 star_light(const PointStar& star, double g, const LightSpec& light) {
    return star.flux * std::exp2(-seen_log2_brightness(star.temperature_K, light.bolometric)) *
           seen_black_body(star.temperature_K, g, light);
}

std::function<std::vector<StarImage>(Vec3)> images_of(const FrameTracer& tracer, const Scene& scene) {
    if (tracer.plane_rays())
        return [images = std::make_shared<StarImages>(tracer, scene, kOrders)](Vec3 star) {
            return images->of(star, kPointMargin_px);
        };
    return images_by_mesh(tracer, scene, kPointMargin_px);
}

void add_point_stars(const FrameTracer& tracer, const Scene& scene, const std::vector<PointStar>& stars,
                     const std::function<double(double x, double y)>& transmission, Image<float>& picture) {
    struct Spot {
        double x, y;
        Vec3 peak;
        int face;
    };
    const auto images = images_of(tracer, scene);
    std::vector<std::vector<Spot>> spots(stars.size());
    tbb::parallel_for(std::size_t{0}, stars.size(), [&](std::size_t i) {
        for (const StarImage& image : images(stars[i].direction)) {
            const double dimmed = warp_light(scene.camera, image.x, image.y),
                         through = dimmed > 0.0 ? dimmed * transmission(image.x, image.y) : 0.0;
            if (!(through > 0)) continue;
            const Vec3 peak = point_peak() * through / image.solid_angle * star_light(stars[i], image.g, scene.light);
            const int face = cube_face(scene.camera, image.x, image.y);
            spots[i].push_back({image.x, image.y, peak, face});
            if (scene.camera.projection != Projection::kCube) continue;
            for (int other = 0; other < 6; ++other)  // the rim of its light on the faces beside it
                if (const auto seen =
                        pixel_on_face(scene.camera, other, pixel_direction(scene.camera, image.x, image.y));
                    seen && other != face)
                    spots[i].push_back({(*seen)[0], (*seen)[1], peak, other});
        }
    });
    constexpr int kReach = 6;  // px: 8 sigma
    for (const auto& list : spots)
        for (const Spot& spot : list)
            for (int row = std::max(0, static_cast<int>(std::fmin(spot.y, 1e6)) - kReach);
                 row < std::min(picture.height, static_cast<int>(spot.y) + kReach + 1); ++row)
                for (int column = std::max(0, static_cast<int>(std::fmin(spot.x, 1e6)) - kReach);
                     column < std::min(picture.width, static_cast<int>(spot.x) + kReach + 1); ++column) {
                    if (!shows(scene.camera, column + 0.5, row + 0.5) ||
                        cube_face(scene.camera, column + 0.5, row + 0.5) != spot.face)
                        continue;
                    const double dx = column + 0.5 - spot.x, dy = row + 0.5 - spot.y;
                    const double share = std::exp(-(dx * dx + dy * dy) / (2 * kPointSigma_px * kPointSigma_px));
                    float* pixel = picture.at(column, row);
                    pixel[0] += static_cast<float>(share * spot.peak.x);
                    pixel[1] += static_cast<float>(share * spot.peak.y);
                    pixel[2] += static_cast<float>(share * spot.peak.z);
                }
}

}  // namespace nullscope::reference
