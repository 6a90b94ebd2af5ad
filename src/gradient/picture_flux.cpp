#include "gradient/picture_flux.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace nullscope {
namespace {

constexpr double kClosest = 1e-5;        // of the critical curve's distance, where images are still looked for
constexpr double kGrowth = 2.0;          // from look to look, away from that curve
constexpr std::size_t kWholeOrders = 2;  // images that are cut at all marks; the next at their rims
constexpr int kHalvings = 48;
constexpr int kMostCutTries = 60;
constexpr double kCutFound = 1e-7;  // of a bracket: Newton's next step is at rounding
constexpr double kThin = 0.02;      // of the critical curve's distance: pieces that need half of the places
constexpr int kHalfParts = 4;       // of the finer of two rules in a sector, which has twice as many
constexpr int kMostRounds = 7;

double luminance_of_light(const Vec3& light) {
    return 0.2126390059 * light.x + 0.7151686788 * light.y + 0.0721923154 * light.z;
}

struct LegendreRule {
    std::vector<double> at, weight;  // on [0, 1]
    explicit LegendreRule(int n) {
        for (int i = 0; i < n; ++i) {
            double x = std::cos(M_PI * (i + 0.75) / (n + 0.5)), slope = 1;
            for (int newton = 0; newton < 10; ++newton) {
                double p = 1, before = 0;
                for (int k = 1; k <= n; ++k) {
                    const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                    before = p, p = next;
                }
                slope = n * (x * p - before) / (x * x - 1);
                x -= p / slope;
            }
            at.push_back(0.5 * (1 - x)), weight.push_back(1 / ((1 - x * x) * slope * slope));
        }
    }
};

// A distance from the spoke's beginning, px, and how keys move it.
struct Cut {
    double rho;
    std::vector<double> by;
};

class Spoke {
public:
    Spoke(const PictureLight& light, const std::array<double, 2>& from, double angle)
        : light_(light), from_(from), x_(std::cos(angle)), y_(std::sin(angle)) {
        const CameraSpec& camera = light.scene().camera;
        const double right = x_ > 0 ? camera.width - from[0] : from[0],
                     down = y_ > 0 ? camera.height - from[1] : from[1];
        end_ = std::min(right / std::fabs(x_), down / std::fabs(y_));
    }

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
    double low = 0, high = end_;
    if (falls_in(high)) return 2 * end_;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (falls_in(middle) ? low : high) = middle;
    }
    return 0.5 * (low + high);
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

// C. W. Clenshaw and A. R. Curtis, Numer. Math. 2, 197 (1960): on [0, 1], ends included, so that those of every other place are a rule too.
std::vector<double> clenshaw_curtis(int parts) {
    std::vector<double> weights;
    for (int k = 0; k <= parts; ++k) {
        double sum = 1;
        for (int j = 1; j <= parts / 2; ++j)
            sum -= (2 * j == parts ? 1.0 : 2.0) / (4.0 * j * j - 1) * std::cos(2 * M_PI * j * k / parts);
        weights.push_back((k == 0 || k == parts ? 0.5 : 1.0) / parts * sum);
    }
    return weights;
}

void add_to(FluxGradient& sum, const FluxGradient& part, double weight) {
    sum.flux += weight * part.flux;
    for (std::size_t key = 0; key < sum.by.size(); ++key) sum.by[key] += weight * part.by[key];
}

// A part of the picture between two directions: its flux, and by how much less exact a rule of half as many spokes differs.
struct Sector {
    double from, to;
    bool known = false;
    FluxGradient sum{};
};

class Sectors {
public:
    Sectors(const PictureLight& light, const std::array<double, 2>& hole, const FluxRule& rule,
            const std::function<void(double)>& done)
        : light_(light), hole_(hole), rule_(rule), along_(rule.places), thin_((rule.places + 1) / 2), done_(done) {
        // From corner to corner.
        const double w = light.scene().camera.width, h = light.scene().camera.height;
        std::vector<double> corners;
        for (const auto& [x, y] : {std::array{w, 0.0}, {w, h}, {0.0, h}, {0.0, 0.0}})
            corners.push_back(std::atan2(y - hole[1], x - hole[0]));
        for (std::size_t i = 0; i < 4; ++i) {
            const double to = corners[(i + 1) % 4];
            sectors_.push_back({corners[i], to < corners[i] ? to + 2 * M_PI : to});
        }
    }

    FluxGradient sum() {
        FluxGradient all;
        for (int round = 0; round < kMostRounds; ++round) {
            trace();
            all = empty();
            for (const Sector& sector : sectors_) {
                add_to(all, sector.sum, 1);
                all.flux_error += sector.sum.flux_error, all.rays += sector.sum.rays;
                for (std::size_t key = 0; key < all.by.size(); ++key) all.by_error[key] += sector.sum.by_error[key];
            }
            if (done_) done_(worst(all, all));
            if (!split(all)) break;
        }
        all.rays += left_;
        return all;
    }

private:
    FluxGradient empty() const {
        FluxGradient sum;
        sum.by.assign(light_.keys().size(), 0.0), sum.by_error = sum.by;
        return sum;
    }
    // The largest error of part, of the whole's numbers.
    static double worst(const FluxGradient& part, const FluxGradient& all) {
        double error = part.flux_error / std::fabs(all.flux);
        for (std::size_t key = 0; key < all.by.size(); ++key)
            error = std::max(error, part.by_error[key] / std::max(std::fabs(all.by[key]), kLeastSlope * all.flux));
        return error;
    }
    void trace();
    bool split(const FluxGradient& all);

    static constexpr double kLeastSlope = 0.01;  // of the flux, by a unit: smaller derivatives are known to this
    const PictureLight& light_;
    std::array<double, 2> hole_;
    FluxRule rule_;
    LegendreRule along_, thin_;
    const std::function<void(double)>& done_;
    std::vector<Sector> sectors_;
    long left_ = 0;
};

void Sectors::trace() {
    constexpr std::size_t kParts = 2 * kHalfParts;
    const std::vector<double> fine = clenshaw_curtis(kParts), coarse = clenshaw_curtis(kHalfParts);
    std::vector<std::size_t> unknown;
    for (std::size_t i = 0; i < sectors_.size(); ++i)
        if (!sectors_[i].known) unknown.push_back(i);
    std::vector<FluxGradient> spokes(unknown.size() * (kParts + 1), empty());
    tbb::parallel_for(std::size_t{0}, spokes.size(), [&](std::size_t i) {
        const Sector& sector = sectors_[unknown[i / (kParts + 1)]];
        const double part = 0.5 * (1 - std::cos(M_PI * static_cast<double>(i % (kParts + 1)) / kParts));
        Spoke(light_, hole_, sector.from + part * (sector.to - sector.from)).add(along_, thin_, spokes[i]);
    });
    for (std::size_t n = 0; n < unknown.size(); ++n) {
        Sector& sector = sectors_[unknown[n]];
        const double turn = sector.to - sector.from;
        FluxGradient less = empty(), sum = empty();
        for (std::size_t i = 0; i <= kParts; ++i) {
            const FluxGradient& spoke = spokes[n * (kParts + 1) + i];
            add_to(sum, spoke, turn * fine[i]), sum.rays += spoke.rays;
            if (i % 2 == 0) add_to(less, spoke, turn * coarse[i / 2]);
        }
        sum.flux_error = std::fabs(sum.flux - less.flux);
        for (std::size_t key = 0; key < sum.by.size(); ++key) sum.by_error[key] = std::fabs(sum.by[key] - less.by[key]);
        sector.sum = sum, sector.known = true;
    }
}

// What is too inexact into halves. Whether there was any.
bool Sectors::split(const FluxGradient& all) {
    if (worst(all, all) <= rule_.tolerance) return false;
    std::vector<Sector> next;
    const double allowed = rule_.tolerance / static_cast<double>(sectors_.size());
    for (const Sector& sector : sectors_) {
        if (worst(sector.sum, all) <= allowed) {
            next.push_back(sector);
            continue;
        }
        const double middle = 0.5 * (sector.from + sector.to);
        left_ += sector.sum.rays;
        next.push_back({sector.from, middle}), next.push_back({middle, sector.to});
    }
    sectors_ = std::move(next);
    return true;
}

}  // namespace

Result<FluxGradient> flux_gradient(const PictureLight& light, const FluxRule& rule,
                                   const std::function<void(double)>& done) {
    const CameraSpec& camera = light.scene().camera;
    const auto from = light.view().hole();
    if (!from || !((*from)[0] > 0 && (*from)[0] < camera.width && (*from)[1] > 0 && (*from)[1] < camera.height))
        return bad_input("the direction to the centre is not in the picture: no flux with derivatives",
                         "a camera that has the hole in its picture");
    return Sectors(light, *from, rule, done).sum();
}

}  // namespace nullscope
