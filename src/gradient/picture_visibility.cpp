#include "gradient/picture_visibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <tbb/parallel_for.h>

#include "gradient/light_spoke.h"

namespace nullscope {
namespace {

constexpr std::size_t kFirstSpokes = 8, kMostSpokes = 64;
constexpr std::size_t kMostProbes = 24;  // patterns of fringes by which spokes are judged
constexpr double kBeyond = 4.0;          // of the picture's diagonal, where spokes end
constexpr double kOutside = 1e-3;        // of the light, that may be beyond the picture
constexpr double kLeastDense = 24.0;     // spokes for no fringes; and
constexpr double kDenseARadian = 1.2;    // for each radian of phase along a radius
constexpr double kLeastPlaces = 6.0;     // in a piece of a radius, for no fringes; and
constexpr double kPlacesARadian = 0.5;   // for each radian of phase along it
constexpr double kFaintest = 1e-12;      // of a piece's most light: what is less has no logarithm
constexpr std::size_t kGroups = 4;       // of fringes, by how dense they are

using Complex = std::complex<double>;
using Sums = VisibilityGradient::Sums;  // of one pattern: value, by_scale, by each key

double density(const Fringes& fringes) { return std::hypot(fringes.right, fringes.down); }

// What spokes are judged by: evenly many of all densities, and none at all.
std::vector<Fringes> probes_of(std::vector<Fringes> fringes) {
    std::ranges::sort(fringes, {}, density);
    std::vector<Fringes> probes = {{0, 0}};
    const std::size_t count = std::min(kMostProbes, fringes.size());
    for (std::size_t i = 1; i <= count; ++i) probes.push_back(fringes[i * fringes.size() / count - 1]);
    return probes;
}

// Root mean squares of value, by_scale, by each key.
std::vector<double> sizes_of(const std::vector<Sums>& sums) {
    std::vector<double> sizes(sums[0].size());
    for (const Sums& one : sums)
        for (std::size_t n = 0; n < sizes.size(); ++n) sizes[n] += std::norm(one[n]) / static_cast<double>(sums.size());
    for (double& size : sizes) size = std::sqrt(size);
    return sizes;
}

// What counts at t, in units of the spokes' distance, of `count` spokes around, an even number: of the trigonometric polynomial through all.
double share_of_spoke(double t, std::size_t count) {
    const auto n = static_cast<double>(count);
    const double half = M_PI * t / n;
    return std::fabs(std::sin(half)) < 1e-12 ? 1.0 : std::sin(M_PI * t) / (n * std::tan(half));
}

// What values at a rule's nodes count at those of another, row by row: of the polynomial through all.
std::vector<double> between_rules(const LegendreRule& from, const LegendreRule& to) {
    const std::size_t n = from.at.size();
    std::vector<double> shares(to.at.size() * n, 1.0);
    for (std::size_t row = 0; row < to.at.size(); ++row)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                if (j != i) shares[row * n + i] *= (to.at[row] - from.at[j]) / (from.at[i] - from.at[j]);
    return shares;
}

// A piece's numbers in spokes all around. What changes along it by powers of ten, as light does, is carried from place to place as its logarithm; its
// derivatives as parts of it.
class Ring {
public:
    // first: of its numbers in each spoke's.
    Ring(const std::vector<LightSpoke>& spokes, std::size_t first, std::size_t places, std::size_t keys)
        : rule_(static_cast<int>(places)), keys_(keys), size_(place_numbers(keys)) {
        for (const LightSpoke& spoke : spokes)
            spokes_.emplace_back(spoke.numbers.begin() + static_cast<std::ptrdiff_t>(first),
                                 spoke.numbers.begin() + static_cast<std::ptrdiff_t>(first + places * size_));
        double most = 0, least = HUGE_VAL;
        for (std::vector<double>& numbers : spokes_)
            for (std::size_t i = 0; i < places; ++i) {
                double* place = &numbers[i * size_];
                for (std::size_t n = 1; n < 2 + keys; ++n) place[n] /= rule_.weight[i];
                most = std::max(most, place[1]), least = std::min(least, place[1]);
                farthest_ = std::max(farthest_, place[0]);
            }
        logged_ = least > kFaintest * most;
        for (std::vector<double>& numbers : spokes_) {
            widest_ = std::max(widest_, numbers[(places - 1) * size_] - numbers[0]);
            for (std::size_t i = 0; logged_ && i < places; ++i) {
                double* place = &numbers[i * size_];
                for (std::size_t key = 0; key < keys; ++key) place[2 + key] /= place[1];
                place[1] = std::log(place[1]);
            }
        }
    }
    double farthest() const { return farthest_; }

    // Places as fringes of a wave number ask for, and what this piece's own count there.
    struct Finer {
        LegendreRule rule;
        std::vector<double> shares;
    };
    Finer finer(double most) const {
        const int dense = static_cast<int>(kLeastPlaces + kPlacesARadian * most * widest_);
        const LegendreRule rule(std::max(dense, static_cast<int>(rule_.at.size())));
        return {rule, between_rules(rule_, rule)};
    }
    // Appends such places between the spokes, of which each counts as told.
    void add_to(std::vector<double>& numbers, const std::vector<double>& spokes, const Finer& finer) const {
        const std::size_t step = spokes_.size() / spokes.size();
        std::vector<double> here(spokes_[0].size());
        for (std::size_t i = 0; i < spokes.size(); ++i)
            for (std::size_t n = 0; n < here.size(); ++n) here[n] += spokes[i] * spokes_[i * step][n];
        const LegendreRule& to = finer.rule;
        const std::size_t from = numbers.size(), n = rule_.at.size();
        numbers.resize(from + to.at.size() * size_);
        for (std::size_t row = 0; row < to.at.size(); ++row) {
            double* there = &numbers[from + row * size_];
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t k = 0; k < size_; ++k) there[k] += finer.shares[row * n + i] * here[i * size_ + k];
            const double light = to.weight[row] * (logged_ ? std::exp(there[1]) : there[1]);
            for (std::size_t key = 0; key < keys_; ++key) there[2 + key] *= logged_ ? light : to.weight[row];
            there[1] = light;
        }
    }

private:
    LegendreRule rule_;
    std::size_t keys_, size_;
    std::vector<std::vector<double>> spokes_;
    double farthest_ = 0, widest_ = 0;
    bool logged_ = false;
};

// Spokes all around, evenly.
class Wheel {
public:
    Wheel(const PictureLight& light, const SpokedPicture& picture, int places)
        : light_(light), picture_(picture), keys_(light.keys().size()), places_(places) {}

    // Errors: images of the disc come and go around the hole, or it is cut by the picture.
    Status trace(std::size_t count) {
        std::vector<LightSpoke> spokes(count);
        const bool halved = 2 * spokes_.size() == count;
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
            const bool known = halved && i % 2 == 0;
            spokes[i] = known ? spokes_[i / 2] : light_spoke(light_, picture_.from, angle(i, count), end(), {places_});
        });
        spokes_ = std::move(spokes);
        TRY(can_be, check());
        rings_.clear();
        std::size_t first = 0;
        for (const LightSpoke::Piece& piece : spokes_[0].plan) {
            const auto places = static_cast<std::size_t>(piece.places);
            rings_.emplace_back(spokes_, first, places, keys_);
            first += places * place_numbers(keys_);
        }
        return Done{};
    }
    long rays() const {
        long sum = 0;
        for (const LightSpoke& spoke : spokes_) sum += spoke.rays;
        return sum;
    }

    // Of each of these fringes. step: 2: by every other spoke.
    std::vector<Sums> sums(const std::vector<Fringes>& fringes, std::size_t step) const {
        double most = 0, farthest = 0;
        for (const Fringes& one : fringes) most = std::max(most, density(one));
        std::vector<Ring::Finer> finer;
        for (const Ring& ring : rings_)
            farthest = std::max(farthest, ring.farthest()), finer.push_back(ring.finer(most));
        const std::size_t known = spokes_.size() / step;
        std::vector<std::vector<double>> dense(static_cast<std::size_t>(kLeastDense + kDenseARadian * most * farthest));
        tbb::parallel_for(std::size_t{0}, dense.size(), [&](std::size_t m) {
            const double place = static_cast<double>(m * known) / static_cast<double>(dense.size());
            std::vector<double> shares;
            for (std::size_t i = 0; i < known; ++i)
                shares.push_back(share_of_spoke(place - static_cast<double>(i), known));
            for (std::size_t k = 0; k < rings_.size(); ++k) rings_[k].add_to(dense[m], shares, finer[k]);
        });
        std::vector<Sums> sums(fringes.size(), Sums(2 + keys_));
        tbb::parallel_for(std::size_t{0}, fringes.size(), [&](std::size_t i) {
            for (std::size_t m = 0; m < dense.size(); ++m) add(fringes[i], angle(m, dense.size()), dense[m], sums[i]);
            for (Complex& sum : sums[i]) sum *= 2 * M_PI / static_cast<double>(dense.size());
        });
        return sums;
    }

private:
    static double angle(std::size_t i, std::size_t count) {
        return 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    }
    double end() const { return kBeyond * std::hypot(picture_.width, picture_.height); }

    Status check() const {
        for (const LightSpoke& spoke : spokes_)
            if (spoke.plan != spokes_[0].plan)
                return bad_input("images of the disc are not rings about the hole: no visibilities with derivatives",
                                 "a camera outside of the disc, not next to its plane");
        double all = 0, outside = 0;
        for (std::size_t i = 0; i < spokes_.size(); ++i) {
            const double turn = angle(i, spokes_.size()), edge = to_edge(picture_, std::cos(turn), std::sin(turn));
            const std::vector<double>& numbers = spokes_[i].numbers;
            for (std::size_t n = 0; n < numbers.size(); n += place_numbers(keys_)) {
                all += numbers[n + 1];
                if (numbers[n] > edge) outside += numbers[n + 1];
            }
        }
        if (outside > kOutside * all)
            return bad_input("the disc is not whole in the picture: no visibilities with derivatives", "a wider view");
        return Done{};
    }

    void add(const Fringes& fringes, double angle, const std::vector<double>& numbers, Sums& to) const {
        const double right = picture_.from[0] - 0.5 * picture_.width, down = picture_.from[1] - 0.5 * picture_.height;
        const double there = fringes.right * right + fringes.down * down,
                     along = fringes.right * std::cos(angle) + fringes.down * std::sin(angle);
        for (std::size_t i = 0; i < numbers.size(); i += place_numbers(keys_)) {
            const double* place = &numbers[i];
            const double phase = there + along * place[0], light = place[1], c = std::cos(phase), s = std::sin(phase);
            to[0] += Complex(light * c, light * s);
            to[1] += Complex(-phase * light * s, phase * light * c);
            for (std::size_t key = 0; key < keys_; ++key) {
                const double by = place[2 + key], swept = light * along * place[2 + keys_ + key];
                to[2 + key] += Complex(by * c - swept * s, by * s + swept * c);
            }
        }
    }

    const PictureLight& light_;
    SpokedPicture picture_;
    std::size_t keys_;
    int places_;
    std::vector<LightSpoke> spokes_;
    std::vector<Ring> rings_;
};

double error_of(const Wheel& wheel, const std::vector<Fringes>& probes) {
    const std::vector<Sums> all = wheel.sums(probes, 1);
    std::vector<Sums> off = wheel.sums(probes, 2);
    for (std::size_t i = 0; i < off.size(); ++i)
        for (std::size_t n = 0; n < off[i].size(); ++n) off[i][n] -= all[i][n];
    const std::vector<double> size = sizes_of(all), wrong = sizes_of(off);
    double most = 0;
    for (std::size_t n = 0; n < size.size(); ++n)
        if (size[n] > 0) most = std::max(most, wrong[n] / size[n]);
    return most;
}

// Those of like density together.
void add_all(const Wheel& wheel, std::span<const Fringes> fringes, VisibilityGradient& found) {
    std::vector<std::size_t> order(fringes.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::sort(order, {}, [&](std::size_t i) { return density(fringes[i]); });
    const std::size_t group = (order.size() + kGroups - 1) / kGroups;
    for (std::size_t from = 0; from < order.size(); from += group) {
        const std::span<const std::size_t> of(&order[from], std::min(group, order.size() - from));
        std::vector<Fringes> together;
        for (const std::size_t i : of) together.push_back(fringes[i]);
        const std::vector<Sums> sums = wheel.sums(together, 1);
        for (std::size_t k = 0; k < of.size(); ++k) {
            found.value[of[k]] = sums[k][0], found.by_scale[of[k]] = sums[k][1];
            for (std::size_t key = 0; key < found.by.size(); ++key) found.by[key][of[k]] = sums[k][2 + key];
        }
    }
    const Sums still = wheel.sums({{0, 0}}, 1)[0];
    found.flux = still[0].real();
    for (std::size_t key = 0; key < found.by.size(); ++key) found.flux_by.push_back(still[2 + key].real());
}

}  // namespace

Result<VisibilityGradient> visibility_gradient(const PictureLight& light, std::span<const Fringes> fringes,
                                               const VisibilityRule& rule) {
    TRY(picture, picture_about_hole(light.scene().camera, light.view()));
    const std::vector<Fringes> probes = probes_of({fringes.begin(), fringes.end()});
    VisibilityGradient found;
    found.value.resize(fringes.size()), found.by_scale = found.value;
    found.by.assign(light.keys().size(), found.value);
    Wheel wheel(light, *picture, rule.places);
    found.error = HUGE_VAL;
    for (std::size_t count = kFirstSpokes; count <= kMostSpokes && found.error > rule.tolerance; count *= 2) {
        TRY(can_be, wheel.trace(count));
        found.error = error_of(wheel, probes);
    }
    if (!(found.error <= rule.tolerance))
        return failed(
            fmt::format("visibilities with derivatives: {} spokes are not enough for these fringes", kMostSpokes));
    found.rays = wheel.rays();
    add_all(wheel, fringes, found);
    return found;
}

}  // namespace nullscope
