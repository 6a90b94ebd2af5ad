// The worldline of a camera in free fall about a rotating hole: a geodesic in proper time with its axes carried along parallel, in
// Cartesian Kerr-Schild coordinates, x + iy = (r + ia) sin(theta) e^{i phi~}, z = r cos(theta), t = v - r:
//     g = eta + f l l,  f = 2 m(r) r^3/(r^4 + a^2 z^2),  l = (1, (r x + a y)/(r^2 + a^2), (r y - a x)/(r^2 + a^2), z/r).
// Regular on the outer horizon and on the axis; nothing of it is separated, so that E, L and Carter's constant check it
// (tests/unit/test_spin_worldline.cpp).
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

class SpinWorldline {
public:
    // As Worldline::make. Ends short of the inner horizon, by a twentieth of the way between both.
    static Result<SpinWorldline> make(std::shared_ptr<const Spacetime> spacetime, const CameraSpec& start,
                                      double duration);
    CameraSpec at(double tau) const;  // falling with energy 1 and a velocity in that frame
    double last() const { return nodes_.back().tau; }
    bool reaches_inner_horizon() const { return ends_; }
    std::optional<double> horizon_time() const { return horizon_time_; }

    // Of the motion now: constant along it, to 1e-10.
    struct Constants {
        double energy, momentum, carter, norm;  // -u_t, u_phi, K, u . u
    };
    Constants constants(double tau) const;
    double energy() const { return constants(0).energy; }
    double clock(double tau) const;    // as Worldline's
    double azimuth(double tau) const;  // phi~ since the start, turns kept

private:
    static constexpr std::size_t kVectors = 4, kClock = 3 + 4 * kVectors, kSize = kClock + 1;
    // x, y, z; then (t, x, y, z) of the velocity and of right, up, backward; t.
    using State = std::array<double, kSize>;
    struct Node {
        double tau;
        State state;
        double azimuth;
    };
    SpinWorldline() = default;
    const AxialMetric& metric() const;
    void run(double duration);
    Node node_at(double tau) const;
    std::shared_ptr<const Spacetime> spacetime_;
    CameraSpec start_;
    std::vector<Node> nodes_;
    bool ends_ = false;
    double ahead_ = 0;
    std::optional<double> horizon_time_;
};

}  // namespace nullscope
