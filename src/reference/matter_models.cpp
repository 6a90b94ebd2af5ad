// Matter along rays, for the reference: all models but the gas (matter_gas.cpp).
#include <algorithm>
#include <cmath>

#include "expr/formula.h"
#include "plan/dump_window.h"
#include "reference/matter_model.h"
#include "reference/medium_grid.h"
#include "scene/medium_dumps.h"
#include "spacetime/registry.h"
#include "spacetime/tortoise.h"

namespace nullscope::reference {
namespace {

expr::Formula parsed(const std::string& text) {
    auto formula = expr::Formula::parse(text, medium_variables());
    return formula ? std::move(*formula) : *expr::Formula::parse("0", {});  // scene files are checked
}

double at_place(const expr::Formula& formula, const MediumNode& node, double time) {
    const Vec3 place = node.r * node.direction;
    const double at[] = {place.x, place.y, place.z, node.r, time};
    return formula.value(at);
}

// Temperature and field by formulas, of models that have none of their own.
class WarmModel : public MatterModel {
public:
    WarmModel(const Scene& scene, const Metric& metric)
        : MatterModel(scene, metric),
          temperature_(parsed(spec_.formulas.temperature)),
          field_(parsed(spec_.formulas.field)) {}
    // Their formulas may depend on the azimuth.
    double turn() const override { return spec_.by_place() ? farthest_ / 64 : 0; }

protected:
    MatterState warm(const MediumNode& node, double density, Vec3 velocity) const {
        return {
            density, at_place(temperature_, node, time_of(node)), at_place(field_, node, time_of(node)), {}, velocity};
    }

private:
    expr::Formula temperature_, field_;
};

class FlowModel final : public WarmModel {
public:
    using WarmModel::WarmModel;
    bool goes_round() const override { return true; }

    double panel(const MatterPlace& place) const override {
        const FlowMatter& flow = spec_.flow;
        double scale = std::min({flow.radius, place.r, std::max(place.r - horizon_, kMediumAboveHorizon)});
        if (place.r > farthest_) scale = std::max(scale, (place.r - farthest_) / kMatterPanel);
        if (flow.flattening > 0) {
            const double thick = 1 / std::max(flow.flattening, 1.0), off = std::abs(place.direction.z);
            scale = std::min(scale, place.r * std::max(thick, (off - kFlowScales * thick) / kMatterPanel));
        }
        return kMatterPanel * scale;
    }

    std::optional<MatterState> at(const MediumNode& node, const PlaceMetric& g) const override {
        const FlowMatter& flow = spec_.flow;
        const double around = node.r * node.sine() / 0.5,
                     l = flow.momentum * std::pow(around, 1.5) / (1 + around) * 0.5;  // of M, in r_s
        const double height = flow.flattening * node.cosine(), x = node.r / flow.radius;
        return warm(node, spec_.density_scale * std::exp(-0.5 * (x * x + height * height)),
                    velocity_with_momentum(g, l));
    }
};

// Within a sphere and a slab, where it may end sharply. The horizon and these ends are the same all round: azimuth counts by turn().
double panel_in_sphere(const MediumSpec& spec, double horizon, const MatterPlace& place) {
    constexpr double kInner = 0.5, kEdge = 1e-7,
                     kNearCentre = 0.02;  // of a sample of the shader, of the sphere at its edges, of r
    const double z = std::abs(place.flat().z),
                 off = std::min(std::abs(place.r - spec.outer), std::abs(z - spec.height)),
                 outside = std::max(place.r - spec.outer, z - spec.height);
    double inner = kInner * spec.outer / spec.steps;
    // About the centre of flat space the swept angle is of little use.
    inner = std::min(inner, horizon > 0 ? kMatterPanel * (place.r - horizon) : kNearCentre * place.r);
    return outside > 0 ? std::max(outside, kEdge * spec.outer) : std::min(inner, std::max(off, kEdge * spec.outer));
}
bool in_sphere(const MediumSpec& spec, const MediumNode& node) {
    return node.r <= spec.outer && std::abs(node.r * node.cosine()) <= spec.height;
}

class FormulaModel final : public WarmModel {
public:
    FormulaModel(const Scene& scene, const Metric& metric)
        : WarmModel(scene, metric),
          density_(parsed(spec_.formulas.density)),
          outward_(parsed(spec_.formulas.outward)),
          south_(parsed(spec_.formulas.south)),
          east_(parsed(spec_.formulas.east)) {}
    double panel(const MatterPlace& place) const override { return panel_in_sphere(spec_, horizon_, place); }
    double turn() const override { return spec_.outer / spec_.steps; }

    std::optional<MatterState> at(const MediumNode& node, const PlaceMetric&) const override {
        if (!in_sphere(spec_, node)) return std::nullopt;
        const double time = time_of(node);
        const auto speed = [&](const expr::Formula& f) {
            return std::clamp(at_place(f, node, time), -kFastestMatter, kFastestMatter);
        };
        return warm(node, spec_.density_scale * std::max(at_place(density_, node, time), 0.0),
                    {speed(outward_), speed(south_), speed(east_)});
    }

private:
    expr::Formula density_, outward_, south_, east_;
};

class FileModel : public MatterModel {
public:
    FileModel(const Scene& scene, const Metric& metric) : MatterModel(scene, metric) {
        if (has_slow_light(scene)) return;
        if (const auto grid = medium_grid_at(scene)) grid_ = *grid;  // scene files are checked
    }
    double panel(const MatterPlace& place) const override { return panel_in_sphere(spec_, horizon_, place); }
    double turn() const override { return spec_.outer / spec_.steps; }

    std::optional<MatterState> at(const MediumNode& node, const PlaceMetric&) const override {
        if (!grid_ || !in_sphere(spec_, node)) return std::nullopt;
        return grid_matter(*grid_, spec_.density_scale, horizon_, node.r, std::atan2(node.sine(), node.cosine()),
                           std::atan2(node.direction.y, node.direction.x));
    }

private:
    std::shared_ptr<const MediumGrid> grid_;
};

// Dumps, each place at its own time.
class SlowFileModel final : public FileModel {
public:
    SlowFileModel(const Scene& scene, const Metric& metric) : FileModel(scene, metric) {
        const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
        const auto form = medium_form(scene);
        if (!spacetime || !form) return;  // read_matter() says why
        window_ = dump_window(**spacetime, scene, *form);
        if (const auto grids = medium_grids(spec_.grid, window_.first, window_.last)) grids_ = *grids;
        if (form->kerr_schild() && horizon_ > 0 && scene.light.delay) spacetime_ = *spacetime;
    }

    std::optional<MatterState> at(const MediumNode& node, const PlaceMetric&) const override {
        if (!grids_ || !in_sphere(spec_, node)) return std::nullopt;
        const double ahead = spacetime_ ? time_ahead(*spacetime_, node.r) : 0,
                     last = static_cast<double>(grids_->size() - 1);
        const double dump =
            std::clamp((time_of(node) + ahead - spec_.grid.start) / spec_.grid.cadence - window_.first, 0.0, last);
        const auto low = static_cast<std::size_t>(dump), high = std::min(low + 1, grids_->size() - 1);
        return grid_matter(GridMoment{*(*grids_)[low], *(*grids_)[high], dump - static_cast<double>(low)},
                           spec_.density_scale, horizon_, node.r, std::atan2(node.sine(), node.cosine()),
                           std::atan2(node.direction.y, node.direction.x));
    }

private:
    std::shared_ptr<const MediumGrids> grids_;
    DumpWindow window_{};
    std::shared_ptr<const Spacetime> spacetime_;  // nullptr: the dumps' clock is t
};

class JetModel final : public WarmModel {
public:
    using WarmModel::WarmModel;

    double panel(const MatterPlace& place) const override {
        const double opening = spec_.jet.opening,
                     off = std::atan2(place.off_axis(), std::abs(place.flat().z)) - opening,
                     beside = off > 0 ? place.r * std::sin(off) : 0,
                     free = std::max({spec_.inner - place.r, place.r - spec_.outer, beside});
        const double scale =
            std::min({place.r * opening, place.r * rim(), std::max(place.r - horizon_, kMediumAboveHorizon)});
        return std::max(kMatterPanel * scale, free);
    }

    std::optional<MatterState> at(const MediumNode& node, const PlaceMetric&) const override {
        const double side = node.sine() / std::sin(spec_.jet.opening), across = 1 - side * side;
        const double in = std::min(std::log(node.r / spec_.inner), std::log(spec_.outer / node.r)) / rim(),
                     end = std::clamp(in, 0.0, 1.0);
        if (across <= 0 || end == 0) return std::nullopt;
        const double density =
            across * across * end * end * (3 - 2 * end) * std::pow(spec_.inner / node.r, spec_.jet.falloff);
        return warm(node, spec_.density_scale * density, {std::sqrt(spec_.jet.lorentz * spec_.jet.lorentz - 1), 0, 0});
    }

private:
    double rim() const { return std::min(spec_.edge, 0.5 * std::log(spec_.outer / spec_.inner)); }
};

template <class Model>
std::unique_ptr<MatterModel> made(const Scene& scene, const Metric& metric) {
    return std::make_unique<Model>(scene, metric);
}
constexpr std::unique_ptr<MatterModel> (*kModels[kMediumKinds])(const Scene&, const Metric&) = {
    make_gas, made<FlowModel>, made<FormulaModel>, made<FileModel>, made<JetModel>};  // by MediumKind

}  // namespace

std::unique_ptr<MatterModel> make_matter(const Scene& scene, const Metric& metric) {
    if (has_slow_light(scene)) return made<SlowFileModel>(scene, metric);
    return kModels[static_cast<std::size_t>(scene.medium->kind)](scene, metric);
}

Status read_matter(const Spacetime& spacetime, const Scene& scene) {
    if (!has_slow_light(scene)) return Done{};
    TRY(form, medium_form(scene));
    const DumpWindow window = dump_window(spacetime, scene, *form);
    TRY(grids, medium_grids(scene.medium->grid, window.first, window.last));
    return Done{};
}

Vec3 velocity_at_rate(const PlaceMetric& g, double rate) {
    const double lapse2 = g.g_tphi * g.g_tphi / g.g_phiphi - g.g_tt,
                 speed = (rate + g.g_tphi / g.g_phiphi) * std::sqrt(g.g_phiphi / lapse2);
    return {0, 0, speed / std::sqrt(1 - speed * speed)};
}

Vec3 velocity_with_momentum(const PlaceMetric& g, double l) {
    // u_mu = u_t (-1, 0, 0, l) up to a factor; from u.u = -1.
    const double det = g.g_tt * g.g_phiphi - g.g_tphi * g.g_tphi;
    const double up_tt = g.g_phiphi / det, up_tphi = -g.g_tphi / det, up_phiphi = g.g_tt / det;
    const double scale = 1 / std::sqrt(-(up_tt - 2 * up_tphi * l + up_phiphi * l * l));
    return {0, 0, scale * l / std::sqrt(g.g_phiphi)};
}

}  // namespace nullscope::reference
