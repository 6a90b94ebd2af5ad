#include "table/camera_tables.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nullscope {
namespace {

constexpr double kSameResolution = 1e-9;  // relative: it comes in steps of 16

bool alike(double one, double other) { return std::fabs(one / other - 1.0) < kSameResolution; }

double resolution_of(const RayFamily& family) { return family.w0() / family.critical_angle(); }

int most_octaves(const RayFamily& family) {
    return std::max(family.octaves(Segment::kSky), family.octaves(Segment::kCaptured));
}

// Lagrange's at 0 < t < 1 of values at -1, 0, 1, 2.
std::array<float, 4> cubic_weights(double t) {
    return {static_cast<float>(-t * (t - 1) * (t - 2) / 6), static_cast<float>((t + 1) * (t - 1) * (t - 2) / 2),
            static_cast<float>(-(t + 1) * t * (t - 2) / 2), static_cast<float>((t + 1) * t * (t - 1) / 6)};
}

// The first columns and rows of four grids.
TexelGrid mixed(const std::array<const TexelGrid*, 4>& grids, const std::array<float, 4>& w, int width, int height) {
    TexelGrid mix{width, height, std::vector<float>(static_cast<std::size_t>(width) * height * 4)};
    constexpr int kRowsATask = 16;
    tbb::parallel_for(0, (height + kRowsATask - 1) / kRowsATask, [&](int task) {
        for (int row = task * kRowsATask; row < std::min(height, (task + 1) * kRowsATask); ++row) {
            const auto line = [row](const TexelGrid& grid) {
                return grid.texels.data() + static_cast<std::size_t>(row) * grid.width * 4;
            };
            const float *a = line(*grids[0]), *b = line(*grids[1]), *c = line(*grids[2]), *d = line(*grids[3]);
            float* out = mix.texels.data() + static_cast<std::size_t>(row) * width * 4;
            for (int i = 0; i < 4 * width; ++i) out[i] = w[0] * a[i] + w[1] * b[i] + w[2] * c[i] + w[3] * d[i];
        }
    });
    return mix;
}

}  // namespace

CameraTables build_camera_tables(const RayFamily& family, WantedTables wanted) {
    return {build_strip(family), wanted.orbits ? build_orbit_table(family, wanted.delays) : OrbitTable{}};
}

// Where the radius is all that a family depends on, and smoothly.
bool RadiusSteps::serves(const RayFamily& family) const {
    const SphericalMetric& metric = family.spacetime();
    return metric.inner_end() == InnerEnd::kHorizon && !metric.by_proper_length() && !metric.barrier() &&
           metric.potential() == nullptr && !metric.surface_radius() &&
           family.camera_r() > kNearest * std::exp(2.0 / kStepsPerUnit) * metric.photon_sphere()->radius &&
           family.frame() == frame_at_rest(metric.lapse_squared(family.camera_r()));
}

std::optional<CameraTables> RadiusSteps::tables(const RayFamily& family, double pixel, WantedTables wanted) {
    const double x = std::log(family.camera_r()) * kStepsPerUnit, resolution = resolution_of(family);
    const double move = last_ ? x - *last_ : INFINITY;
    last_ = x;
    const bool other = wanted_ != wanted || !alike(resolution_, resolution);
    wanted_ = wanted;
    resolution_ = resolution;
    if (other) nodes_.clear();
    if (other || !serves(family) || !(std::fabs(move) <= kLongestMove)) return std::nullopt;
    const int step = static_cast<int>(std::floor(x));
    std::erase_if(nodes_, [&](const Node& node) { return node.step < step - 2 || node.step > step + 3; });
    const bool outward = move > 0.0, leaves = outward == (x - step > 0.5);
    const std::array<int, 5> due{step, step + 1, step - 1, step + 2, leaves ? (outward ? step + 3 : step - 2) : step};
    const auto missing = std::find_if(due.begin(), due.end(), [&](int each) { return find(each) == nullptr; });
    if (missing != due.end()) {
        if (auto node = node_at(*missing, family, pixel)) nodes_.push_back(std::move(*node));
    }
    return between(family, x - step, step);
}

const RadiusSteps::Node* RadiusSteps::find(int step) const {
    const auto at = std::find_if(nodes_.begin(), nodes_.end(), [&](const Node& node) { return node.step == step; });
    return at == nodes_.end() ? nullptr : &*at;
}

std::optional<RadiusSteps::Node> RadiusSteps::node_at(int step, const RayFamily& like, double pixel) const {
    const SphericalMetric& metric = like.spacetime();
    const double r = std::exp(step / kStepsPerUnit);
    if (!camera_can_rest(metric, r)) return std::nullopt;
    RayFamily family(metric_, table_, r, frame_at_rest(metric.lapse_squared(r)), pixel);
    if (!alike(resolution_of(family), resolution_)) return std::nullopt;
    family.add_octave();  // lest one of the cameras between has more of them
    return Node{step, most_octaves(family), build_camera_tables(family, wanted_)};
}

// t: from `step` to the next one.
std::optional<CameraTables> RadiusSteps::between(const RayFamily& family, double t, int step) const {
    std::array<const Node*, 4> nodes{};
    const int most = most_octaves(family);
    for (int i = 0; i < 4; ++i) {
        nodes[i] = find(step - 1 + i);
        if (nodes[i] == nullptr || nodes[i]->octaves < most) return std::nullopt;
    }
    const auto weights = cubic_weights(t);
    const auto mix = [&](const auto& grid_of, std::optional<int> rows) {
        std::array<const TexelGrid*, 4> grids{};
        for (std::size_t i = 0; i < 4; ++i) grids[i] = &grid_of(nodes[i]->tables);
        const int width = rows ? grids[0]->width : grids[0]->width / nodes[0]->octaves * most;
        return mixed(grids, weights, width, rows.value_or(grids[0]->height));
    };
    const auto sky = [](const CameraTables& tables) -> const TexelGrid& { return tables.strip.sky; };
    const auto ends = [](const CameraTables& tables) -> const TexelGrid& { return tables.strip.ends; };
    const auto places = [](const CameraTables& tables) -> const TexelGrid& { return tables.orbits.places; };
    const auto delays = [](const CameraTables& tables) -> const TexelGrid& { return tables.orbits.delays; };
    CameraTables between;
    between.strip = {mix(sky, family.octaves(Segment::kSky)), mix(ends, {})};
    if (wanted_.orbits) between.orbits.places = mix(places, {});
    if (wanted_.delays) between.orbits.delays = mix(delays, {});
    return between;
}

}  // namespace nullscope
