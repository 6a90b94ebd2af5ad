#include "gradient/picture_flux.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

constexpr double kClosest = 1e-5;        // of the critical curve's distance, where images are still looked for
constexpr double kGrowth = 2.0;          // from look to look, away from that curve
constexpr std::size_t kWholeOrders = 2;  // images that are cut at all marks; the next at their rims
constexpr int kMostCutTries = 60;
constexpr double kCutFound = 1e-7;  // of a bracket: Newton's next step is at rounding
constexpr double kThin = 0.02;      // of the critical curve's distance: pieces that need half of the places

double luminance_of_light(const Vec3& light) {
    return 0.2126390059 * light.x + 0.7151686788 * light.y + 0.0721923154 * light.z;
}

// A distance from the spoke's beginning, px, and how keys move it.
struct Cut {
    double rho;
    std::vector<double> by;
};

class Spoke {
public:
    Spoke(const PictureLight& light, const SpokedPicture& picture, double angle)
        : light_(light),
          from_(picture.from),
          x_(std::cos(angle)),
          y_(std::sin(angle)),
          end_(to_edge(picture, x_, y_)) {}

    // Added to flux and by: the integral of luminance rho drho. thin: the rule of thin pieces.
    void add(const LegendreRule& rule, const LegendreRule& thin, FluxGradient& sum) {
        const std::vector<Cut> ends = cuts();
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            if (shines(0.5 * (ends[i].rho + ends[i + 1].rho)))
                add_piece(ends[i + 1].rho - ends[i].rho < kThin * critical_ ? thin : rule, ends[i], ends[i + 1], sum);
        sum.rays += rays_;
    }

private:
    PictureLight::Ray at(double rho) {
        ++rays_;
        return light_.at(from_[0] + rho * x_, from_[1] + rho * y_, x_, y_);
    }
    bool falls_in(double rho) const { return light_.falls_in(from_[0] + rho * x_, from_[1] + rho * y_); }
    bool shines(double rho) {
        const PictureLight::Ray ray = at(rho);
        const DiscSpec& disc = *light_.scene().disc;
        return std::ranges::any_of(ray.crossings, [&](const PictureLight::Crossing& crossing) {
            return crossing.r >= disc.inner && crossing.r <= disc.outer;
        });
    }
    double critical() const;
    std::vector<double> looks() const;
    std::vector<Cut> cuts();
    Cut cut_between(double low, double high, std::size_t order, const LightMark& mark);
    double over(const PictureLight::Ray& ray, double rho, std::size_t order, double radius) const;
    void add_piece(const LegendreRule& rule, const Cut& low, const Cut& high, FluxGradient& sum);

    const PictureLight& light_;
    std::array<double, 2> from_;
    double x_, y_, end_, critical_ = 0;
    long rays_ = 0;
};

// 0: nothing falls in. Beyond the end where all does.
double Spoke::critical() const {
    if (!light_.has_horizon()) return 0;
    return critical_distance([this](double rho) { return falls_in(rho); }, end_);
}

// On both sides of the critical curve, at distances that grow as images do.
std::vector<double> Spoke::looks() const {
    std::vector<double> at = {0, end_};
    const double size = critical_ > 0 ? critical_ : end_;
    for (double off = kClosest * size; off < std::max(critical_, end_); off *= kGrowth)
        for (const double rho : {critical_ - off, critical_ + off})
            if (rho > 0 && rho < end_) at.push_back(rho);
    std::ranges::sort(at);
    return at;
}

// The crossing's radius over the mark's: what falls in has its missing crossings within the horizon, what leaves has them far out.
double Spoke::over(const PictureLight::Ray& ray, double rho, std::size_t order, double radius) const {
    if (order < ray.crossings.size()) return ray.crossings[order].r - radius;
    return rho < critical_ ? -radius : radius;
}

std::vector<Cut> Spoke::cuts() {
    critical_ = critical();
    const std::vector<double> places = looks();
    std::vector<PictureLight::Ray> rays;
    rays.reserve(places.size());
    for (const double rho : places) rays.push_back(at(rho));
    const std::vector<double> still(light_.keys().size(), 0.0);
    std::vector<Cut> found = {{0, still}, {end_, still}};
    const std::vector<LightMark> all = light_.marks(), rims = {all.front(), all.back()};
    for (std::size_t order = 0; order < PictureLight::kOrders; ++order)
        for (const LightMark& mark : order < kWholeOrders ? all : rims)
            for (std::size_t i = 0; i + 1 < places.size(); ++i)
                if ((over(rays[i], places[i], order, mark.value) > 0) !=
                    (over(rays[i + 1], places[i + 1], order, mark.value) > 0))
                    found.push_back(cut_between(places[i], places[i + 1], order, mark));
    std::ranges::sort(found, {}, &Cut::rho);
    return found;
}

// Newton's steps within a bracket.
Cut Spoke::cut_between(double low, double high, std::size_t order, const LightMark& mark) {
    const double width = high - low;
    const bool grows = over(at(high), high, order, mark.value) > 0;
    double rho = 0.5 * (low + high);
    PictureLight::Ray ray;
    for (int tries = 0; tries < kMostCutTries; ++tries) {
        ray = at(rho);
        const double off = over(ray, rho, order, mark.value);
        ((off > 0) == grows ? high : low) = rho;
        const bool there = order < ray.crossings.size();
        const double next = there ? rho - off / ray.crossings[order].along : low;
        if (there && std::fabs(next - rho) < kCutFound * width) break;
        rho = there && next > low && next < high ? next : 0.5 * (low + high);
    }
    Cut cut{rho, std::vector<double>(light_.keys().size(), 0.0)};
    if (order >= ray.crossings.size()) return cut;
    const std::vector<double> moves = light_.mark_by(mark);
    for (std::size_t key = 0; key < moves.size(); ++key)
        cut.by[key] = (moves[key] - ray.crossings[order].by[key]) / ray.crossings[order].along;
    return cut;
}

void Spoke::add_piece(const LegendreRule& rule, const Cut& low, const Cut& high, FluxGradient& sum) {
    const double width = high.rho - low.rho;
    for (std::size_t i = 0; i < rule.at.size(); ++i) {
        const double part = rule.at[i], rho = low.rho + part * width, share = rule.weight[i];
        const PictureLight::Ray ray = at(rho);
        const double light = luminance_of_light(ray.light), along = luminance_of_light(ray.along);
        sum.flux += share * width * rho * light;
        for (std::size_t key = 0; key < sum.by.size(); ++key) {
            const double moved = low.by[key] + part * (high.by[key] - low.by[key]), wider = high.by[key] - low.by[key];
            sum.by[key] += share * (wider * rho * light + width * moved * light +
                                    width * rho * (luminance_of_light(ray.by[key]) + along * moved));
        }
    }
}

}  // namespace

Result<FluxGradient> flux_gradient(const PictureLight& light, const FluxRule& rule,
                                   const std::function<void(double)>& done) {
    TRY(picture, picture_about_hole(light.scene().camera, light.view()));
    const LegendreRule along(rule.places), thin((rule.places + 1) / 2);
    const SpokeSum spoke = [&](double angle, FluxGradient& sum) {
        Spoke(light, *picture, angle).add(along, thin, sum);
    };
    return sum_of_spokes(*picture, light.keys().size(), rule.tolerance, spoke, done);
}

}  // namespace nullscope
