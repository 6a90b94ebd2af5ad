#include "cli/curve_file.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace nullscope::cli {
namespace {

void append_number(std::string& line, double value) {
    line += ',';
    if (std::isfinite(value)) fmt::format_to(std::back_inserter(line), "{:.17g}", value);
}

}  // namespace

std::string curves_csv(std::span<const Curve> curves, const CurveForm& form) {
    std::string text = form.cartesian ? "ray,lambda,x,y,z,t" : "ray,lambda,r,theta,phi,t";
    if (form.rates) text += ",r_rate,theta_rate,phi_rate,t_rate";
    text += '\n';
    for (std::size_t i = 0; i < curves.size(); ++i)
        for (const reference::CurvePoint& point : curves[i]) {
            fmt::format_to(std::back_inserter(text), "{}", i + 1);
            const Vec3 place = form.cartesian ? cartesian(point) : Vec3{point.r, point.theta, point.phi};
            for (const double value : {point.affine, place.x, place.y, place.z, point.t}) append_number(text, value);
            if (form.rates)
                for (const double value : {point.r_rate, point.theta_rate, point.phi_rate, point.t_rate})
                    append_number(text, value);
            text += '\n';
        }
    return text;
}

std::string curves_obj(std::span<const Curve> curves) {
    std::string text = "# light rays from the camera on; lengths in r_s; z is the polar axis\n";
    std::size_t vertex = 1;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (curves[i].empty()) continue;
        fmt::format_to(std::back_inserter(text), "o ray-{}\n", i + 1);
        for (const reference::CurvePoint& point : curves[i]) {
            const Vec3 at = cartesian(point);
            fmt::format_to(std::back_inserter(text), "v {:.9g} {:.9g} {:.9g}\n", at.x, at.y, at.z);
        }
        text += 'l';
        for (std::size_t k = 0; k < curves[i].size(); ++k) fmt::format_to(std::back_inserter(text), " {}", vertex++);
        text += '\n';
    }
    return text;
}

}  // namespace nullscope::cli
