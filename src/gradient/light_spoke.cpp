#include "gradient/light_spoke.h"

#include <algorithm>
#include <cmath>

namespace nullscope {
namespace {

constexpr double kClosest = 1e-5;  // of the critical curve's distance, where images are still looked for
constexpr double kGrowth = 3.0;    // from look to look, away from that curve
constexpr std::size_t kWholeOrders =
    3;  // images that are cut at all marks, with all places; the next at its rims, with half of them
constexpr int kMostCutTries = 60;
constexpr double kCutFound = 1e-6;  // of a bracket: what keys move it by is that of a place so near

constexpr int kOwnCircle = 8;       // power of the part of a piece, by which circles move as its other end does
constexpr double kDim = 0.02;       // of the disc's largest emissivity: pieces that need half of the places
constexpr double kThinDisc = 0.01;  // opacity of discs whose rims are not seen in what shines through them

// A distance from the spoke's beginning, px, and how keys move it.
struct Cut {
    double rho;
    int name;  // of what is there
    std::vector<double> by;
    std::vector<double> mark_by{};  // how keys move the radius there, of this image's own cuts
};

// Derivatives at nodes of a rule on [0, 1], of what has these values at 0, there, and at 1: of the polynomial through all (H. E. Salzer, Comput. J. 15, 156
// (1972)).
std::vector<double> slopes_of(const LegendreRule& rule, const std::vector<double>& values) {
    std::vector<double> at = {0};
    at.insert(at.end(), rule.at.begin(), rule.at.end());
    at.push_back(1);
    std::vector<double> weight(at.size(), 1.0);
    for (std::size_t i = 0; i < at.size(); ++i)
        for (std::size_t j = 0; j < at.size(); ++j)
            if (j != i) weight[i] /= at[i] - at[j];
    std::vector<double> slopes;
    for (std::size_t i = 1; i + 1 < at.size(); ++i) {
        double slope = 0;
        for (std::size_t j = 0; j < at.size(); ++j)
            if (j != i) slope += weight[j] / weight[i] * (values[j] - values[i]) / (at[i] - at[j]);
        slopes.push_back(slope);
    }
    return slopes;
}

struct Motion {
    std::vector<double> moved, wider;
};

class Spoke {
public:
    Spoke(const PictureLight& light, const std::array<double, 2>& from, double angle, double end, LightSpoke& spoke)
        : light_(light), from_(from), x_(std::cos(angle)), y_(std::sin(angle)), end_(end), spoke_(spoke) {}

    void trace(const LegendreRule& rule, const LegendreRule& thin) {
        look();
        const std::vector<double> still = still_by();
        std::vector<Cut> before;  // of images in front of this
        for (std::size_t order = 0; order < PictureLight::kOrders; ++order) {
            const std::vector<Cut> own = cuts_of(order);
            std::vector<Cut> ends = before;
            ends.insert(ends.end(), own.begin(), own.end());
            ends.push_back({0, kFirst, still}), ends.push_back({end_, kLast, still});
            std::ranges::sort(ends, {}, &Cut::rho);
            for (std::size_t i = 0; i + 1 < ends.size(); ++i)
                add_piece(order < kWholeOrders && !dim(ends[i], ends[i + 1]) ? rule : thin, order, ends[i],
                          ends[i + 1]);
            if (light_.scene().disc->opacity <= kThinDisc) continue;
            for (const Cut& cut : own) before.push_back({cut.rho, cut.name, cut.by});
        }
    }

private:
    static constexpr int kFirst = -1, kLast = -2;  // names of the spoke's ends
    PictureLight::Ray at(double rho) {
        ++spoke_.rays;
        return light_.at(from_[0] + rho * x_, from_[1] + rho * y_, x_, y_);
    }
    bool falls_in(double rho) const { return light_.falls_in(from_[0] + rho * x_, from_[1] + rho * y_); }
    bool shines(const PictureLight::Ray& ray, std::size_t order) const {
        const DiscSpec& disc = *light_.scene().disc;
        return order < ray.crossings.size() && ray.crossings[order].r.value >= disc.inner &&
               ray.crossings[order].r.value <= disc.outer;
    }
    std::vector<double> still_by() const { return std::vector<double>(light_.keys().size(), 0.0); }
    // Of own cuts: between their circles of the disc.
    bool dim(const Cut& low, const Cut& high) const {
        if (low.mark_by.empty() || high.mark_by.empty()) return false;
        const double a = radius(low), b = radius(high);
        return light_.emissivity(a) < kDim && light_.emissivity(0.5 * (a + b)) < kDim && light_.emissivity(b) < kDim;
    }
    double radius(const Cut& cut) const {
        return light_.marks()[static_cast<std::size_t>(cut.name) / PictureLight::kOrders].value;
    }
    double critical() const;
    void look();
    std::vector<Cut> cuts_of(std::size_t order);
    struct Side {
        double rho, over;  // px; over(), whose sign changes between two sides
    };
    Cut cut_between(Side low, Side high, std::size_t order, const LightMark& mark);
    double over(const PictureLight::Ray& ray, double rho, std::size_t order, double radius) const;
    void add_piece(const LegendreRule& rule, std::size_t order, const Cut& low, const Cut& high);
    Motion motion(const LegendreRule& rule, const std::vector<PictureLight::Crossing>& on_disc, const Cut& low,
                  const Cut& high, std::size_t key) const;
    void add_places(const LegendreRule& rule, const std::vector<PictureLight::Crossing>& on_disc, const Cut& low,
                    const Cut& high);

    const PictureLight& light_;
    std::array<double, 2> from_;
    double x_, y_, end_, critical_ = 0;
    std::vector<double> looks_;
    std::vector<PictureLight::Ray> seen_;  // there
    LightSpoke& spoke_;
};

// 0: nothing falls in. Beyond the end where all does.
double Spoke::critical() const {
    if (!light_.has_horizon()) return 0;
    return critical_distance([this](double rho) { return falls_in(rho); }, end_);
}

// On both sides of the critical curve, at distances that grow as images do.
void Spoke::look() {
    critical_ = critical();
    looks_ = {0, end_};
    const double size = critical_ > 0 ? critical_ : end_;
    for (double off = kClosest * size; off < std::max(critical_, end_); off *= kGrowth)
        for (const double rho : {critical_ - off, critical_ + off})
            if (rho > 0 && rho < end_) looks_.push_back(rho);
    std::ranges::sort(looks_);
    for (const double rho : looks_) seen_.push_back(at(rho));
}

// The crossing's radius over the mark's: what falls in has its missing crossings within the horizon, what leaves has them far out.
double Spoke::over(const PictureLight::Ray& ray, double rho, std::size_t order, double radius) const {
    if (order < ray.crossings.size()) return ray.crossings[order].r.value - radius;
    return rho < critical_ ? -radius : radius;
}

std::vector<Cut> Spoke::cuts_of(std::size_t order) {
    std::vector<Cut> found;
    const std::vector<LightMark>& all = light_.marks();
    for (std::size_t m = 0; m < all.size(); ++m) {
        if (order >= kWholeOrders && m != 0 && m + 1 != all.size()) continue;
        for (std::size_t i = 0; i + 1 < looks_.size(); ++i) {
            const Side low{looks_[i], over(seen_[i], looks_[i], order, all[m].value)},
                high{looks_[i + 1], over(seen_[i + 1], looks_[i + 1], order, all[m].value)};
            if ((low.over > 0) == (high.over > 0)) continue;
            found.push_back(cut_between(low, high, order, all[m]));
            found.back().name = static_cast<int>(m * PictureLight::kOrders + order);
        }
    }
    return found;
}

// Newton's steps within a bracket.
Cut Spoke::cut_between(Side low, Side high, std::size_t order, const LightMark& mark) {
    const double width = high.rho - low.rho;
    double rho = low.rho + width * std::clamp(low.over / (low.over - high.over), 0.1, 0.9);
    PictureLight::Ray ray;
    for (int tries = 0; tries < kMostCutTries; ++tries) {
        ray = at(rho);
        const double off = over(ray, rho, order, mark.value);
        ((off > 0) == (high.over > 0) ? high : low) = {rho, off};
        const bool there = order < ray.crossings.size();
        const double next = there ? rho - off / ray.crossings[order].r.along : low.rho;
        const bool found = there && std::fabs(next - rho) < kCutFound * width;
        rho = there && next > low.rho && next < high.rho ? next : 0.5 * (low.rho + high.rho);
        if (found) break;
    }
    Cut cut{rho, 0, still_by()};
    if (order >= ray.crossings.size()) return cut;
    cut.mark_by = light_.mark_by(mark);
    for (std::size_t key = 0; key < cut.by.size(); ++key)
        cut.by[key] = (cut.mark_by[key] - ray.crossings[order].r.by[key]) / ray.crossings[order].r.along;
    return cut;
}

// Nothing where this image does not show the disc, as a look tells, or else a place in its middle.
void Spoke::add_piece(const LegendreRule& rule, std::size_t order, const Cut& low, const Cut& high) {
    const auto look = static_cast<std::size_t>(std::ranges::lower_bound(looks_, low.rho) - looks_.begin());
    if (look < looks_.size() && looks_[look] <= high.rho && !shines(seen_[look], order)) return;
    const std::size_t middle = rule.at.size() / 2;
    const double width = high.rho - low.rho;
    const auto there = [&](std::size_t i) { return at(low.rho + rule.at[i] * width); };
    const PictureLight::Ray first = there(middle);
    if (!shines(first, order)) return;
    spoke_.plan.push_back({static_cast<int>(order), low.name, high.name, static_cast<int>(rule.at.size())});
    std::vector<PictureLight::Crossing> on_disc;
    for (std::size_t i = 0; i < rule.at.size(); ++i) {
        PictureLight::Ray ray = i == middle ? first : there(i);
        // But for rounding next to a cut there is one.
        const PictureLight::Varied still{0, 0, still_by()};
        on_disc.push_back(order < ray.crossings.size() ? std::move(ray.crossings[order])
                                                       : PictureLight::Crossing{still, still});
    }
    add_places(rule, on_disc, low, high);
}

// How far places move by a key, px, and how that grows from place to place, for each px: on circles of the disc, which keep their radii but next to marks that
// move; or evenly, where an end of the piece is no mark of this image.
Motion Spoke::motion(const LegendreRule& rule, const std::vector<PictureLight::Crossing>& on_disc, const Cut& low,
                     const Cut& high, std::size_t key) const {
    const double width = high.rho - low.rho, wider = (high.by[key] - low.by[key]) / width;
    Motion motion;
    for (const double part : rule.at) motion.moved.push_back(low.by[key] + part * wider * width);
    motion.wider.assign(rule.at.size(), wider);
    if (low.mark_by.empty() || high.mark_by.empty()) return motion;
    std::vector<double> moved = {low.by[key]};
    for (std::size_t i = 0; i < rule.at.size(); ++i) {
        const double circle = low.mark_by[key] * std::pow(1 - rule.at[i], kOwnCircle) +
                              high.mark_by[key] * std::pow(rule.at[i], kOwnCircle);
        moved.push_back((circle - on_disc[i].r.by[key]) / on_disc[i].r.along);
        if (!std::isfinite(moved.back())) return motion;
    }
    moved.push_back(high.by[key]);
    motion.wider = slopes_of(rule, moved);
    for (double& slope : motion.wider) slope /= width;
    motion.moved.assign(moved.begin() + 1, moved.end() - 1);
    return motion;
}

void Spoke::add_places(const LegendreRule& rule, const std::vector<PictureLight::Crossing>& on_disc, const Cut& low,
                       const Cut& high) {
    const double width = high.rho - low.rho;
    const std::size_t keys = low.by.size(), size = place_numbers(keys), first = spoke_.numbers.size();
    spoke_.numbers.resize(first + rule.at.size() * size);
    for (std::size_t i = 0; i < rule.at.size(); ++i) {
        double* to = &spoke_.numbers[first + i * size];
        to[0] = low.rho + rule.at[i] * width, to[1] = rule.weight[i] * width * to[0] * on_disc[i].luminance.value;
    }
    for (std::size_t key = 0; key < keys; ++key) {
        const Motion motion = this->motion(rule, on_disc, low, high, key);
        for (std::size_t i = 0; i < rule.at.size(); ++i) {
            double* to = &spoke_.numbers[first + i * size];
            const PictureLight::Varied& light = on_disc[i].luminance;
            const double moved = motion.moved[i], share = rule.weight[i] * width;
            to[2 + key] = share * ((motion.wider[i] * to[0] + moved) * light.value +
                                   to[0] * (light.by[key] + light.along * moved));
            to[2 + keys + key] = moved;
        }
    }
}

}  // namespace

LightSpoke light_spoke(const PictureLight& light, const std::array<double, 2>& from, double angle, double end,
                       const SpokeRule& rule) {
    const LegendreRule along(rule.places), thin((rule.places + 1) / 2);
    LightSpoke spoke;
    Spoke(light, from, angle, end, spoke).trace(along, thin);
    return spoke;
}

}  // namespace nullscope
