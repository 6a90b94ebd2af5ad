#include "cli/photon_ring_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "command/svg.h"
#include "observer/observer.h"
#include "reference/photon_ring.h"
#include "scene/disc_shape.h"
#include "scene/leaning_disc.h"
#include "spacetime/photon_shell.h"
#include "spacetime/registry.h"
#include "spacetime/spherical_metric.h"
#include "table/critical_images.h"

namespace nullscope::cli {
namespace {

using reference::PhotonRing;

constexpr double kTold = 1e-12;  // rad from the critical direction, what rays of the reference tell apart to some 1e-5
constexpr double kInner = 3.0, kFigureOuter = 10.0;  // r_s

struct Rim {
    double delta = NAN, delay = NAN, azimuth = NAN;
};
struct Subring {
    Rim inner, outer;
    double width() const { return std::fabs(outer.delta - inner.delta); }
};
struct Ring {
    double psi_deg;
    PhotonOrbit theory;
    std::vector<Subring> subrings;
    std::optional<PhotonRing::HalfOrbit> limit;

    // Of subring n, 0 the first, over or less the one before; NaN: no such.
    double ratio(std::size_t n) const { return n > 0 ? subrings[n].width() / subrings[n - 1].width() : NAN; }
    double off(std::size_t n) const { return ratio(n) * std::exp(theory.gamma) - 1.0; }
    // off() without what falls as delta ln(delta), by four subrings.
    double off_limit(std::size_t n) const {
        return n > 2 ? reference::limit_of(off(n - 2), off(n - 1), off(n), std::exp(-theory.gamma)) : NAN;
    }
    double delay(std::size_t n) const { return n > 0 ? subrings[n].outer.delay - subrings[n - 1].outer.delay : NAN; }
    double turn_off(std::size_t n) const {
        return n > 0 ? turn_off(subrings[n - 1].outer.azimuth - subrings[n].outer.azimuth) : NAN;
    }
    double turn_off(double turn) const { return std::remainder(turn - theory.azimuth, 2.0 * M_PI); }
};

// Directions by the deflection table, where there is one: as exact for any number of half orbits.
class Rims {
public:
    Rims(const PhotonRing& ring, const std::shared_ptr<const Spacetime>& spacetime) : ring_(ring) {
        const std::shared_ptr<const SphericalMetric> metric(spacetime, spacetime->spherical());
        if (metric == nullptr || metric->barrier()) return;
        family_.emplace(metric, std::make_shared<const DeflectionTable>(*metric), ring.camera().r,
                        observer_of(*spacetime, ring.camera())->frame);
    }
    std::vector<Rim> of_circle(const PhotonRing::Place& place, double r, int rings) const {
        std::vector<Rim> rims;
        double below = kWidest, swept = NAN;
        for (int n = 1; n <= rings; ++n) {
            Rim& rim = rims.emplace_back();
            if (!std::isnan(swept)) swept += M_PI;
            if (n > kByReference && !std::isnan(swept)) {
                rim.delta = delta_of_image(*family_, r, swept);
                if (std::fabs(rim.delta) < kTold) continue;
                if (const auto image = ring_.image_at(place, n, rim.delta)) told(*image, rim);
                continue;
            }
            const auto image = ring_.image(place, n, r, below);
            if (!image || std::fabs(image->delta) < kTold) continue;
            rim.delta = image->delta, told(*image, rim);
            if (n >= kByReference) below = 2.0 * std::fabs(image->delta);
            if (family_) swept = image->swept;
        }
        return rims;
    }

private:
    static constexpr int kByReference = 2;  // they may be far from the critical direction
    static constexpr double kWidest = 2.5;
    static void told(const PhotonRing::Image& image, Rim& rim) { rim.delay = image.delay, rim.azimuth = image.azimuth; }
    const PhotonRing& ring_;
    std::optional<RayFamily> family_;
};

std::string number(double value, const char* format) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value + 0.0) : "-";
}

std::string table_of(const Ring& ring) {
    const PhotonOrbit& t = ring.theory;
    std::string text = fmt::format(
        "\nangle {:g}: light circles at {:.6f} r_s; exp(-gamma) {:.10f}, delay {:.8f} r_s/c, azimuth {:+.8f} of which "
        "drag "
        "{:.8f} rad\n",
        ring.psi_deg, t.r, std::exp(-t.gamma), t.delay, t.azimuth, t.drag);
    text += "   n   width, rad     ratio         off       extrapol.  delay        off       azimuth      off\n";
    for (std::size_t n = 0; n < ring.subrings.size(); ++n) {
        const double late = ring.delay(n), turned = ring.turn_off(n);
        text += fmt::format("  {:2}   {:<12}   {:<12}  {:<8}  {:<8}    {:<11}  {:<8}  {:<11}  {}\n", n + 1,
                            number(ring.subrings[n].width(), "{:.6e}"), number(ring.ratio(n), "{:.10f}"),
                            number(ring.off(n), "{:.1e}"), number(ring.off_limit(n), "{:.1e}"), number(late, "{:.7f}"),
                            number(late - t.delay, "{:.1e}"), number(t.azimuth + turned, "{:+.7f}"),
                            number(turned, "{:.1e}"));
    }
    if (const auto& limit = ring.limit)
        text += fmt::format(
            "  in the end, by traced rays: exp(-gamma) {:.10f}, off by {:.1e} of it; delay {}, off by {}; azimuth "
            "{:+.8f}, "
            "off by {:.1e}\n",
            std::exp(-limit->gamma), std::expm1(t.gamma - limit->gamma), number(limit->delay, "{:.8f}"),
            number(limit->delay - t.delay, "{:.1e}"), t.azimuth + ring.turn_off(limit->azimuth),
            ring.turn_off(limit->azimuth));
    return text;
}

std::string photon_ring_csv(const std::vector<Ring>& rings) {
    std::string text =
        "psi_deg,n,inner_rad,outer_rad,width_rad,ratio,ratio_theory,ratio_off,ratio_off_limit,delay,delay_"
        "theory,azimuth,azimuth_theory,drag_theory\n";
    const auto cell = [](double value) { return std::isfinite(value) ? fmt::format(",{:.15g}", value) : ","; };
    for (const Ring& ring : rings)
        for (std::size_t n = 0; n < ring.subrings.size(); ++n) {
            const PhotonOrbit& t = ring.theory;
            const Subring& s = ring.subrings[n];
            text += fmt::format("{:g},{}", ring.psi_deg, n + 1);
            for (const double value :
                 {s.inner.delta, s.outer.delta, s.width(), ring.ratio(n), std::exp(-t.gamma), ring.off(n),
                  ring.off_limit(n), ring.delay(n), t.delay, t.azimuth + ring.turn_off(n), t.azimuth, t.drag})
                text += cell(value);
            text += "\n";
        }
    return text;
}

// Of one panel: powers of ten over n.
class Panel {
public:
    Panel(double left, int rings, double low, double high) : left_(left), rings_(rings), low_(low), high_(high) {}
    double x(double n) const { return left_ + (n - 0.5) / rings_ * kWidth; }
    double y(double value) const { return kTop + (high_ - std::log10(value)) / (high_ - low_) * kHeight; }
    std::string frame(const char* title) const {
        std::string svg = svg_text(left_, kTop - 14, title, 14);
        const int step = std::max(1, static_cast<int>(std::ceil((high_ - low_) / 8)));
        for (int power = static_cast<int>(low_); power <= high_; power += step) {
            svg += svg_line(left_, y(std::pow(10.0, power)), left_ + kWidth, y(std::pow(10.0, power)));
            svg += svg_text(left_ - 8, y(std::pow(10.0, power)) + 4, fmt::format("1e{}", power), 12, "end");
        }
        for (int n = 1; n <= rings_; ++n) svg += svg_text(x(n), kTop + kHeight + 18, std::to_string(n), 12, "middle");
        return svg;
    }
    static constexpr double kWidth = 380, kHeight = 300, kTop = 70;

private:
    double left_;
    int rings_;
    double low_, high_;
};

constexpr std::array kColours = {"#c2410c", "#1d4ed8", "#15803d", "#7e22ce", "#a16207", "#0e7490"};

// values(ring, n): positive, or not drawn. line: by theory, through the last value.
template <class Values>
std::string drawn(const std::vector<Ring>& rings, int count, double left, const char* title, bool line,
                  const Values& values) {
    double least = INFINITY, most = 0;
    for (const Ring& ring : rings)
        for (std::size_t n = 0; n < ring.subrings.size(); ++n)
            if (const double value = values(ring, n); std::isfinite(value) && value > 0)
                least = std::min(least, value), most = std::max(most, value);
    if (!(most > 0)) least = most = 1;
    const Panel panel(left, count, std::floor(std::log10(least)), std::floor(std::log10(most)) + 1);
    std::string svg = panel.frame(title);
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const char* colour = kColours[i % kColours.size()];
        std::optional<std::array<double, 2>> last;
        for (std::size_t n = 0; n < rings[i].subrings.size(); ++n) {
            const double value = values(rings[i], n), at = static_cast<double>(n) + 1;
            if (!(std::isfinite(value) && value > 0)) continue;
            svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", panel.x(at),
                               panel.y(value), colour);
            last = {at, value};
        }
        if (!line || !last) continue;
        // From the second: the first is no image by half orbits.
        const double first = (*last)[1] * std::exp(rings[i].theory.gamma * ((*last)[0] - 2));
        svg += svg_curve("polyline", {{panel.x(2), panel.y(first)}, {panel.x((*last)[0]), panel.y((*last)[1])}}, 1.0,
                         colour);
    }
    return svg;
}

std::string photon_ring_svg(const std::string& head, const std::vector<Ring>& rings, int count) {
    constexpr double kLeft = 70, kSecond = kLeft + Panel::kWidth + 80, kBottom = Panel::kTop + Panel::kHeight;
    const std::string title = in_xml(head);
    std::string svg(kSvgWhite);
    svg += svg_text(16, 28, title, 14);
    svg += drawn(rings, count, kLeft, "Width of subring n, rad; lines: exp(-gamma n)", true,
                 [](const Ring& ring, std::size_t n) { return ring.subrings[n].width(); });
    svg += drawn(rings, count, kSecond, "Its ratio to the one before, off exp(-gamma) by", false,
                 [](const Ring& ring, std::size_t n) { return std::fabs(ring.off(n)); });
    for (std::size_t i = 0; i < rings.size(); ++i)
        svg +=
            svg_text(kLeft + 120.0 * static_cast<double>(i), kBottom + 44, fmt::format("angle {:g}", rings[i].psi_deg),
                     13, "start", fmt::format("fill=\"{}\"", kColours[i % kColours.size()]));
    return svg_document(kSecond + Panel::kWidth + 20, kBottom + 60, svg);
}

}  // namespace

Result<RingFigure> photon_ring_figure(const Scene& scene, int rings, std::vector<int> angles) {
    if (disc_warps(scene))
        return bad_input("rings are drawn of a flat disc without gaps",
                         "a scene without disc.warp_radii and disc.rings");
    if (disc_leans(scene)) return bad_input("rings are drawn of a disc in the equatorial plane", "disc.tilt = 0");
    TRY(ring, PhotonRing::make(scene));
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    if (angles.empty())
        angles = (*spacetime)->planar_rays() ? std::vector<int>{90} : std::vector<int>{30, 90, 150, 210, 270, 330};
    const double inner = scene.disc ? scene.disc->inner : kInner, outer = scene.disc ? scene.disc->outer : kFigureOuter;
    const Rims rims(*ring, *spacetime);
    std::vector<Ring> measured;
    for (const int angle : angles) {
        const double psi = angle * M_PI / 180;
        TRY(theory, photon_orbit(**spacetime, scene.camera.theta, psi));
        const PhotonRing::Place place = ring->place(psi);
        const auto in = rims.of_circle(place, inner, rings), out = rims.of_circle(place, outer, rings);
        Ring& of = measured.emplace_back(Ring{static_cast<double>(angle), *theory, {}, ring->half_orbit(place, outer)});
        for (std::size_t n = 0; n < in.size(); ++n) of.subrings.push_back({in[n], out[n]});
    }
    const std::string head = fmt::format(
        "{}: images of the disc from {:g} to {:g} r_s by their crossing n of its plane", scene.name, inner, outer);
    RingFigure figure{head + "\n", photon_ring_csv(measured), photon_ring_svg(head, measured, rings), head};
    for (const Ring& of : measured) figure.table += table_of(of);
    return figure;
}

}  // namespace nullscope::cli
