#include "studio/adaptation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studio/pace.h"

namespace nullscope::viewer {

double Adaptation::step(double now, bool at_once) {
    const double since = std::min(now - std::exchange(at_, now), kLongestFrameStep);
    const double share = at_once ? 1.0 : 1.0 - std::exp(-since / kTime_s);
    left_ *= 1.0 - share;
    return share;
}

}  // namespace nullscope::viewer
