// What a picture fetches about the rays of one family, and the same for a camera that moves along the radius, without integrating
// an orbit a frame.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "table/orbit_table.h"
#include "table/ray_family.h"
#include "table/strip.h"

namespace nullscope {

struct CameraTables {
    Strip strip;
    OrbitTable orbits;  // empty parts: not wanted
};

struct WantedTables {
    bool orbits = false, delays = false;
    friend bool operator==(const WantedTables&, const WantedTables&) = default;
};

CameraTables build_camera_tables(const RayFamily& family, WantedTables wanted);

// Tables at fixed steps of ln r, and cubics between four of them: for a camera at rest further out than kNearest photon spheres of a metric
// with a horizon; others get none. What is drawn with them is within 1e-3 px of what is drawn with tables built for the radius
// (tests/gpu/test_camera_tables.cpp). Not thread-safe.
class RadiusSteps {
public:
    RadiusSteps(std::shared_ptr<const SphericalMetric> metric, std::shared_ptr<const DeflectionTable> table)
        : metric_(std::move(metric)), table_(std::move(table)) {}

    // Of a camera at most kLongestMove steps from the last call's; nothing: build them. The tables at one step at most are made a call, those
    // ahead of a camera before they are needed; a call that makes none takes 0.8 core-milliseconds. pixel: the family's.
    std::optional<CameraTables> tables(const RayFamily& family, double pixel, WantedTables wanted);

    static constexpr double kStepsPerUnit = 32.0;  // of ln r
    static constexpr double kLongestMove = 0.5;    // of a step
    static constexpr double kNearest = 1.25;

private:
    struct Node {
        int step, octaves;
        CameraTables tables;
    };
    bool serves(const RayFamily& family) const;
    const Node* find(int step) const;
    std::optional<Node> node_at(int step, const RayFamily& like, double pixel) const;
    std::optional<CameraTables> between(const RayFamily& family, double t, int step) const;

    std::shared_ptr<const SphericalMetric> metric_;
    std::shared_ptr<const DeflectionTable> table_;
    WantedTables wanted_;
    double resolution_ = 0.0;     // w0 over the critical angle
    std::optional<double> last_;  // place of the last call, in steps
    std::vector<Node> nodes_;
};

}  // namespace nullscope
