// The edge of a rotating hole's shadow, as an observer far away in the equatorial plane has it drawn.
#pragma once

#include <algorithm>
#include <cmath>

#include "observer/spin_forms.h"
#include "spacetime/registry.h"
#include "support/gpu_session.h"
#include "support/metrics.h"

namespace nullscope::test {

constexpr double kEdge_px = 0.02;                 // what is promised of the shadow's edge
constexpr double kFar = 1000.0;                   // of the observer, r_s
constexpr double kPixel_rad = 6.0 / kFar / 1080;  // the shadow, some 11 M wide, fills a 1080p frame
constexpr int kColumns = 401;

struct Edge {
    double lambda, eta;  // L/E in M and Carter's constant over E^2 in M^2, of the ray on the edge
    bool vertical;       // the edge is crossed along a column of pixels
    int outside;         // to the right or upwards: +1
};

// How far from the middle of a line of pixels, to the right or upwards, the furthest on the wrong side of it is, px; step: from one to the
// next, px; outside: where rays come out, as Edge's.
inline double furthest_wrong_px(const RayFrame& frame, double step, int outside) {
    double worst = 0;
    for (int i = 0; i < kColumns; ++i) {
        const double from = (i - kColumns / 2) * step * outside;
        const RayPixel& pixel = frame.width == 1 ? frame.at(0, kColumns - 1 - i) : frame.at(i, 0);
        if ((pixel.fate == Fate::kEscaped) != (from > 0)) worst = std::max(worst, std::abs(from));
    }
    return worst;
}

// A line of pixels across the edge, +-2 kEdge_px wide; how far from its middle the furthest pixel with the wrong fate is, px.
inline double edge_off_px(GpuSession& session, Scene scene, const Edge& edge, double shift_px) {
    scene.sky.kind = SkyKind::kBlack;
    CameraSpec& camera = scene.camera;
    camera.r = kFar;
    camera.theta = M_PI / 2;
    const auto metric = axial(*make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    const SpinPlace place = spin_place(*metric, camera.r, camera.theta);
    const SpinForms f = spin_forms(place, zamo_frame(place));
    const double lambda = 0.5 * edge.lambda;  // r_s
    const double n_phi = lambda * f.energy.constant / (f.across.around - lambda * f.energy.around),
                 energy = f.energy.of(0, n_phi);
    const double n_theta = 0.5 * std::sqrt(std::max(edge.eta, 0.0)) * energy / f.p_theta;  // energy < 0: up
    const double n_r = -std::sqrt(1 - n_theta * n_theta - n_phi * n_phi);
    camera.yaw = std::atan2(n_phi, -n_r);
    camera.pitch = std::atan2(-n_theta, std::hypot(n_phi, n_r));
    (edge.vertical ? camera.pitch : camera.yaw) += shift_px * kPixel_rad;
    camera.width = edge.vertical ? 1 : kColumns;
    camera.height = edge.vertical ? kColumns : 1;
    const double step = 4 * kEdge_px / kColumns;
    camera.plane_width = step * kPixel_rad * camera.width;
    const RayFrame frame = gl_ray_data(session, scene);
    return furthest_wrong_px(frame, step, edge.outside);
}

}  // namespace nullscope::test
