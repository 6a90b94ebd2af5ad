#include "gradient/spoke_sum.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <tbb/parallel_for.h>

namespace nullscope {

LegendreRule::LegendreRule(int n) {
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

namespace {

constexpr int kHalfParts = 4;  // of the finer of two rules in a sector, which has twice as many
constexpr int kMostRounds = 7;

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

// A part of the picture between two directions: its flux, and by how much less exact a rule of half as many spokes differs, or half of what its own halves
// have changed: where images of rims begin or end two rules may agree by chance, three hardly do.
struct Sector {
    double from, to;
    bool known = false;
    FluxGradient sum{};
    std::optional<FluxGradient> whole{};  // of this one and the next, before they were two
};

void compare_with_whole(const FluxGradient& whole, Sector& one, Sector& other) {
    const auto raise = [](double before, double a, double b, double& error_a, double& error_b) {
        const double change = 0.5 * std::fabs(before - a - b);
        error_a = std::max(error_a, change), error_b = std::max(error_b, change);
    };
    FluxGradient &a = one.sum, &b = other.sum;
    raise(whole.flux, a.flux, b.flux, a.flux_error, b.flux_error);
    for (std::size_t key = 0; key < a.by.size(); ++key)
        raise(whole.by[key], a.by[key], b.by[key], a.by_error[key], b.by_error[key]);
}

class Sectors {
public:
    Sectors(const SpokedPicture& picture, std::size_t keys, double tolerance, const SpokeSum& spoke,
            const std::function<void(double)>& done)
        : keys_(keys), tolerance_(tolerance), spoke_(spoke), done_(done) {
        // From corner to corner.
        const auto& [w, h, from] = picture;
        std::vector<double> corners;
        for (const auto& [x, y] : {std::array{w, 0.0}, {w, h}, {0.0, h}, {0.0, 0.0}})
            corners.push_back(std::atan2(y - from[1], x - from[0]));
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
            all.error = worst(all, all);
            if (done_) done_(all.error);
            if (round + 1 == kMostRounds || !split(all, round == 0)) break;
        }
        all.rays += left_;
        return all;
    }

private:
    FluxGradient empty() const {
        FluxGradient sum;
        sum.by.assign(keys_, 0.0), sum.by_error = sum.by;
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
    bool split(const FluxGradient& all, bool every);

    static constexpr double kLeastSlope = 0.01;  // of the flux, by a unit: smaller derivatives are known to this
    std::size_t keys_;
    double tolerance_;
    const SpokeSum& spoke_;
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
        spoke_(sector.from + part * (sector.to - sector.from), spokes[i]);
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
    for (const std::size_t i : unknown)
        if (sectors_[i].whole) compare_with_whole(*sectors_[i].whole, sectors_[i], sectors_[i + 1]);
}

// What is too inexact, or every one, into halves. Whether there was any.
bool Sectors::split(const FluxGradient& all, bool every) {
    if (!every && all.error <= tolerance_) return false;
    std::vector<Sector> next;
    const double allowed = tolerance_ / static_cast<double>(sectors_.size());
    for (Sector& sector : sectors_) {
        if (!every && worst(sector.sum, all) <= allowed) {
            next.push_back(std::move(sector));
            next.back().whole.reset();
            continue;
        }
        const double middle = 0.5 * (sector.from + sector.to);
        left_ += sector.sum.rays;
        next.push_back({sector.from, middle, false, {}, sector.sum}), next.push_back({middle, sector.to});
    }
    sectors_ = std::move(next);
    return true;
}

}  // namespace

Result<SpokedPicture> picture_about_hole(const CameraSpec& camera, const CameraView& view) {
    const auto from = view.hole();
    if (!from || !((*from)[0] > 0 && (*from)[0] < camera.width && (*from)[1] > 0 && (*from)[1] < camera.height))
        return bad_input("the direction to the centre is not in the picture: no flux with derivatives",
                         "a camera that has the hole in its picture");
    return SpokedPicture{static_cast<double>(camera.width), static_cast<double>(camera.height), *from};
}

double to_edge(const SpokedPicture& picture, double x, double y) {
    const double right = x > 0 ? picture.width - picture.from[0] : picture.from[0],
                 down = y > 0 ? picture.height - picture.from[1] : picture.from[1];
    return std::min(right / std::fabs(x), down / std::fabs(y));
}

FluxGradient sum_of_spokes(const SpokedPicture& picture, std::size_t keys, double tolerance, const SpokeSum& spoke,
                           const std::function<void(double)>& done) {
    return Sectors(picture, keys, tolerance, spoke, done).sum();
}

}  // namespace nullscope
