// Steps of several rays about one rotating hole at a time, as many in one instruction as the machine has lanes for. The
// results are those of FlowStep<double>, the same bits, on whatever machine.
#pragma once
#include <array>
#include <cstddef>

#include "reference/kerr_flow.h"
#include "reference/kerr_step.h"

namespace nullscope::reference {

using FlowSteps = void (*)(const KerrFlow& flow, FlowTask<double>* const* tasks, std::size_t count);

// Ways to carry steps out: the lanes of any machine, of AVX2 and of AVX-512. Null where this machine has no such lanes.
std::array<FlowSteps, 3> all_flow_steps();
void flow_steps(const KerrFlow& flow, FlowTask<double>* const* tasks, std::size_t count);  // the widest of them

// Each compiled for its machines alone; null where that is not possible.
FlowSteps flow_steps_avx2();
FlowSteps flow_steps_avx512();

}  // namespace nullscope::reference
