// A soft disc of gas, for the reference.
#include <algorithm>
#include <cmath>

#include "reference/matter_model.h"
#include "reference/noise_ring.h"

namespace nullscope::reference {
namespace {

class GasModel final : public MatterModel {
public:
    using MatterModel::MatterModel;
    bool all_round() const override { return false; }
    bool goes_round() const override { return true; }

    double panel(const MatterPlace& place) const override {
        constexpr double kGasPanel = 0.05;  // of the scale height, where clumps are
        const double thickness = spec_.gas.thickness, rho = place.off_axis(), z = std::abs(place.flat().z),
                     height = thickness * rho;
        const double off = (z - kGasHeights * height) / std::hypot(1.0, kGasHeights * thickness);
        return std::max(
            {kGasPanel * thickness * std::max(rho, spec_.inner), spec_.inner - rho, rho - spec_.outer, off});
    }

    // On circles; of a black body: its opacity is 1 an r_s.
    std::optional<MatterState> at(const MediumNode& node, const PlaceMetric& g) const override {
        const double rho = node.r * node.sine(), heights = node.r * node.cosine() / (spec_.gas.thickness * rho);
        const double in = std::min(std::log(rho / spec_.inner), std::log(spec_.outer / rho)) / spec_.edge,
                     rim = std::clamp(in, 0.0, 1.0);
        if (rim == 0 || std::abs(heights) > kGasHeights) return std::nullopt;
        const double age = spec_.gas.flow == DiscFlowKind::kKepler ? time_of(node) : 0.0;
        const double density = rim * rim * (3 - 2 * rim) * std::exp(-0.5 * heights * heights) *
                               clumps(rho, heights, std::atan2(node.direction.y, node.direction.x), age);
        const double temperature = spec_.temperature_K * std::sqrt(spec_.inner / rho * std::sqrt(spec_.inner / rho));
        const double opaque = spec_.gas.optical_depth / (std::sqrt(2 * M_PI) * spec_.gas.thickness * rho);
        return MatterState{density * opaque, temperature, 0, {}, velocity_at_rate(g, metric_.kepler_rate(rho, sense_))};
    }

private:
    // A factor on the density, of mean 1. Octaves of rings of equal ln(rho), which are cones, turned with the height.
    double clumps(double rho, double heights, double azimuth, double age) const {
        constexpr int kOctaves = 4;
        const double x = std::log(rho);
        double moved = x, density = 1, steeper = 1, flatter = 1, contrast = spec_.gas.clumps.contrast;
        for (int octave = 0; octave < kOctaves; ++octave) {
            const double sign = octave % 2 == 0 ? 1 : -1, ring_step = 0.3 / (1 << octave), first = 0.37 * octave,
                         tilt = sign * 0.7 * steeper * heights, row = moved / ring_step + first + tilt,
                         ring = std::floor(row), lean = sign * 0.35 / 8 * flatter * heights;
            const auto noise_of = [&](double number) {
                const double middle = (number - first) * ring_step,
                             went = age != 0 ? metric_.kepler_rate(std::exp(middle), sense_) * age : 0.0,
                             turns = (azimuth + sense_ * spec_.gas.clumps.winding * (x - middle) - went) / (2 * M_PI);
                return NoiseRing(static_cast<long long>(number), static_cast<unsigned>(octave)).noise(turns + lean);
            };
            const double n = NoiseRing::blend(noise_of(ring), noise_of(ring + 1), row - ring), c = contrast;
            density *= (1 + c * n) * (1 + c * n) / (1 + c * c / 3);
            moved += 0.4 * ring_step * n;
            steeper *= 1.6, flatter *= 0.8, contrast *= 0.82;
        }
        return density;
    }
    double sense_ = metric_.sense(spec_.gas.sense);
};

}  // namespace

std::unique_ptr<MatterModel> make_gas(const Scene& scene, const Metric& metric) {
    return std::make_unique<GasModel>(scene, metric);
}

}  // namespace nullscope::reference
