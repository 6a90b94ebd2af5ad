#include "reference/matter_stokes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plan/medium.h"
#include "reference/carrying_place.h"
#include "reference/stokes_coefficients.h"
#include "scene/known_object.h"
#include "spacetime/registry.h"

namespace nullscope::reference {
namespace {

constexpr double kOpaque = 1e-9;  // of the light behind: less is not looked for
constexpr double kFarStep = 0.2;  // of the way to the matter, outside of it
constexpr int kMostPieces = 100000;

// [[exp(-K), mean of exp(-tK)], [0, 1]], without its last row.
struct Transfer {
    Mueller through, mean;
};

Mueller product(const Mueller& a, const Mueller& b) {
    Mueller c{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t j = 0; j < 4; ++j) c[i][j] += a[i][k] * b[k][j];
    return c;
}

Stokes product(const Mueller& a, const Stokes& s) {
    Stokes c{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k) c[i] += a[i][k] * s[k];
    return c;
}

Transfer transfer(const Mueller& k) {
    double size = 0;
    for (const auto& row : k)
        for (const double part : row) size = std::max(size, std::abs(part));
    const int halvings = size > 0 ? std::max(0, static_cast<int>(std::ceil(std::log2(size))) + 6) : 0;
    Mueller part{}, term{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) part[i][j] = -std::ldexp(k[i][j], -halvings);
        term[i][i] = 1;
    }
    Transfer sum{term, term};
    for (int n = 1; n < 10; ++n) {
        term = product(term, part);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) {
                term[i][j] /= n;
                sum.through[i][j] += term[i][j];
                sum.mean[i][j] += term[i][j] / (n + 1);
            }
    }
    for (int n = 0; n < halvings; ++n) {
        const Mueller second = product(sum.through, sum.mean);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) sum.mean[i][j] = 0.5 * (sum.mean[i][j] + second[i][j]);
        sum.through = product(sum.through, sum.through);
    }
    return sum;
}

// Boyer and Lindquist's azimuth less the ingoing one, outside the horizon.
double azimuth_ahead(const Spacetime& spacetime, double r) {
    const auto hole = medium_hole(spacetime);
    if (!hole || !(hole->a > 0)) return 0;
    return -hole->a / (hole->outer - hole->inner) * std::log((r - hole->outer) / (r - hole->inner));
}

// Absorption follows from emission by Kirchhoff's law.
ElectronLight thermal_light(const MatterState& matter, double cosine, double nu) {
    const double emissivity = synchrotron_at(matter.density, matter.temperature_K, matter.field_G,
                                             std::sqrt(std::max(1 - cosine * cosine, 0.0)), nu);
    const StokesCoefficients s =
        thermal_stokes(matter.density, matter.temperature_K, std::max(matter.field_G, 1e-6), cosine, nu, true);
    return {emissivity,   emissivity > 0 ? emissivity / planck(matter.temperature_K, nu) : 0,
            s.emitted_q,  s.emitted_v,
            s.emitted_q,  s.emitted_v,
            s.conversion, s.rotation};
}

}  // namespace

EvenLight even_light(const EvenMatter& matter) {
    const auto& [q, u, v] = matter.absorbed;
    const auto& [rho_q, rho_u, rho_v] = matter.turned;
    const double d = matter.depth;
    const Transfer found =
        transfer({{{d, q, u, v}, {q, d, rho_v, -rho_u}, {u, -rho_v, d, rho_q}, {v, rho_u, -rho_q, d}}});
    return {found.through, product(found.mean, matter.emitted)};
}

Result<MatterStokes> MatterStokes::make(const Scene& scene) {
    if (!has_polarised_medium(scene))
        return bad_input("the scene has no medium whose light is polarised", "medium.polarisation = \"on\"");
    if (const char* key = medium_moves(*scene.medium); key != nullptr && scene.light.delay)
        return bad_input(fmt::format("{}: the reference polarises no matter that changes with time", key),
                         "light.delay = \"off\"");
    MatterStokes made;
    made.spec_ = *scene.medium, made.light_ = scene.light;
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    made.spacetime_ = std::move(*spacetime);
    TRY(metric, make_metric(scene.spacetime));
    made.metric_ = std::move(*metric);
    made.carrying_ = carrying_metric(*made.spacetime_);
    if (!made.carrying_) return bad_input("the reference carries no axes in this metric");
    TRY(read, read_matter(*made.spacetime_, scene));
    made.model_ = make_matter(scene, *made.metric_);
    if (made.spec_.has_electrons()) made.electrons_.emplace(made.spec_.electrons, false);
    made.unit_cgs_ = medium_light_cgs(made.spec_.frequency_GHz);
    made.length_cm_ = 100 * schwarzschild_radius_m(scene.object.mass().value_or(0.0));
    made.nearest_ = made.model_->horizon() + kMediumAboveHorizon;
    return made;
}

Result<CameraAxes> MatterStokes::axes_of(const CameraSpec& camera) const { return camera_axes(*spacetime_, camera); }

EvenMatter MatterStokes::matter_at(const CarriedAxes& axes, double azimuth, double way) const {
    const CarryingPlace place(*carrying_, axes.place);
    const Vec3 flat = place.direction();
    const double turn = azimuth + azimuth_ahead(*spacetime_, place.r()), c = std::cos(turn), s = std::sin(turn);
    const MediumNode node{0, place.r(), {c * flat.x - s * flat.y, s * flat.x + c * flat.y, flat.z}, 0, way};
    const PlaceMetric g = metric_->place(node.r, place.sine(), place.cosine());
    const auto matter = model_->at(node, g);
    if (!matter) return {};
    // The observer of no angular momentum.
    const double omega = -g.g_tphi / g.g_phiphi, lapse = std::sqrt(g.g_tphi * g.g_tphi / g.g_phiphi - g.g_tt);
    const FourVector e_t = place.outer(1 / lapse, 0, 0, omega / lapse);
    const FourVector out = place.outer(0, 1 / std::sqrt(g.g_rr), 0, 0),
                     south = place.outer(0, 0, 1 / std::sqrt(g.g_thetatheta), 0),
                     east = place.outer(0, 0, 0, 1 / std::sqrt(g.g_phiphi));
    const auto along = [&](const Vec3& v) { return sum_of(v.x, out, 1, sum_of(v.y, south, v.z, east)); };
    const FourVector u =
        sum_of(std::sqrt(1 + dot(matter->velocity, matter->velocity)), e_t, 1, along(matter->velocity));
    const Vec3 field = spec_.field_direction == FieldDirection::kFile ? matter->field_way : field_way_of(spec_);
    const FourVector b = moved(place, along(field), u, e_t);
    const double frequency = -place.product(axes.k, u), ratio = 1 / frequency;
    const double cosine = std::clamp(place.product(axes.k, b) * ratio, -1.0, 1.0);
    const double angle = std::atan2(volume_of(axes.up, u, axes.k, b), volume_of(axes.right, u, axes.k, b));

    const double nu = 1e9 * spec_.frequency_GHz * (light_.shift ? frequency : 1);
    const ElectronLight found =
        electrons_ ? electrons_->at(matter->density, matter->temperature_K, matter->field_G, cosine, nu)
                   : thermal_light(*matter, cosine, nu);
    const double length = way * frequency * length_cm_, faraday = spec_.faraday ? length : 0;
    const double bright = light_.beaming ? ratio * ratio * ratio : 1,
                 light = bright * found.emissivity * length / unit_cgs_ * spec_.brightness,
                 depth = found.absorptivity * length;
    const double c2 = std::cos(2 * angle), s2 = std::sin(2 * angle);
    return {depth,
            {depth * found.absorbed_q * c2, depth * found.absorbed_q * s2, depth * found.absorbed_v},
            {found.conversion * faraday * c2, found.conversion * faraday * s2, found.rotation * faraday},
            {light, light * found.emitted_q * c2, light * found.emitted_q * s2, light * found.emitted_v}};
}

RayStokes MatterStokes::at(const CameraAxes& from, Vec3 direction) const {
    CarriedRay ray(*carrying_, from.camera, from.tetrad, direction);
    const double azimuth = from.camera.phi - azimuth_ahead(*spacetime_, from.camera.r), farthest = model_->farthest();
    RayStokes seen{};
    for (std::size_t i = 0; i < 4; ++i) seen.through[i][i] = 1;
    CarriedAxes here = ray.now();
    double before = 0, now = 0;  // affine parameters of the last place and of this one
    for (int i = 0; i < kMostPieces && seen.through[0][0] > kOpaque; ++i) {
        const CarryingPlace place(*carrying_, here.place);
        const double beyond = place.r() - farthest;
        const Vec3 to_camera{here.k[1], here.k[2], here.k[3]};
        if (place.r() < nearest_ || (beyond > 0 && dot(to_camera, here.place) < 0)) break;
        const double panel = model_->panel({place.r(), place.direction()});
        if (!ray.advance(std::max(panel, kFarStep * beyond))) break;
        if (beyond <= 0) {  // as far as halfway to the places beside it
            const EvenLight found = even_light(matter_at(here, azimuth, 0.5 * (ray.affine() - before)));
            const Stokes light = product(seen.through, found.light);
            for (std::size_t n = 0; n < 4; ++n) seen.light[n] += light[n];
            seen.through = product(seen.through, found.through);
        }
        before = now, now = ray.affine(), here = ray.now();
    }
    return seen;
}

}  // namespace nullscope::reference
