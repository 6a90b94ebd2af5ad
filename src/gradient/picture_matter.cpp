#include "gradient/picture_matter.h"

#include <algorithm>
#include <cmath>

#include "gradient/picture_light.h"
#include "gradient/ray_gradient.h"
#include "plan/medium.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

constexpr double kNearestPiece = 1e-4;  // of the critical curve's distance, where the last piece ends
constexpr double kPieceGrowth = 3.0;    // from piece to piece, away from that curve
constexpr int kFaintPlaces = 4;         // along a side, whose light says what is faint

double luminance_of(const Vec3& light) {
    return 0.2126390059 * light.x + 0.7151686788 * light.y + 0.0721923154 * light.z;
}

}  // namespace

Result<std::unique_ptr<PictureMatter>> PictureMatter::make(const Scene& scene, const std::vector<std::string>& keys) {
    std::unique_ptr<PictureMatter> light(new PictureMatter);
    light->scene_ = scene;
    TRY(flow, flow_of(scene.spacetime));
    light->flow_ = std::move(*flow);
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    TRY(good, check_medium(**spacetime, scene));
    TRY(glow, MatterGlow::make(scene, *light->flow_));
    light->glow_ = std::move(*glow);
    TRY(parameters, parse_parameters(keys, scene, DerivativesOf::kLight));
    light->parameters_ = std::move(*parameters);
    TRY(view, CameraView::make(light->scene_, *light->flow_));
    light->view_ = *view;
    light->unit_ = scene.medium->brightness * luminance_of(scene.medium->colour);
    return light;
}

bool PictureMatter::falls_in(double x, double y) const { return ray_survey(*flow_, view_->seen(x, y).launch).falls_in; }

Change PictureMatter::change(const Parameter& key, const CameraView::Seen& seen) const {
    Change change = view_->change(key.kind, seen);
    change.seeds[kSeedMatterShift] = change.seeds[kSeedShift];
    return change;
}

std::vector<double> PictureMatter::critical_by(double x, double y, double along_x, double along_y) const {
    const CameraView::Seen seen = view_->seen(x, y);
    const RayGradient found = ray_survey(*flow_, seen.launch);
    std::vector<double> by(parameters_.size(), 0.0);
    if (!found.clearance) return by;
    // No part of it depends on the matter.
    Number clearance = *found.clearance;
    clearance.d[kSeedMatterShift] = clearance.d[kSeedMatterTurn] = 0;
    const double along = derivative(clearance, view_->moved(seen, x, y, along_x, along_y));
    for (std::size_t i = 0; i < by.size(); ++i) by[i] = -derivative(clearance, change(parameters_[i], seen)) / along;
    return by;
}

PictureMatter::Ray PictureMatter::at(double x, double y, double along_x, double along_y, double faint) const {
    const CameraView::Seen seen = view_->seen(x, y);
    Number shift = seen.shift;
    shift.d[kSeedMatterShift] += shift.value;
    MatterRule rule;
    rule.faint = unit_ > 0 ? faint / unit_ : 0;
    const Number light = unit_ * matter_along(*flow_, *glow_, seen.launch, shift, rule).light;
    Ray ray{light.value, derivative(light, view_->moved(seen, x, y, along_x, along_y)), {}};
    for (const Parameter& key : parameters_) ray.by.push_back(derivative(light, change(key, seen)));
    return ray;
}

namespace {

// Pieces of [0, 1]: from the critical curve, where it is 0, to the spoke's end.
std::vector<double> pieces(double closest) {
    std::vector<double> ends = {1};
    while (ends.back() > closest) ends.push_back(ends.back() / kPieceGrowth);
    ends.push_back(0);
    std::ranges::reverse(ends);
    return ends;
}

class MatterSpoke {
public:
    MatterSpoke(const PictureMatter& light, const SpokedPicture& picture, double angle, double faint)
        : light_(light),
          from_(picture.from),
          x_(std::cos(angle)),
          y_(std::sin(angle)),
          end_(to_edge(picture, x_, y_)),
          faint_(faint) {}

    void add(const LegendreRule& rule, FluxGradient& sum) const {
        const double critical = critical_distance(
            [&](double rho) { return light_.falls_in(from_[0] + rho * x_, from_[1] + rho * y_); }, end_);
        if (critical > end_) {  // the curve is not in the picture, nor does its edge move
            const Side side{end_, -end_, std::vector<double>(light_.keys().size(), 0.0)};
            return add_side(rule, side, pieces(kPieceGrowth), sum);
        }
        const auto moves = light_.critical_by(from_[0] + critical * x_, from_[1] + critical * y_, x_, y_);
        add_side(rule, {critical, -critical, moves}, pieces(kNearestPiece), sum);
        const double beyond = end_ - critical;
        if (beyond > 0) add_side(rule, {critical, beyond, moves}, pieces(kNearestPiece * critical / beyond), sum);
    }

private:
    // From the curve, which moves, to what stays: places are begin + part length.
    struct Side {
        double begin, length;
        std::vector<double> by;  // of the beginning
    };
    void add_side(const LegendreRule& rule, const Side& side, const std::vector<double>& ends,
                  FluxGradient& sum) const {
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            for (std::size_t k = 0; k < rule.at.size(); ++k) {
                const double width = ends[i + 1] - ends[i];
                add_place(side, ends[i] + rule.at[k] * width, rule.weight[k] * width, sum);
            }
    }
    void add_place(const Side& side, double part, double share, FluxGradient& sum) const {
        const double rho = side.begin + part * side.length, length = std::fabs(side.length);
        const auto ray = light_.at(from_[0] + rho * x_, from_[1] + rho * y_, x_, y_, faint_);
        ++sum.rays;
        sum.flux += share * length * rho * ray.light;
        for (std::size_t key = 0; key < sum.by.size(); ++key) {
            const double moved = (1 - part) * side.by[key], longer = side.length < 0 ? side.by[key] : -side.by[key];
            sum.by[key] += share * (longer * rho * ray.light + length * moved * ray.light +
                                    length * rho * (ray.by[key] + ray.along * moved));
        }
    }

    const PictureMatter& light_;
    std::array<double, 2> from_;
    double x_, y_, end_, faint_;
};

// The mean of some places' light.
double mean_light(const PictureMatter& light, const CameraSpec& camera) {
    double sum = 0;
    for (int row = 0; row < kFaintPlaces; ++row)
        for (int column = 0; column < kFaintPlaces; ++column) {
            const double x = (column + 0.5) / kFaintPlaces, y = (row + 0.5) / kFaintPlaces;
            sum += light.at(x * camera.width, y * camera.height, 1, 0).light / (kFaintPlaces * kFaintPlaces);
        }
    return sum;
}

}  // namespace

Result<FluxGradient> flux_gradient(const PictureMatter& light, const MatterFluxRule& rule,
                                   const std::function<void(double)>& done) {
    TRY(picture, picture_about_hole(light.scene().camera, light.view()));
    const LegendreRule along(rule.places);
    const double faint = mean_light(light, light.scene().camera);
    const SpokeSum spoke = [&](double angle, FluxGradient& sum) {
        MatterSpoke(light, *picture, angle, faint).add(along, sum);
    };
    return sum_of_spokes(*picture, light.keys().size(), rule.tolerance, spoke, done);
}

}  // namespace nullscope
