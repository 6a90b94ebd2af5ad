// The worldline of a camera that is let go: a geodesic in proper time, with the camera's axes carried along parallel (gyroscopes).
//
// The motion stays in a plane. With E, L per rest mass, in ingoing coordinates (v, r), R' = dR/dr:
//     r'' = -(1/2) d/dr [A (1 + L^2/R^2)],  phi' = L/R^2,  v' = (E + r')/A = (1 + L^2/R^2)/(E - r').
// A vector X has M = X^v, N = A X^v - 2 X^r, Phi and n across, along the motion and along the plane's normal; parallel transport is
//     dM = -(A'/2) v' M + (L R'/R^2) Phi,  dN = (A'/2) v' N - A (L R'/R^2) Phi,  dPhi = -(L R'/R^2) (A M - N)/2,  dn = 0:
// regular at the horizon. In a radial frame (spacetime/radial_frame.h) X^t + X^r = outward M and X^t - X^r = N/outward.
// About a rotating hole: spin_worldline.h.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/vec.h"
#include "observer/spin_worldline.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope {

// kSurface: of a star; or as far inside a charged hole as there is a picture, or a rotating one.
enum class WorldlineEnd { kOpen, kSingularity, kSurface };

class Worldline {
public:
    // From the scene's camera at proper time 0 to `duration`, or to its end. Errors: no such observer. Relative error 1e-12 a dynamical
    // time (tests/unit/test_worldline.cpp). Some microseconds a step, hundreds of steps a plunge.
    static Result<Worldline> make(std::shared_ptr<const Spacetime> spacetime, const CameraSpec& start, double duration);

    // The camera at a proper time from 0 to last(): observer, velocity, place and turn; the rest as it was at the start. Rotations of the
    // start's own are kept by the axes. A microsecond.
    CameraSpec at(double tau) const;
    // phi of the camera at() with whole turns kept, rad: continuous in tau, at 0 at(0).phi. About a rotating hole it is ingoing, of v - r, whose
    // phi is ahead of a start that does not fall.
    double azimuth(double tau) const;
    // Proper time of the last picture: at the end short of the singularity by 1e-5 r_s/c.
    double last() const { return last_; }
    WorldlineEnd end() const { return end_; }
    // Proper time of the end itself, within 1e-10; last() where it is open.
    double end_time() const { return end_time_; }
    std::optional<double> horizon_time() const { return horizon_time_; }  // when the outer horizon is crossed
    double energy() const { return energy_; }
    // By how much Scene::time of the camera at() is later than that of the start: v - r about a hole, t where there is none. A start that
    // does not fall tells t, and v - r is ahead of it there (spacetime/tortoise.h).
    double clock(double tau) const;

private:
    static constexpr std::size_t kAxes = 12, kClock = 12, kSize = 13;
    using State = std::array<double, kSize>;  // r, r', phi, then M, N, Phi of three axes, then the clock
    struct Node {
        double tau;
        State state;
    };
    Worldline() = default;
    double v_slope(const State& state) const;
    State slope(const State& state) const;
    State step(const State& state, double h, double& error) const;
    State state_at(double tau) const;
    void run(double duration);
    void finish_at_singularity();
    double time_at_radius(double r) const;  // between the last two nodes
    std::shared_ptr<const Spacetime> spacetime_;
    CameraSpec start_;
    double energy_ = 1, momentum_ = 0, last_ = 0, end_time_ = 0, ahead_ = 0;
    Vec3 outward_, onward_, normal_;  // of the start, world axes: place, motion across, plane
    std::array<double, 3> across_{};  // n of the axes
    std::vector<Node> nodes_;
    WorldlineEnd end_ = WorldlineEnd::kOpen;
    std::optional<double> horizon_time_;
    std::shared_ptr<const SpinWorldline> spun_;  // about a rotating hole: instead of all but what is said of it
};

}  // namespace nullscope
