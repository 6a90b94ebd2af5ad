// Line profiles of discs: published extremes of g, the reference's rays one by one and summed up over the image, Newton's limit, convergence.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "reference/disc_light.h"
#include "reference/disc_polarisation.h"
#include "reference/metric.h"
#include "reference/reference.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"
#include "spectrum/line_profile.h"
#include "support/costly.h"
#include "table/distant_polarisation.h"

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
DiscLine power_law_emission(double inner, double outer, double q = 3) {
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
        const LineProfile ring = line_profile(light, power_law_emission(known.r / 2, known.r / 2), {}, LineCells(1));
        CHECK(std::fabs(ring.least_g - known.least) < kDigits);
        CHECK(std::fabs(ring.most_g - known.most) < kDigits);
    }
    const LineProfile above = line_profile(light_of(spinning(0), 0), power_law_emission(4, 4), {}, LineCells(0));
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

// Of a disc's light, seen from infinity, with a field along no axis.
constexpr double kPolarised = 0.6;
const Vec3 kField = normalized(Vec3{0.6, -0.5, 0.4});
LinePolarisation polarised_ring(const DistantPolarisation& seen, double r) {
    return [of = seen.ring(r)](const LinePhoton& p) { return of({p.alpha, p.beta, p.lambda, p.eta, p.slope}); };
}

TEST_CASE("line profile: rays are polarised as the reference carries it") {
    constexpr double kObserver = 1e-4;  // rad; what is seen from kFarLine, not from infinity
    for (const SpacetimeSpec& spec : kSpecs)
        for (const bool scatters : {false, true}) {
            CAPTURE(spec.metric);
            const double inclination = 50 * kDegree;
            Scene scene;
            scene.spacetime = spec;
            DiscSpec& disc = scene.disc.emplace();
            disc.inner = 1.2, disc.outer = 20, disc.emission = DiscEmission::kThermal;
            disc.polarisation.by = scatters ? Polarisation::kScattering : Polarisation::kSynchrotron;
            disc.polarisation.field = DiscField::kVector, disc.polarisation.vector = kField;
            const auto judge = reference::DiscPolarisation::make(scene);
            REQUIRE(judge);
            const auto spacetime = *make_spacetime(spec.metric, spec.parameters);
            const DistantLight light = light_of(spacetime, 50);
            const DistantPolarisation seen(spacetime, inclination, field_of(disc.polarisation),
                                           polarised_fraction(disc.polarisation));
            int met = 0;
            for (int i = 0; i < 12; ++i) {
                const double rho = 2.4 * std::pow(4, i / 12.0), chi = 2.4 * i;
                const double alpha = rho * std::cos(chi), beta = rho * std::sin(chi);
                RayQuery query;
                query.r = kFarLine, query.theta = inclination;
                query.n = {-1, -beta / kFarLine, alpha / kFarLine};
                const auto known = judge->at(query, 1);
                const auto ours = light.crossing(alpha, beta);
                if (!known || !ours || known->r < 1.1) continue;
                ++met;
                const auto [lambda, eta] = light.constants(alpha, beta);
                const auto linear = seen.ring(1 / ours->zeta)({alpha, beta, lambda, eta, ours->slope});
                CHECK(std::fabs(std::remainder(0.5 * std::arg(linear) - known->angle, M_PI)) < kObserver);
                CHECK(std::fabs(std::abs(linear) - known->fraction) < kObserver);
            }
            CHECK(met > 7);
        }
}

TEST_CASE("line profile: Q and U of its bins are those of the image's points, summed up") {
    const auto spacetime = spinning(0.9);
    const double inner = 0.85, outer = 4;  // across the innermost stable orbit
    const DistantLight light = light_of(spacetime, 40);
    const DistantPolarisation seen(spacetime, 40 * kDegree, kField, kPolarised);
    const auto emissivity = [&](double r) {
        const double at = std::log(r / inner) / std::log(outer / inner);
        return at > 0 && at < 1 ? std::pow(std::sin(M_PI * at), 4) : 0.0;
    };
    DiscLine line{inner, outer, [&](const std::vector<double>& radii) {
                      std::vector<double> values;
                      for (const double r : radii) values.push_back(emissivity(r));
                      return values;
                  }};
    line.polarisation = [&](double r) { return polarised_ring(seen, r); };
    constexpr std::size_t kParts = 8;
    const LineProfile profile = line_profile(light, line, {kParts, 0.05, 1.45}, LineCells(0));
    REQUIRE(profile.linear.size() == kParts);
    std::array<std::complex<double>, kParts> parts{};
    std::complex<double> all;
    double photons = 0;
    constexpr int kRadii = 160, kAngles = 120;
    const double low = std::log(0.05), high = std::log(outer + 2);
    for (int i = 0; i < kRadii; ++i)
        for (int j = 0; j < kAngles; ++j) {
            const double rho = std::exp(low + (i + 0.5) / kRadii * (high - low)), chi = 2 * M_PI * (j + 0.5) / kAngles;
            const double alpha = rho * std::cos(chi), beta = rho * std::sin(chi);
            const auto met = light.crossing(alpha, beta);
            const double r = met ? 1 / met->zeta : 0.0;
            if (!met || !(emissivity(r) > 0)) continue;
            const auto [lambda, eta] = light.constants(alpha, beta);
            const MatterVelocity u = disc_matter(*spacetime, r);
            const double g =
                1 / (u.u_t - lambda * u.u_phi - met->slope * r * r / spacetime->equator(r)->across2 * u.u_r);
            const double light_here =
                g * g * g * emissivity(r) * rho * rho * (high - low) / kRadii * 2 * M_PI / kAngles;
            const auto linear = light_here * seen.ring(r)({alpha, beta, lambda, eta, met->slope});
            photons += light_here, all += linear;
            parts[static_cast<std::size_t>((g - 0.05) / 1.4 * kParts)] += linear;
        }
    CHECK(std::abs(profile.all_linear - all) < 2e-4 * photons);
    CHECK(std::fabs(profile.all_photons / photons - 1) < 2e-4);
    for (std::size_t n = 0; n < kParts; ++n) CHECK(std::abs(profile.linear[n] - parts[n]) < 0.01 * photons);
    const auto sum = std::accumulate(profile.linear.begin(), profile.linear.end(), std::complex<double>());
    CHECK(std::abs(sum - profile.all_linear) < 1e-10 * photons);
    CHECK(std::abs(all) > 0.05 * photons);  // there is something to be wrong about
    line.polarisation = {};
    CHECK(line_profile(light, line, {kParts, 0.05, 1.45}, LineCells(0)).linear.empty());
}

TEST_CASE("line profile: a ring far out in a vertical field is polarised along its image's major axis") {
    const double r = 5e9;  // of the next order: v/c
    const auto spacetime = spinning(0.5);
    const DistantPolarisation seen(spacetime, 60 * kDegree, {0, 0, 1}, kPolarised);
    DiscLine line = power_law_emission(r, r);
    line.polarisation = [&](double at) { return polarised_ring(seen, at); };
    const LineProfile ring = line_profile(light_of(spacetime, 60), line, {8, 1 - 1e-5, 1 + 1e-5}, LineCells(0));
    for (std::size_t i = 0; i < ring.photons.size(); ++i)
        if (ring.photons[i] > 0) CHECK(std::abs(ring.linear[i] / ring.photons[i] - kPolarised) < 1e-4);
    CHECK(std::abs(ring.all_linear / ring.all_photons - kPolarised) < 1e-4);
}

TEST_CASE("line profile: a ring far out has the two horns of Kepler's law") {
    const double r = 5e9, speed = std::sqrt(0.5 / r), inclination_deg = 60, across = speed * std::sin(60 * kDegree);
    // Of the next order the ends are off by some v/c of the width, where the profile is one over a root.
    const double next_order = 5 * std::sqrt(speed);
    const DistantLight light = light_of(spinning(0), inclination_deg);
    DiscLine line = power_law_emission(r, r);
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
        const DiscLine line = power_law_emission(of.inner > 0 ? of.inner : *innermost_stable_orbit(*spacetime), 200);
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
