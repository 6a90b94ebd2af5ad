// Compiled for machines with AVX2 (src/CMakeLists.txt), and only called there.
#include "reference/kerr_lanes.h"

#ifdef __AVX2__
#include "reference/kerr_lanes_of.h"

namespace nullscope::reference {
FlowSteps flow_steps_avx2() { return flow_steps_of<4>; }
}  // namespace nullscope::reference
#else
namespace nullscope::reference {
FlowSteps flow_steps_avx2() { return nullptr; }
}  // namespace nullscope::reference
#endif
