// One ray about a rotating hole as it is traced: it says which step it wants (FlowTask), whoever carries steps out does
// so, one or several rays' at a time, and it takes the result. Everything but the step itself is here.
#pragma once
#include <optional>

#include "reference/kerr_between.h"
#include "reference/kerr_flow.h"
#include "reference/kerr_launch.h"
#include "reference/kerr_ray.h"
#include "reference/kerr_step.h"

namespace nullscope::reference {

class KerrTrace {
public:
    // The camera's clock less t is base + (r_* - r, or for what fell in the other way round) + the chart's own time,
    // see delay(); T counts from the camera's `from`. along: where the ray begins.
    struct Start {
        long double base, from;
        double along = 0;
    };
    // watch: outlives this; or null.
    KerrTrace(const KerrHole& hole, const KerrLaunch& launch, const Start& start, int most_crossings,
              const KerrWatch* watch);
    // Until then `wanted` is to be carried out (FlowStep) and taken.
    bool done() const { return done_; }
    FlowTask<double>& wanted() { return task_; }
    void take();
    KerrRay& ray() { return ray_; }
    const KerrFlow& flow() const { return flow_; }

private:
    using State = FlowState<double>;
    // What does not change until a photon is followed as its mirror image.
    struct Leg {
        double phi = 0, energy = 0, j_z = 0;
        double sense = 1;  // 1: the mirror image, forward; -1: the photon itself, backward
        long double base = 0;
    };
    // Where a step begins, with what is needed to go on from there.
    struct Here {
        Leg leg{};
        State state{};
        double along = 0, azimuth = 0;  // in the chart, windings kept
        FlowClock clock = FlowClock::kNear;
        long double time = 0;  // the chart's since the start, but for what the clock has of it
    };
    // The zero of z within a step that has been accepted.
    struct Crossing {
        State end;
        double taken, low, high, at;
        int tries = 0;
    };

    void begin(const KerrLaunch& launch, const Start& start);
    static FlowRay<double> flow_ray(const Here& from);
    State slope(const Here& from, const State& s) const;
    State stepped(const Here& from, double length) const;
    static KerrPhase phase(const Here& from, const State& s);
    double radius(const State& s) const;
    double momentum(const State& s) const {
        return std::sqrt(s[3] * s[3] + s[4] * s[4] + here_.leg.j_z * here_.leg.j_z);
    }
    double turned(const Here& from, const State& to, double length) const;
    double dragging(const Here& from, const State& s) const;

    void want(double length);
    void want_step();
    double longest_step(double length) const;
    double near_sky(double j) const;
    double sky_at(double j) const;
    bool at_sky(const State& s) const { return s[6] > 0 && s[5] < sky_at(momentum(s)); }
    void take_step();
    void take_crossing();
    void seek_crossing(const State& end, double taken);
    void add_crossing(const State& there, double at);
    void go_on(const State& state, double taken);
    void straighten();
    void set_clock();
    void follow_mirrored(double r);
    void reach_sky();

    static long double clock_time(const Here& from, const State& s);
    double delay(const Here& from, const State& s) const;
    double delay_from_sky() const;
    // Boyer and Lindquist's azimuth of a state that a length of the step from `from` leads to.
    double azimuth(const Here& from, const State& s, double length, double r) const {
        return from.leg.phi - from.leg.sense * (from.azimuth + turned(from, s, length) - chart_.ahead(r));
    }
    // Looks along a step (kerr_looks.cpp).
    using Between = HermiteNinth<kFlowSize>;
    struct Looks;
    KerrPlace place_of(const Here& from, const State& s, double length) const;
    KerrMotion motion_of(const Here& from, const State& s, double length) const;
    Between between(const Here& from, const State& end, double taken) const;
    KerrGlance glance(const Here& from, const Between::Known& there, double taken, bool timed) const;
    void show(const State& end, double taken) const;

    KerrChart chart_;
    KerrFlow flow_;
    int most_crossings_;
    const KerrWatch* watch_;
    KerrRay ray_;
    bool done_ = false;

    double outer_;
    long double from_ = 0;  // Start's
    bool stays_ = false, outside_ = true;
    Here here_;
    double length_ = 0;
    int steps_ = 0;
    FlowTask<double> task_{};
    std::optional<Crossing> crossing_;
};

// How a photon begins.
KerrTrace begin_trace(const KerrHole& hole, const KerrStart& start, int most_crossings, const KerrWatch* watch);
KerrTrace begin_trace(const KerrHole& hole, const KerrPhoton& photon, int most_crossings, bool falls,
                      const KerrWatch* watch);

}  // namespace nullscope::reference
