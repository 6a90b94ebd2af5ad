// What the tracer of kerr_ray.h begins with: a photon by its constants of motion, formed where it is seen as products,
// so that far away they have their own rounding and not that of the camera's place.
#pragma once
#include "reference/kerr_chart.h"
#include "reference/kerr_ray.h"

namespace nullscope::reference {

struct KerrPhase {  // place and momentum in the chart
    Vec3 x, p;
};

// What is known of a photon where it is seen, or traced on from; `theta` and `climb` towards where it came from.
struct KerrLaunch {
    double r, theta;
    double phi;                                  // Boyer and Lindquist's, or if `falls` the ingoing azimuth
    bool falls;                                  // it fell in: traced as it is, otherwise its mirror image
    double energy, l_over_sine, p_theta, climb;  // climb: Sigma dr/dlambda
    double p_r;                                  // of the chart, of what is traced

    double sense() const { return falls ? -1 : 1; }
};
KerrLaunch kerr_launch(const KerrChart& chart, const KerrStart& start);
KerrLaunch kerr_launch(const KerrChart& chart, const KerrPhoton& photon);
// Of a photon that was traced as it is (backward, its phase has the opposite momentum) and has turned: its mirror image
// begins with this.
KerrLaunch mirrored(const KerrChart& chart, const KerrPhase& phase, double energy, double phi);

// Where it begins in the chart, in the variables of kerr_flow.h: the azimuth psi of x + iy = (r + ia) sin(theta) e^{i psi}
// is 0 but for what the chart is ahead.
struct KerrBeginning {
    Vec3 n, momentum;  // the place over its length; the place cross p
    double u, c;       // 1 over that length; n p
    double azimuth;    // of the place
};
KerrBeginning beginning(const KerrChart& chart, const KerrLaunch& launch);

}  // namespace nullscope::reference
