#include "compare/hard_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "compare/hard_metrics.h"
#include "compare/hard_rotating.h"
#include "compare/ray_metrics.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

constexpr double kDegree = M_PI / 180;

Scene odd_scene() {  // the middle pixel looks exactly along the axis
    Scene scene;
    scene.sky.kind = SkyKind::kBlack;
    scene.camera.width = 97;
    scene.camera.height = 55;
    return scene;
}

void field_of_view(Scene& s, double rad) { s.camera.plane_width = 2 * std::tan(0.5 * rad); }

void disc(Scene& s, double inner = 3, double outer = 12) {
    s.disc = DiscSpec{};
    s.disc->inner = inner;
    s.disc->outer = outer;
}

// Half-angle of the shadow for a static camera outside the photon sphere (Synge 1966), r_s = 1.
double shadow_angle(double r) { return std::asin(std::min(1.0, 1.5 * std::sqrt(3.0) / r * std::sqrt(1 - 1 / r))); }

class List {
public:
    void add(std::string name, std::string why, const std::function<void(Scene&)>& set) {
        Scene scene = odd_scene();
        scene.name = name;
        set(scene);
        cases_.push_back({std::move(name), std::move(why), std::move(scene)});
    }
    std::vector<HardCase> take() { return std::move(cases_); }

private:
    std::vector<HardCase> cases_;
};

void critical_rays(List& list) {
    constexpr double r = 20;
    for (int k = 1; k <= 7; ++k)
        for (const bool outside : {true, false})
            list.add(fmt::format("q = q_crit (1 {} 1e-{})", outside ? '-' : '+', k),
                     "the ray winds as often as digits allow", [&](Scene& s) {
                         const double delta = std::pow(10.0, -k), angle = shadow_angle(r);
                         s.camera.r = r;
                         s.camera.yaw =
                             angle + (outside ? delta : -delta) * std::tan(angle);  // sin(alpha) changes by delta
                         field_of_view(s, delta * std::tan(angle));
                     });
}

void photon_sphere(List& list) {
    const std::pair<const char*, double> radii[] = {{"exactly", 1.5},
                                                    {"a float above", std::nextafterf(1.5f, 2.0f)},
                                                    {"a float below", std::nextafterf(1.5f, 1.0f)},
                                                    {"a double above", std::nextafter(1.5, 2.0)},
                                                    {"1e-9 below", 1.5 - 1e-9}};
    for (const auto& [where, r] : radii)
        for (const auto& [look, yaw] : {std::pair{"across", 90.0}, {"inwards", 0.0}, {"outwards", 180.0}})
            list.add(fmt::format("photon sphere {}, {}", where, look), "both sheets of the table meet and chi0 = pi/2",
                     [r = r, yaw = yaw](Scene& s) {
                         s.camera.r = r, s.camera.yaw = yaw * kDegree, field_of_view(s, 100 * kDegree);
                     });
}

void radii(List& list) {
    for (int k = 1; k <= 9; ++k)
        for (const bool outwards : {true, false})
            list.add(fmt::format("zeta0 = 1 - 1e-{}, {}", k, outwards ? "the cone of sky" : "inwards"),
                     outwards ? "the whole sky in a cone that closes at the horizon" : "all is shadow but a rim",
                     [&](Scene& s) {
                         const double gap = std::pow(10.0, -k);
                         s.camera.r = 1 / (1 - gap);
                         s.camera.yaw = outwards ? M_PI : 0;
                         if (outwards) field_of_view(s, std::min(120 * kDegree, 4 * 2.6 * std::sqrt(gap)));
                     });
    for (int k = 2; k <= 9; ++k) {
        list.add(fmt::format("zeta0 = 1e-{}, at the hole", k),
                 "the hole spans nanoradians: rays of interest are nearly radial",
                 [&](Scene& s) { s.camera.r = std::pow(10.0, k), field_of_view(s, 6 * shadow_angle(s.camera.r)); });
        list.add(fmt::format("zeta0 = 1e-{}, past it", k), "weak bending must not drown in rounding",
                 [&](Scene& s) { s.camera.r = std::pow(10.0, k), s.camera.yaw = 40 * kDegree; });
    }
}

void directions(List& list) {
    for (const double r : {1.01, 1.5, 3.0, 20.0, 1e4}) {
        list.add(fmt::format("radial inwards, r = {}", r), "the orbital plane is not defined",
                 [&](Scene& s) { s.camera.r = r, field_of_view(s, 0.2 * kDegree); });
        list.add(fmt::format("radial outwards, r = {}", r), "the orbital plane is not defined",
                 [&](Scene& s) { s.camera.r = r, s.camera.yaw = M_PI, field_of_view(s, 0.2 * kDegree); });
    }
    for (const int even : {0, 1})  // an odd frame has a ray through the very middle, an even one four around it
        list.add(fmt::format("{}x{} px of 3840 over 1 degree, the shadow's middle", 97 - even, 55 - even),
                 "exactly radial rays: not one may be lit", [&](Scene& s) {
                     s.camera.r = 20, s.camera.width -= even, s.camera.height -= even;
                     s.camera.plane_width = 2 * std::tan(0.5 * kDegree) * s.camera.width / 3840;
                 });
    for (const double r : {1.2, 1.5001, 2.0, 20.0, 1e6, 1e9})
        for (const double width : {60.0, 1.0})
            list.add(fmt::format("turning point in the camera, r = {}, {} degrees", r, width),
                     "alpha = pi/2: rays that go in and rays that go out meet",
                     [&](Scene& s) { s.camera.r = r, s.camera.yaw = M_PI / 2, field_of_view(s, width * kDegree); });
}

// zeta at which chi (spacetime.h) has this value: zeta^2 (1 - zeta) = 4/27 sin^2 chi, solved by thirds of an angle.
double zeta_of_chi(double chi) { return (1 + 2 * std::cos((2 * M_PI - 2 * chi) / 3)) / 3; }

void table_edges(List& list) {
    // The deflection table has 96 cells of chi a sheet (table_mapping.glsl).
    for (const double cells : {0.5, 1.0, 24.0, 47.5, 47.999, 48.001, 72.5, 95.0, 95.5})
        list.add(fmt::format("camera on row {} of the table", cells), "interpolation starts, ends or changes its cell",
                 [&](Scene& s) { s.camera.r = 1 / zeta_of_chi(cells * M_PI / 96), s.camera.yaw = 0.7; });
    // Octave j of the strip starts where w = w0 (2^j - 1), w0 = 1e-6 of the shadow's angle (strip.glsl, ray_fan.h).
    for (const int octave : {1, 4, 9, 14, 18, 20})
        for (const int side : {-1, 1})
            list.add(fmt::format("{} octave {} of the strip", side > 0 ? "outside," : "inside,", octave),
                     "the middle ray lies on the edge of two cells of different width", [&](Scene& s) {
                         constexpr double r = 20;
                         const double angle = shadow_angle(r), w = 1e-6 * angle * (std::exp2(octave) - 1);
                         s.camera.r = r, s.camera.yaw = angle + side * 2 * std::atan(0.5 * w);
                         field_of_view(s, std::max(w, 3e-4));
                     });
}

void axis_and_plane(List& list) {
    for (const auto& [name, theta] : {std::pair{"0", 0.0}, {"pi", M_PI}, {"1e-9", 1e-9}, {"1e-4", 1e-4}})
        list.add(fmt::format("camera at theta = {}", name), "the polar axis has no azimuth",
                 [theta = theta](Scene& s) { disc(s), s.camera.r = 20, s.camera.theta = theta; });
    list.add("rays across the polar axis", "azimuth jumps by pi along the ray", [](Scene& s) {
        s.camera.r = 20, s.camera.theta = 0.6, s.camera.pitch = -0.15, field_of_view(s, 20 * kDegree);
    });
    for (const auto& [name, off] : {std::pair{"in the disc's plane", 0.0},
                                    {"1e-6 above the disc's plane", 1e-6},
                                    {"1e-9 above it", 1e-9},
                                    {"1e-4 below it", -1e-4}}) {
        list.add(fmt::format("camera {}", name), "the disc is seen edge-on",
                 [off = off](Scene& s) { disc(s), s.camera.r = 20, s.camera.theta = M_PI / 2 - off; });
        list.add(fmt::format("camera inside the disc, {}", name), "the disc is around the camera",
                 [off = off](Scene& s) { disc(s), s.camera.r = 7, s.camera.theta = M_PI / 2 - off; });
    }
}

void discs(List& list) {
    list.add("disc down to the photon sphere", "its inner images pile up at the critical ray",
             [](Scene& s) { disc(s, 1.5), s.camera.r = 20, s.camera.theta = 1.4, field_of_view(s, 30 * kDegree); });
    list.add("disc inside the photon sphere", "seen by captured rays alone", [](Scene& s) {
        disc(s, 1.02, 1.49), s.camera.r = 20, s.camera.theta = 1.3, field_of_view(s, 18 * kDegree);
    });
    list.add("disc of a million r_s", "rays meet it almost at infinity",
             [](Scene& s) { disc(s, 3, 1e6), s.camera.r = 20, s.camera.theta = 1.4; });
    list.add("translucent disc", "a ray is not over at the first crossing",
             [](Scene& s) { disc(s), s.disc->opacity = 0.5, s.camera.r = 20, s.camera.theta = 1.4; });
    list.add("disc before a camera at 0.86 c", "hits are found after aberration", [](Scene& s) {
        disc(s), s.camera.r = 12, s.camera.theta = 1.3, s.camera.velocity = {-0.5, 0, 0.7};
    });
    list.add("translucent disc from its other pole", "a ray is not over at the first crossing",
             [](Scene& s) { disc(s), s.disc->opacity = 0.5, s.camera.r = 20, s.camera.theta = M_PI; });
    list.add("disc, camera at 1e4", "all rays of interest are nearly radial",
             [](Scene& s) { disc(s), s.camera.r = 1e4, s.camera.theta = 1.2, field_of_view(s, 4e-3); });
    // Image n of the disc lies where rays sweep some n half turns: e^pi closer to the critical ray each.
    for (int order = 1; order <= 6; ++order)
        list.add(fmt::format("image order {}", order), "each image of the disc is exp(pi) thinner than the one before",
                 [&](Scene& s) {
                     constexpr double r = 20;
                     disc(s);
                     s.camera.r = r, s.camera.theta = 1.2;
                     const double angle = shadow_angle(r), width = 1.5 * angle * std::exp(-M_PI * (order - 1));
                     s.camera.pitch = angle + 0.3 * width;
                     field_of_view(s, 3 * width);
                 });
}

void motions(List& list) {
    for (const double speed : {0.9, 0.999999})
        for (int i = 0; i < 27; ++i) {
            const int a = i / 9, b = i / 3 % 3, c = i % 3;
            const Vec3 d{a - 1.0, b - 1.0, c - 1.0};
            if (length(d) == 0) continue;
            list.add(fmt::format("{} c towards ({:.0f}, {:.0f}, {:.0f})", speed, d.x, d.y, d.z),
                     "aberration squeezes most of the sky into a few pixels", [&](Scene& s) {
                         s.camera.r = 10, s.camera.velocity = speed * normalized(d), field_of_view(s, 90 * kDegree);
                     });
        }
}

void moving_zooms(List& list) {
    for (const double degrees : {1.0, 0.1, 0.01})
        for (const auto& [name, v] : {std::pair{"0.89 c", Vec3{0.5, 0, 0.74}},
                                      {"0.999 c across", Vec3{0, 0, 0.999}},
                                      {"0.999 c inwards", Vec3{-0.999, 0, 0}}})
            list.add(fmt::format("{} degrees at {}", degrees, name), "aberration forms every direction anew, in float",
                     [v = v, degrees](Scene& s) {
                         s.camera.r = 20, s.camera.yaw = 21 * kDegree, s.camera.pitch = 3 * kDegree,
                         s.camera.velocity = v, field_of_view(s, degrees * kDegree);
                     });
}

void frames(List& list) {
    for (const double degrees : {0.01, 0.1, 1.0, 10.0, 120.0, 179.0}) {
        list.add(fmt::format("{} degrees, at the photon ring", degrees), "the picture's finest detail, at any depth",
                 [&](Scene& s) {
                     s.camera.r = 20, s.camera.pitch = 0.6 * shadow_angle(20), s.camera.yaw = 0.8 * shadow_angle(20);
                     const double off = std::acos(std::cos(s.camera.pitch) * std::cos(s.camera.yaw)),
                                  angle = shadow_angle(20);
                     s.camera.pitch *= angle / off, s.camera.yaw *= angle / off;
                     field_of_view(s, degrees * kDegree);
                 });
        list.add(fmt::format("{} degrees, past the hole", degrees), "a pixel spans less than a float of a direction",
                 [&](Scene& s) {
                     s.camera.r = 20, s.camera.yaw = 0.5, s.camera.pitch = 0.2, field_of_view(s, degrees * kDegree);
                 });
        list.add(fmt::format("{} degrees, at the disc", degrees), "texture and rims of the disc at any depth",
                 [&](Scene& s) {
                     disc(s), s.camera.r = 20, s.camera.theta = 1.3, s.camera.yaw = 0.3,
                              field_of_view(s, degrees * kDegree);
                 });
    }
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 129}, {129, 1}, {8192, 2}, {2, 8192}, {2, 2}})
        list.add(fmt::format("{} x {}", width, height), "sizes that leave no neighbour, or many",
                 [width = width, height = height](Scene& s) {
                     disc(s), s.camera.r = 20, s.camera.theta = 1.4, s.camera.width = width, s.camera.height = height;
                     if (height > width) s.camera.plane_width /= height;
                 });
    list.add("turned, pitched and rolled", "all three angles at once", [](Scene& s) {
        disc(s), s.camera.r = 20, s.camera.theta = 1.2, s.camera.yaw = 0.3, s.camera.pitch = -0.2, s.camera.roll = 2;
    });
}

void flat(List& list) {
    const auto straight = [&](const char* name, const std::function<void(Scene&)>& set) {
        list.add(fmt::format("flat, {}", name), "the limit that all else must keep",
                 [&](Scene& s) { s.spacetime.metric = "minkowski", set(s); });
    };
    straight("sky", [](Scene&) {});
    straight("disc", [](Scene& s) { disc(s), s.camera.theta = 1.2; });
    straight("disc, in its plane", [](Scene& s) { disc(s), s.camera.r = 20, s.camera.theta = M_PI / 2; });
    straight("0.86 c", [](Scene& s) { s.camera.velocity = {-0.5, 0.1, 0.69}; });
    straight("0.999999 c", [](Scene& s) { s.camera.velocity = {0, 0, 0.999999}; });
}

std::vector<HardCase> make_cases() {
    List list;
    critical_rays(list);
    photon_sphere(list);
    radii(list);
    directions(list);
    table_edges(list);
    axis_and_plane(list);
    discs(list);
    motions(list);
    moving_zooms(list);
    frames(list);
    flat(list);
    std::vector<HardCase> all = list.take();
    for (HardCase& c : hard_metric_cases()) all.push_back(std::move(c));
    for (HardCase& c : hard_rotating_cases()) all.push_back(std::move(c));
    return all;
}

}  // namespace

const std::vector<HardCase>& hard_cases() {
    static const std::vector<HardCase> cases = make_cases();
    return cases;
}

bool hard_cubic(const Scene& scene) {
    constexpr double kCubicBelow = 2e-5;  // rad a pixel
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    return smallest_pixel_angle(scene.camera) < kCubicBelow && (!spacetime || (*spacetime)->planar_rays());
}

// |d ln(lapse) / d ln r|, by a difference over a thousandth of the way to where the lapse ends: 1 / (2 (r - 1)) of Schwarzschild's r.
double lapse_condition(const Spacetime& spacetime, double r) {
    const double end = spacetime.horizon_radius().value_or(0.0), step = 1e-3 * std::min(std::fabs(r - end), 1.0);
    if (!(step > 0)) return 0.0;
    const double change = spacetime.lapse_squared(r + step) - spacetime.lapse_squared(r - step);
    return std::fabs(0.25 * r * change / (step * spacetime.lapse_squared(r)));
}

HardBound hard_bound(const Scene& scene, const RayFrame& exact, double bit) {
    const Vec3 camera = camera_place(scene.camera);
    double angle = M_PI, nearness = 0;  // nearness: coordinates over distance
    bool star = false;                  // its places are where the swept angle ends
    for (const RayPixel& pixel : exact.pixels) {
        angle = std::max(angle, pixel.angle);
        star = star || pixel.hit == kStarHit;
        if (pixel.hit == 0 || pixel.hit == kStarHit) continue;
        const Vec3 place{pixel.u, pixel.v, 0};
        nearness = std::max(nearness, length(place) / length(place - camera));
    }
    const double pixel = smallest_pixel_angle(scene.camera), direction = kRoundings * bit / pixel;
    const double texel = bit < kFloatBit ? kTexel / pixel : 0;
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    const bool inner = spacetime && (*spacetime)->inner_end() != InnerEnd::kHorizon;
    const bool steps = spacetime && !(*spacetime)->planar_rays();
    const double step = kMinoStep * std::min(1.0, kMinoFar / scene.camera.r);
    const double table = steps ? step / pixel
                               : (hard_cubic(scene) ? kStripCubic
                                  : inner           ? kStripLineInner
                                                    : kStripLine) /
                                         pixel +
                                     texel;
    const double speed = length(scene.camera.velocity), gamma2 = 1 / ((1 - speed) * (1 + speed));
    const double radius = spacetime ? std::max(lapse_condition(**spacetime, scene.camera.r), 0.5) : 0.5;
    const double inputs = kRoundings * kDoubleBit / pixel * (radius + gamma2);
    const double swept = (direction + table) * angle;
    const double place = (direction + texel) * (1 + nearness) + (steps ? step : kOrbitMap) / pixel;
    return {direction + table, star ? std::max(place, swept) : place, swept, direction + inputs};
}

}  // namespace nullscope
