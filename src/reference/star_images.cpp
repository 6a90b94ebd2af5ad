#include "reference/star_images.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "observer/pose.h"
#include "reference/chebyshev.h"
#include "reference/plane_ray.h"
#include "reference/root.h"
#include "reference/seen_light.h"
#include "scene/projection.h"
#include "scene/warp_mesh.h"

namespace nullscope::reference {
namespace {

constexpr int kOrders = 4;  // images that a picture has; the next is e^-pi dimmer, and some pixels of the shadow's rim
constexpr double kStep_px = 1e-3;  // of the view's differences
constexpr int kSamples =
    7680;  // rays that bracket every image: the closer, the fewer are needed to find it; whole numbers a stretch
// A ray's place: minus the logarithm of what its angle is off that of the last ray to the sky, in which the swept angle is smooth. Next to 0
// terms fall as 7^-n on stretches of 1/2: what is swept is odd in alpha, and singular again at minus that ray.
constexpr double kPlaces = 30, kSweptStretch = 0.5;
constexpr double kSettled = 1e-14;  // rad: the last terms
constexpr int kNewtonSteps = 4;     // from within 1/256: 1e-5, 1e-10, and roundings

}  // namespace

double StarImages::swept(double inward) const {
    const auto orbit = tracer_.plane_rays()->orbit_of({-std::cos(inward), std::sin(inward), 0});
    return orbit->fate() == Fate::kEscaped ? orbit->angle() : std::nan("");
}

double StarImages::off(double place) const { return (M_PI - last_) * std::exp(-place); }

StarImages::StarImages(const FrameTracer& tracer, const Scene& scene, int orders)
    : tracer_(tracer), camera_(scene.camera), orders_(orders) {
    double lost = 0, sky = M_PI - 1e-12;  // the last ray that reaches the sky lies between
    if (std::isnan(swept(1e-12))) {
        for (int i = 0; i < 200 && sky - lost > 1e-16 * sky; ++i) {
            const double middle = 0.5 * (sky + lost);
            if (middle <= lost || middle >= sky) break;
            (std::isnan(swept(middle)) ? lost : sky) = middle;
        }
    } else {
        sky = 1e-12;
        orders_ = 1;
    }
    last_ = sky;
    samples_.push_back({0.0, 0.0});
    for (int i = 0; i <= kSamples; ++i) {  // crowded towards the last ray
        const double place = kPlaces * i / kSamples, angle = swept_at(place);
        if (angle > samples_.back().swept) samples_.push_back({place, angle});
    }
    make_stretches();
}

void StarImages::make_stretches() {
    for (double from = 0; from < kPlaces; from += kSweptStretch) {
        Stretch& made = stretches_.emplace_back();
        std::array<double, kTerms> values{};
        for (std::size_t i = 0; i < kTerms; ++i)
            values[i] = swept_at(from + 0.5 * kSweptStretch * (1 + chebyshev_places<kTerms>()[i]));
        made.swept = chebyshev_terms(values), made.slope = chebyshev_slope(made.swept);
        const double rounded = std::numeric_limits<double>::epsilon() * (1 + last_ / off(from + kSweptStretch));
        made.settles = std::abs(made.swept[kTerms - 1]) + std::abs(made.swept[kTerms - 2]) <= kSettled + 8 * rounded;
    }
}

// wanted: between the samples' least and most.
StarImages::Found StarImages::find(double wanted) const {
    const auto next = std::upper_bound(samples_.begin() + 1, samples_.end() - 1, wanted,
                                       [](double w, const Sample& s) { return w < s.swept; });
    const Sample &low = *(next - 1), &high = *next;
    const auto i =
        std::min(static_cast<std::size_t>(0.5 * (low.place + high.place) / kSweptStretch), stretches_.size() - 1);
    const Stretch& stretch = stretches_[i];
    double place = low.place + (high.place - low.place) * (wanted - low.swept) / (high.swept - low.swept), slope = 0;
    const auto in_stretch = [&] { return 2 * (place / kSweptStretch - static_cast<double>(i)) - 1; };
    if (stretch.settles) {
        for (int step = 0; step < kNewtonSteps; ++step) {
            slope = chebyshev_sum(stretch.slope, in_stretch()) * 2 / kSweptStretch;
            place = std::clamp(place - (chebyshev_sum(stretch.swept, in_stretch()) - wanted) / slope, low.place,
                               high.place);
        }
    } else {
        place = root_of([&](double at) { return swept_at(at) - wanted; }, low.place, high.place, low.swept - wanted,
                        high.swept - wanted, 50);
        const double step = 0.1 * (high.place - low.place);
        slope = (swept_at(place + step) - swept_at(place - step)) / (2 * step);
    }
    return {last_ + off(place), -(M_PI - last_) * std::expm1(-place), slope / off(place)};
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
        const Found found = find(wanted);
        const double sine = found.alpha < 1 ? std::sin(found.alpha) : std::sin(found.inward),
                     side = (odd ? -1 : 1) * sine / std::max(across, 1e-300),
                     sky_per_view = std::abs((sine > 0 ? across / sine : found.slope) * found.slope);
        const auto position = tracer_.plane_rays()->position({-std::cos(found.inward), side * local.y, side * local.z});
        if (!position) continue;
        const double turn = turn_px(camera_);
        add_image((*position)[0], (*position)[1], order, margin_px, sky_per_view, images);
        for (const double by : {-turn, turn})
            if (turn > 0) add_image((*position)[0] + by, (*position)[1], order, margin_px, sky_per_view, images);
    }
    return images;
}

// If the picture shows it, or its margin does. sky_per_view: of solid angles.
void StarImages::add_image(double x, double y, int order, double margin_px, double sky_per_view,
                           std::vector<StarImage>& images) const {
    if (!(x > -margin_px && x < camera_.width + margin_px && y > -margin_px && y < camera_.height + margin_px)) return;
    const auto view = [&](double dx, double dy) {
        return tracer_.plane_rays()->view(pixel_direction(camera_, x + dx, y + dy));
    };
    const Vec3 by_x = (view(kStep_px, 0) - view(-kStep_px, 0)) / (2 * kStep_px),
               by_y = (view(0, kStep_px) - view(0, -kStep_px)) / (2 * kStep_px);
    const double solid_angle = length(cross(by_x, by_y)) * sky_per_view;
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
            if (!projection_of(scene.camera).faces) continue;
            for (int other = 0; other < kFacesOfCube; ++other)  // the rim of its light on the faces beside it
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
