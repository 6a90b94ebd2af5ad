// The shader's text compiled for the CPU against the reference, pixel by pixel of one view, each error over its bound.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/ray_metrics.h"
#include "proof/view.h"
#include "reference/frame_tracer.h"
#include "render/frame_tables.h"
#include "support/report.h"

namespace nullscope::proof {

// What float and the tables leave, as an angle at the camera at rest, rad. A camera whose pixel spans pa and to which light comes
// in with the frequency ratio D (camera over static frame) sees it as angle / (pa min(1, D)) px: the condition number of the
// pixel. Largest of 1.8 million
// random rays, in double and in float: sky 2.9e-7 and 5.6e-7, swept angle 1.2e-6 and 2.0e-6, place 1.3e-5, log of the frequency
// 1e-12 and 3.7e-7. Ends may differ within `edge` of an edge: where a place is off, so is the rim.
struct ErrorAngles {
    double sky, swept, place, frequency, edge;
};
struct Core {
    std::string name;
    std::function<RayPixel(const CoreInput&, double, double)> trace;
    ErrorAngles allowed;
};
const std::vector<Core>& cores();  // core64, core32

struct Finding {
    std::string core, what;
    PixelPlace pixel{};
    double ratio = 0;  // of error and bound; infinite for what is not finite, and for a wrong end off every edge
};

class ViewJudge {
public:
    // tables: kept from view to view, because the deflection table of a spacetime takes longer than a view.
    ViewJudge(FrameTables& tables, const Scene& scene);
    // Calls found(finding) for every error, large or small.
    void judge(const Core& core, PixelPlace pixel, const std::function<void(const Finding&)>& found) const;

private:
    const ExactPixel& exact_at(PixelPlace pixel) const;
    bool explained(const RayPixel& tested, const RayPixel& here, PixelPlace pixel, double reach_px) const;
    Scene scene_;
    std::optional<reference::FrameTracer> tracer_;
    CoreInput input_;
    double lapse_ = 1;
    mutable std::optional<std::pair<PixelPlace, ExactPixel>> last_;
};

}  // namespace nullscope::proof
