// Compiled for machines with AVX-512 (src/CMakeLists.txt), and only called there.
#include "reference/kerr_lanes.h"

#ifdef __AVX512F__
#include "reference/kerr_lanes_of.h"

namespace nullscope::reference {
FlowSteps flow_steps_avx512() { return flow_steps_of<8>; }
}  // namespace nullscope::reference
#else
namespace nullscope::reference {
FlowSteps flow_steps_avx512() { return nullptr; }
}  // namespace nullscope::reference
#endif
