#include "reference/kerr_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "reference/kerr_lanes.h"
#include "reference/kerr_trace.h"

namespace nullscope::reference {
namespace {

KerrRay traced(KerrTrace trace) {
    while (!trace.done()) {
        FlowStep<double>(trace.flow(), trace.wanted());
        trace.take();
    }
    return std::move(trace.ray());
}

}  // namespace

Vec3 KerrPlace::flat() const {
    return r * Vec3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double way_between(const KerrPlace& from, const KerrPlace& to) {
    const double sine = std::max(std::sin(from.theta), std::sin(to.theta));
    return std::hypot(to.r - from.r,
                      std::max(from.r, to.r) * std::hypot(to.theta - from.theta, sine * (to.phi - from.phi)));
}

KerrRay trace_kerr(const KerrHole& hole, const KerrStart& start, int most_crossings, const KerrWatch& watch) {
    return traced(begin_trace(hole, start, most_crossings, watch ? &watch : nullptr));
}

KerrRay trace_kerr(const KerrHole& hole, const KerrPhoton& photon, int most_crossings, bool falls,
                   const KerrWatch& watch) {
    return traced(begin_trace(hole, photon, most_crossings, falls, watch ? &watch : nullptr));
}

std::vector<KerrRay> trace_kerr(const KerrHole& hole, const std::vector<KerrPhoton>& photons, int most_crossings,
                                bool falls, const std::vector<KerrWatch>& watches) {
    constexpr std::size_t kTogether = 8;  // the widest lanes there are
    struct Slot {
        std::unique_ptr<KerrTrace> trace;  // of which steps that are looked at know the address
        std::size_t number;
    };
    std::vector<KerrRay> rays(photons.size());
    std::vector<Slot> slots;
    slots.reserve(kTogether);
    const KerrFlow flow(hole);
    std::size_t next = 0;
    while (true) {
        for (std::size_t i = 0; i < slots.size();) {
            if (slots[i].trace->done()) {
                rays[slots[i].number] = std::move(slots[i].trace->ray());
                if (i + 1 < slots.size()) slots[i] = std::move(slots.back());
                slots.pop_back();
            } else {
                ++i;
            }
        }
        for (; next < photons.size() && slots.size() < kTogether; ++next) {
            const KerrWatch* watch = watches.empty() || !watches[next] ? nullptr : &watches[next];
            slots.push_back(
                {std::make_unique<KerrTrace>(begin_trace(hole, photons[next], most_crossings, falls, watch)), next});
        }
        if (slots.empty()) return rays;
        std::array<FlowTask<double>*, kTogether> tasks{};
        std::size_t count = 0;
        for (Slot& slot : slots)
            if (!slot.trace->done()) tasks[count++] = &slot.trace->wanted();
        if (count > 0) flow_steps(flow, tasks.data(), count);
        for (Slot& slot : slots)
            if (!slot.trace->done()) slot.trace->take();
    }
}

double kerr_azimuth_ahead(const KerrHole& hole, double r) {
    const KerrChart chart{hole};
    return chart.ahead(r) - std::atan2(chart.a, r);
}

}  // namespace nullscope::reference
