// The steps of kerr_lanes.h at one width. Included by what is compiled for the machines that have it: of nothing in here
// may there be a second instance, or one that is not for them could be taken for it.
#pragma once
#include <algorithm>
#include <cstddef>

#include "reference/kerr_lanes.h"
#include "reference/lanes.h"

namespace nullscope::reference {

template <std::size_t Width>
void flow_steps_of(const KerrFlow& flow, FlowTask<double>* const* tasks, std::size_t count) {
    using Real = Lanes<Width>;
    for (std::size_t first = 0; first < count; first += Width) {
        const FlowTask<double>* from[Width];  // the last one again where there are no more
        for (std::size_t i = 0; i < Width; ++i) from[i] = tasks[first + i < count ? first + i : count - 1];
        const auto load = [&](const auto& member) {
            Real lanes;
            for (std::size_t i = 0; i < Width; ++i) lanes.v[i] = member(*from[i]);
            return lanes;
        };
        FlowTask<Real> task;
        using One = FlowTask<double>;
        task.ray = {load([](const One& t) { return t.ray.energy; }), load([](const One& t) { return t.ray.j_z; }),
                    load([](const One& t) { return t.ray.far; }), load([](const One& t) { return t.ray.logarithm; })};
        for (std::size_t n = 0; n < kFlowSize; ++n)
            task.start[n] = load([n](const One& t) { return t.start.data()[n]; });
        task.length = load([](const One& t) { return t.length; });
        task.j_weight = load([](const One& t) { return t.j_weight; });
        task.u_weight = load([](const One& t) { return t.u_weight; });
        task.c_weight = load([](const One& t) { return t.c_weight; });
        FlowStep<Real>(flow, task);
        for (std::size_t i = 0; i < Width && first + i < count; ++i) {
            One& to = *tasks[first + i];
            for (std::size_t n = 0; n < kFlowSize; ++n) to.end.data()[n] = task.end[n].v[i];
            to.fifth = task.fifth.v[i], to.third = task.third.v[i];
        }
    }
}

}  // namespace nullscope::reference
