// Line profiles of discs: published extremes of g, the reference's rays one by one and summed up over the image, Newton's limit, convergence.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "reference/disc_light.h"
#include "reference/metric.h"
#include "reference/reference.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"
#include "spectrum/line_profile.h"
#include "support/costly.h"

namespace {

using namespace nullscope;

constexpr double kDegree = M_PI / 180;
constexpr double kFarLine =
    1e6;  // r_s: where the reference's observer is; what it sees differs from infinity's by some 1/kFarLine

std::shared_ptr<const Spacetime> spinning(double spin) {
    return *make_spacetime("kerr", MetricParameters{{"spin", spin}});
}
DistantLight light_of(const std::shared_ptr<const Spacetime>& spacetime, double inclination_deg) {
    return *DistantLight::make(spacetime, inclination_deg * kDegree);
}
DiscLine power_law(double inner, double outer, double q = 3) {
    return {inner, outer, [q](const std::vector<double>& radii) {
                std::vector<double> values;
                for (const double r : radii) values.push_back(std::pow(r, -q));
                return values;
            }};
}

// The reference's rays as the distant observer's picture has them.
class Judge {
public:
    explicit Judge(const SpacetimeSpec& spec, double inclination)
        : metric_(std::move(*reference::make_metric(spec))), inclination_(inclination) {
        scene_.spacetime = spec;
        disc_.inner = 0.1, disc_.outer = 0.2;  // no heat is asked for
        matter_.emplace(*metric_, disc_, scene_.light);
    }
    std::optional<RayRecord::Crossing> crossing(double alpha, double beta) const {
        RayQuery query;
        query.r = kFarLine, query.theta = inclination_;
        query.n = {-1, -beta / kFarLine, alpha / kFarLine};
        const auto ray = reference::trace_ray(scene_, query, 1, &*matter_);
        REQUIRE(ray);
        if (ray->crossings.empty()) return std::nullopt;
        RayRecord::Crossing met = ray->crossings[0];
        met.g *= std::sqrt(1 - 1 / kFarLine);  // at infinity
        return met;
    }

    // Between the light and the disc's normal, to the matter at r.
    double cosine(double r, double lambda, double slope) const {
        return matter_->cosine({r, lambda, slope * r / std::sqrt(metric_->equator(r).g_phiphi)});
    }

private:
    std::unique_ptr<reference::Metric> metric_;
    double inclination_;
    Scene scene_;
    DiscSpec disc_;
    std::optional<reference::DiscLight> matter_;
};

const std::vector<SpacetimeSpec> kSpecs = {
    {"schwarzschild", {}},
    {"reissner-nordstrom", MetricParameters{{"charge", 0.8}}},
    {"kerr", MetricParameters{{"spin", 0.9}}},
    {"kerr-newman", MetricParameters{{"spin", 0.6}, {"charge", 0.6}}},
};

TEST_CASE("line profile: extremes of g of rings") {
    struct Known {
        double spin, r, inclination_deg, least, most;  // r in M
    };
    constexpr double kDigits = 1e-8;  // that are known
    for (const Known& known : {Known{0.9, 2.320883041761887, 60, 0.20257396, 1.00124795},
                               Known{0.9, 6, 30, 0.60441306, 0.95583071}, Known{0, 6, 60, 0.49707695, 1.22449057}}) {
        CAPTURE(known.r);
        const DistantLight light = light_of(spinning(known.spin), known.inclination_deg);
        const LineProfile ring = line_profile(light, power_law(known.r / 2, known.r / 2), {}, LineCells(1));
        CHECK(std::fabs(ring.least_g - known.least) < kDigits);
        CHECK(std::fabs(ring.most_g - known.most) < kDigits);
    }
    const LineProfile above = line_profile(light_of(spinning(0), 0), power_law(4, 4), {}, LineCells(0));
    CHECK(std::fabs(above.least_g - std::sqrt(1 - 1.5 / 4)) < 1e-14);
    CHECK(std::fabs(above.most_g - above.least_g) < 1e-14);
}

TEST_CASE("line profile: rays cross where the reference's do") {
    constexpr double kCosine = 1e-6;            // the reference's is a root of 1 less squares
    constexpr double kObserver = 2 / kFarLine;  // that is so near, over the radius
    for (const SpacetimeSpec& spec : kSpecs)
        for (const double inclination_deg : {20.0, 75.0}) {
            CAPTURE(spec.metric);
            CAPTURE(inclination_deg);
            const auto spacetime = *make_spacetime(spec.metric, spec.parameters);
            const DistantLight light = light_of(spacetime, inclination_deg);
            const Judge judge(spec, inclination_deg * kDegree);
            int met = 0;
            for (int i = 0; i < 60; ++i) {
                const double rho = 0.3 * std::pow(40, i / 60.0), chi = 2.4 * i;  // all round
                const double alpha = rho * std::cos(chi), beta = rho * std::sin(chi);
                const auto seen = light.crossing(alpha, beta);
                const auto known = judge.crossing(alpha, beta);
                const bool outside = known && known->r > 1.001 * light.horizon();
                if (!outside) {
                    CHECK((!seen || 1 / seen->zeta < 1.002 * light.horizon()));
                    continue;
                }
                REQUIRE(seen);
                ++met;
                CHECK(std::fabs(seen->zeta * known->r - 1) < kObserver * (1 + known->r));
                const DistantLight::Constants of = light.constants(alpha, beta);
                const auto g_at = [&](double r) {
                    const MatterVelocity u = disc_matter(*spacetime, r);
                    const double p_r = seen->slope * r * r / spacetime->equator(r)->across2;
                    return 1 / (u.u_t - of.lambda * u.u_phi - p_r * u.u_r);
                };
                // At its radius: near the horizon what that is off by changes g more than the ray.
                CHECK(std::fabs(g_at(known->r) / known->g - 1) < kObserver * (1 + known->r));
                const double r = 1 / seen->zeta, cosine = g_at(r) * std::sqrt(of.eta) / r;
                CHECK(std::fabs(cosine - judge.cosine(r, of.lambda, seen->slope)) < kCosine);
            }
            CHECK(met > 25);
        }
}

// Of light that fades towards both rims, so that sums over a picture's points are exact soon: the moments of g, and the shares of ten bins.
TEST_CASE("line profile: as the reference's rays make it, summed up over the image") {
    struct Disc {
        SpacetimeSpec spec;
        double inclination_deg, inner, outer;
        int radii, angles;
    };
    const std::vector<Disc> discs = {{kSpecs[0], 70, 3, 9, 160, 160},
                                     {kSpecs[2], 60, 1.2, 5, 56, 72},
                                     {kSpecs[2], 40, 0.85, 2.5, 56, 64}};  // across the innermost stable orbit
    constexpr double kSums = 5e-5, kPart = 0.01;  // of the sums over points; of those that are in the next bin
    for (const Disc& disc : discs) {
        CAPTURE(disc.spec.metric);
        CAPTURE(disc.inner);
        const auto emissivity = [&](double r) {
            const double at = std::log(r / disc.inner) / std::log(disc.outer / disc.inner);
            return at > 0 && at < 1 ? std::pow(std::sin(M_PI * at), 4) : 0.0;
        };
        const DistantLight light =
            light_of(*make_spacetime(disc.spec.metric, disc.spec.parameters), disc.inclination_deg);
        const DiscLine line{disc.inner, disc.outer, [&](const std::vector<double>& radii) {
                                std::vector<double> values;
                                for (const double r : radii) values.push_back(emissivity(r));
                                return values;
                            }};
        const LineProfile profile = line_profile(light, line, {2000, 0.05, 1.55}, LineCells(1));

        const Judge judge(disc.spec, disc.inclination_deg * kDegree);
        constexpr int kMoments = 5, kParts = 10;
        std::array<double, kMoments> sums{}, ours{};
        std::array<double, kParts> parts{}, our_parts{};
        const double low = std::log(0.05 * disc.inner), high = std::log(disc.outer + 2);
        for (int i = 0; i < disc.radii; ++i)
            for (int j = 0; j < disc.angles; ++j) {
                const double rho = std::exp(low + (i + 0.5) / disc.radii * (high - low)),
                             chi = 2 * M_PI * (j + 0.5) / disc.angles;
                const auto met = judge.crossing(rho * std::cos(chi), rho * std::sin(chi));
                if (!met || !(emissivity(met->r) > 0)) continue;
                const double photons = std::pow(met->g, 3) * emissivity(met->r) * rho * rho * (high - low) /
                                       disc.radii * 2 * M_PI / disc.angles;
                for (int n = 0; n < kMoments; ++n) sums[n] += photons * std::pow(met->g, n);
                parts[static_cast<std::size_t>((met->g - 0.05) / 1.5 * kParts)] += photons;
            }
        for (std::size_t i = 0; i < profile.photons.size(); ++i) {
            const double g = 0.5 * (profile.edge(i) + profile.edge(i + 1));
            for (int n = 0; n < kMoments; ++n) ours[n] += profile.photons[i] * std::pow(g, n);
            our_parts[i * kParts / profile.photons.size()] += profile.photons[i];
        }
        for (int n = 0; n < kMoments; ++n) {
            CAPTURE(n);
            CHECK(std::fabs(ours[n] / sums[n] - 1) < kSums);
        }
        CHECK(std::fabs(profile.all_photons / sums[0] - 1) < kSums);
        CHECK(std::fabs(profile.all_energy / sums[1] - 1) < kSums);
        for (int n = 0; n < kParts; ++n) {
            CHECK(std::fabs(our_parts[n] - parts[n]) < kPart * sums[0]);
        }
    }
}

TEST_CASE("line profile: a ring far out has the two horns of Kepler's law") {
    const double r = 5e9, speed = std::sqrt(0.5 / r), inclination_deg = 60, across = speed * std::sin(60 * kDegree);
    // Of the next order the ends are off by some v/c of the width, where the profile is one over a root.
    const double next_order = 5 * std::sqrt(speed);
    const DistantLight light = light_of(spinning(0), inclination_deg);
    DiscLine line = power_law(r, r);
    const LineProfile ring = line_profile(light, line, {40, 1 - across, 1 + across}, LineCells(1));
    const double most = *std::ranges::max_element(ring.photons) / ring.all_photons;
    for (std::size_t i = 0; i < 40; ++i) {
        const auto angle = [](double x) { return std::asin(std::clamp(x, -1.0, 1.0)); };
        const double low = static_cast<double>(i) / 20 - 1, exact = (angle(low + 0.05) - angle(low)) / M_PI;
        CHECK(std::fabs(ring.share(i) - exact) < next_order * most);
    }
    // The area of a ring, 2 pi r cos i, per dr; and what leaves at that angle.
    CHECK(ring.all_photons * r * r / (2 * M_PI * std::cos(60 * kDegree)) == doctest::Approx(1).epsilon(1e-3));
    line.limb = Limb::kLaor;
    const double laor = line_profile(light, line, {}, LineCells(0)).all_photons;
    line.limb = Limb::kHaardt;
    const double haardt = line_profile(light, line, {}, LineCells(0)).all_photons;
    CHECK(laor / ring.all_photons == doctest::Approx(1 + 2.06 * 0.5).epsilon(1e-3));
    CHECK(haardt / ring.all_photons == doctest::Approx(std::log(3)).epsilon(1e-3));
}

TEST_CASE("line profile: twice the resolution changes no bin by 0.5 % of the largest" * test::costly()) {
    constexpr double kRounding = 1e-10;
    struct Case {
        double spin, inclination_deg, inner;  // inner 0: the innermost stable orbit
    };
    for (const Case& of :
         {Case{0.998, 30, 0}, Case{0, 60, 0}, Case{0.9, 20, 0}, Case{0.9, 60, 0.75}, Case{0.5, 85, 0}}) {
        CAPTURE(of.spin);
        CAPTURE(of.inclination_deg);
        const auto spacetime = spinning(of.spin);
        const DistantLight light = light_of(spacetime, of.inclination_deg);
        const DiscLine line = power_law(of.inner > 0 ? of.inner : *innermost_stable_orbit(*spacetime), 200);
        const ConvergedProfile found = converged_profile(light, line, {});
        CHECK(found.change <= kConverged);
        CHECK(found.profile.photons.size() == 1000);
        const LineBins same{1000, found.profile.from, found.profile.to};
        const LineProfile finer = line_profile(light, line, same, LineCells(2));
        const double change = profile_change(found.profile, finer);
        MESSAGE(fmt::format("a {} i {}: {:.3g}, and before {:.3g}", of.spin, of.inclination_deg, change, found.change));
        CHECK(change < 0.005);
        CHECK(change < 0.4 * found.change + 1e-4);  // and it converges
        const double all = std::accumulate(finer.photons.begin(), finer.photons.end(), 0.0);
        CHECK(std::fabs(all / finer.all_photons - 1) < kRounding);
        const double energy = std::accumulate(finer.energy.begin(), finer.energy.end(), 0.0);
        CHECK(std::fabs(energy / finer.all_energy - 1) < kRounding);
        CHECK(std::fabs(found.profile.all_energy / finer.all_energy - 1) < 1e-6);
    }
}

TEST_CASE("line profile: what is refused") {
    const auto refusal = [](const char* metric, double inclination_deg) {
        const auto light = DistantLight::make(*make_spacetime(metric, {}), inclination_deg * kDegree);
        return light ? std::string() : light.error().message();
    };
    CHECK(refusal("schwarzschild", 89).empty());
    CHECK(refusal("schwarzschild", 89.1).find("0 to 89 degrees") != std::string::npos);
    for (const char* metric : {"minkowski", "ellis", "neutron-star", "janis-newman-winicour"})
        CHECK(refusal(metric, 30).find("no disc") != std::string::npos);
}

}  // namespace
