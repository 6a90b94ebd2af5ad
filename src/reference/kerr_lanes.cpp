#include "reference/kerr_lanes.h"

#include "reference/kerr_lanes_of.h"

namespace nullscope::reference {
namespace {

#if defined(__x86_64__)
bool has_avx2() { return __builtin_cpu_supports("avx2") != 0; }
bool has_avx512() { return __builtin_cpu_supports("avx512f") != 0; }
#else
bool has_avx2() { return false; }
bool has_avx512() { return false; }
#endif

FlowSteps widest_steps() {
    FlowSteps widest = nullptr;
    for (const FlowSteps steps : all_flow_steps())
        if (steps != nullptr) widest = steps;
    return widest;
}

}  // namespace

std::array<FlowSteps, 3> all_flow_steps() {
    return {flow_steps_of<2>, has_avx2() ? flow_steps_avx2() : nullptr, has_avx512() ? flow_steps_avx512() : nullptr};
}

void flow_steps(const KerrFlow& flow, FlowTask<double>* const* tasks, std::size_t count) {
    static const FlowSteps steps = widest_steps();
    steps(flow, tasks, count);
}

}  // namespace nullscope::reference
