#include "observer/screen_form.h"

#include <cmath>

#include "observer/lorentz.h"
#include "observer/pose.h"
#include "spacetime/axial_metric.h"

namespace nullscope {

ScreenForm screen_form(const Spacetime& spacetime, const CameraSpec& camera, const Observer& observer,
                       bool aberration) {
    const AxialMetric* axial = spacetime.axial();
    const std::complex<double> scale{1.0, axial ? -axial->a() * std::cos(camera.theta) / camera.r : 0.0};
    const Lorentz moved = boost({0, 0, observer.azimuthal_velocity}) * boost(aberration ? observer.velocity : Vec3{});
    const Mat3 axes = observer.turn * static_from_camera(camera);
    const auto component = [&](Vec3 axis, int row) {
        return moved[row][1] * axis.x + moved[row][2] * axis.y + moved[row][3] * axis.z;
    };
    ScreenForm form;
    std::size_t i = 0;
    for (const Vec3 axis : {axes.a, axes.b, -axes.c}) {
        const double real = moved[0][0] * component(axis, 1) - moved[1][0] * component(axis, 0),
                     imaginary = moved[2][0] * component(axis, 3) - moved[3][0] * component(axis, 2);
        form[i++] = scale * std::complex(real, imaginary);
    }
    return form;
}

std::complex<double> screen_phase(const ScreenForm& form, Vec3 n) {
    const std::complex<double> across{n.x, n.y}, along = form[2] + form[0] * n.x + form[1] * n.y + form[2] * n.z;
    return form[0] + std::complex(0.0, 1.0) * form[1] - across * along / (1.0 + n.z);
}

}  // namespace nullscope
