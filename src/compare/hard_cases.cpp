#include "compare/hard_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "compare/hard_parts.h"
#include "compare/ray_metrics.h"
#include "spacetime/registry.h"

namespace nullscope {
namespace {

// Half-angle of the shadow for a static camera outside the photon sphere (Synge 1966), r_s = 1.
double shadow_angle(double r) { return std::asin(std::min(1.0, 1.5 * std::sqrt(3.0) / r * std::sqrt(1 - 1 / r))); }

using List = std::vector<HardCase>;

// As camera, but with the frame of all cases.
Scene& add(List& list, const std::string& name, const std::string& why, const CameraSpec& camera,
           const std::optional<DiscSpec>& disc = {}) {
    Scene scene = hard_frame();
    const auto [width, height] = std::pair{scene.camera.width, scene.camera.height};
    scene.name = name, scene.camera = camera, scene.disc = disc;
    scene.camera.width = width, scene.camera.height = height;
    list.push_back({name, why, std::move(scene)});
    return list.back().scene;
}

void critical_rays(List& list) {
    constexpr double r = 20;
    for (int k = 1; k <= 7; ++k)
        for (const bool outside : {true, false}) {
            const double delta = std::pow(10.0, -k), angle = shadow_angle(r);
            const double yaw = angle + (outside ? delta : -delta) * std::tan(angle);  // sin(alpha) changes by delta
            add(list, fmt::format("q = q_crit (1 {} 1e-{})", outside ? '-' : '+', k),
                "the ray winds as often as float precision allows",
                {.r = r, .yaw = yaw, .plane_width = wide(delta * std::tan(angle))});
        }
}

void photon_sphere(List& list) {
    const std::pair<const char*, double> radii[] = {{"exactly", 1.5},
                                                    {"a float above", std::nextafterf(1.5f, 2.0f)},
                                                    {"a float below", std::nextafterf(1.5f, 1.0f)},
                                                    {"a double above", std::nextafter(1.5, 2.0)},
                                                    {"1e-9 below", 1.5 - 1e-9}};
    for (const auto& [where, r] : radii)
        for (const auto& [view, yaw] : {std::pair{"across", 90.0}, {"inwards", 0.0}, {"outwards", 180.0}})
            add(list, fmt::format("photon sphere {}, {}", where, view),
                "both branches of the table meet, and chi0 = pi/2",
                {.r = r, .yaw = yaw * kDegree, .plane_width = wide(100 * kDegree)});
}

void radii(List& list) {
    for (int k = 1; k <= 9; ++k) {
        const double gap = std::pow(10.0, -k), r = 1 / (1 - gap);
        add(list, fmt::format("zeta0 = 1 - 1e-{}, the cone of sky", k),
            "the whole sky in a cone that closes at the horizon",
            {.r = r, .yaw = M_PI, .plane_width = wide(std::min(120 * kDegree, 4 * 2.6 * std::sqrt(gap)))});
        add(list, fmt::format("zeta0 = 1 - 1e-{}, inwards", k), "the shadow fills all but a rim of the view", {.r = r});
    }
    for (int k = 2; k <= 9; ++k) {
        const double r = std::pow(10.0, k);
        add(list, fmt::format("zeta0 = 1e-{}, at the hole", k),
            "the hole spans nanoradians: rays of interest are nearly radial",
            {.r = r, .plane_width = wide(6 * shadow_angle(r))});
        add(list, fmt::format("zeta0 = 1e-{}, past it", k), "weak bending, easily lost in rounding",
            {.r = r, .yaw = 40 * kDegree});
    }
}

void directions(List& list) {
    for (const double r : {1.01, 1.5, 3.0, 20.0, 1e4})
        for (const auto& [view, yaw] : {std::pair{"inwards", 0.0}, {"outwards", M_PI}})
            add(list, fmt::format("radial {}, r = {}", view, r), "the orbital plane is not defined",
                {.r = r, .yaw = yaw, .plane_width = wide(0.2 * kDegree)});
    for (const int even : {0, 1}) {  // an odd frame has a ray through the very middle, an even one four around it
        CameraSpec& camera =
            add(list, fmt::format("{}x{} px of 3840 over 1 degree, the shadow's middle", 97 - even, 55 - even),
                "exactly radial rays: all must be dark", {.r = 20})
                .camera;
        camera.width -= even, camera.height -= even;
        camera.plane_width = wide(kDegree) * camera.width / 3840;
    }
    for (const double r : {1.2, 1.5001, 2.0, 20.0, 1e6, 1e9})
        for (const double width : {60.0, 1.0})
            add(list, fmt::format("turning point in the camera, r = {}, {} degrees", r, width),
                "alpha = pi/2: rays that go in and rays that go out meet",
                {.r = r, .yaw = M_PI / 2, .plane_width = wide(width * kDegree)});
}

// zeta at which chi (spacetime.h) has this value: zeta^2 (1 - zeta) = 4/27 sin^2 chi, solved by thirds of an angle.
double zeta_of_chi(double chi) { return (1 + 2 * std::cos((2 * M_PI - 2 * chi) / 3)) / 3; }

void table_edges(List& list) {
    // The deflection table has 96 cells of chi a branch (table_mapping.glsl).
    for (const double cells : {0.5, 1.0, 24.0, 47.5, 47.999, 48.001, 72.5, 95.0, 95.5})
        add(list, fmt::format("camera on row {} of the table", cells), "interpolation starts, ends or changes its cell",
            {.r = 1 / zeta_of_chi(cells * M_PI / 96), .yaw = 0.7});
    // Octave j of the strip starts where w = w0 (2^j - 1), w0 = 1e-6 of the shadow's angle (strip.glsl, ray_family.h).
    for (const int octave : {1, 4, 9, 14, 18, 20})
        for (const int side : {-1, 1}) {
            const double angle = shadow_angle(20), w = 1e-6 * angle * (std::exp2(octave) - 1);
            add(list, fmt::format("{} octave {} of the strip", side > 0 ? "outside," : "inside,", octave),
                "the central ray lies between two cells of different width",
                {.r = 20, .yaw = angle + side * 2 * std::atan(0.5 * w), .plane_width = wide(std::max(w, 3e-4))});
        }
}

void axis_and_plane(List& list) {
    for (const auto& [name, theta] : {std::pair{"0", 0.0}, {"pi", M_PI}, {"1e-9", 1e-9}, {"1e-4", 1e-4}})
        add(list, fmt::format("camera at theta = {}", name), "the polar axis has no azimuth", {.r = 20, .theta = theta},
            ring());
    add(list, "rays across the polar axis", "azimuth jumps by pi along the ray",
        {.r = 20, .theta = 0.6, .pitch = -0.15, .plane_width = wide(20 * kDegree)});
    for (const auto& [name, off] : {std::pair{"in the disc's plane", 0.0},
                                    {"1e-6 above the disc's plane", 1e-6},
                                    {"1e-9 above it", 1e-9},
                                    {"1e-4 below it", -1e-4}}) {
        add(list, fmt::format("camera {}", name), "the disc is seen edge-on", {.r = 20, .theta = M_PI / 2 - off},
            ring());
        add(list, fmt::format("camera inside the disc, {}", name), "the disc is around the camera",
            {.r = 7, .theta = M_PI / 2 - off}, ring());
    }
}

void discs(List& list) {
    add(list, "disc down to the photon sphere", "its inner images pile up at the critical ray",
        {.r = 20, .theta = 1.4, .plane_width = wide(30 * kDegree)}, ring(1.5));
    add(list, "disc inside the photon sphere", "seen only by captured rays",
        {.r = 20, .theta = 1.3, .plane_width = wide(18 * kDegree)}, ring(1.02, 1.49));
    add(list, "disc of a million r_s", "rays meet it almost at infinity", {.r = 20, .theta = 1.4}, ring(3, 1e6));
    add(list, "translucent disc", "a ray continues after its first crossing", {.r = 20, .theta = 1.4}, ring())
        .disc->opacity = 0.5;
    add(list, "disc before a camera at 0.86 c", "hits are found after aberration",
        {.r = 12, .theta = 1.3, .velocity = {-0.5, 0, 0.7}}, ring());
    add(list, "translucent disc from its other pole", "a ray continues after its first crossing",
        {.r = 20, .theta = M_PI}, ring())
        .disc->opacity = 0.5;
    add(list, "disc, camera at 1e4", "all rays of interest are nearly radial",
        {.r = 1e4, .theta = 1.2, .plane_width = wide(4e-3)}, ring());
    // Image n of the disc lies where rays sweep some n half turns: e^pi closer to the critical ray each.
    for (int order = 1; order <= 6; ++order) {
        const double angle = shadow_angle(20), width = 1.5 * angle * std::exp(-M_PI * (order - 1));
        add(list, fmt::format("image order {}", order), "each image of the disc is exp(pi) thinner than the one before",
            {.r = 20, .theta = 1.2, .pitch = angle + 0.3 * width, .plane_width = wide(3 * width)}, ring());
    }
}

void motions(List& list) {
    for (const double speed : {0.9, 0.999999})
        for (int i = 0; i < 27; ++i) {
            const int a = i / 9, b = i / 3 % 3, c = i % 3;
            const Vec3 d{a - 1.0, b - 1.0, c - 1.0};
            if (length(d) == 0) continue;
            add(list, fmt::format("{} c towards ({:.0f}, {:.0f}, {:.0f})", speed, d.x, d.y, d.z),
                "aberration squeezes most of the sky into a few pixels",
                {.r = 10, .velocity = speed * normalized(d), .plane_width = wide(90 * kDegree)});
        }
}

void moving_zooms(List& list) {
    for (const double degrees : {1.0, 0.1, 0.01})
        for (const auto& [name, v] : {std::pair{"0.89 c", Vec3{0.5, 0, 0.74}},
                                      {"0.999 c across", Vec3{0, 0, 0.999}},
                                      {"0.999 c inwards", Vec3{-0.999, 0, 0}}})
            add(list, fmt::format("{} degrees at {}", degrees, name), "aberration recomputes every direction in float",
                {.r = 20,
                 .yaw = 21 * kDegree,
                 .pitch = 3 * kDegree,
                 .velocity = v,
                 .plane_width = wide(degrees * kDegree)});
}

void frames(List& list) {
    const double angle = shadow_angle(20), up = 0.6 * angle, aside = 0.8 * angle,
                 onto = angle / std::acos(std::cos(up) * std::cos(aside));  // the photon ring, in that direction
    for (const double degrees : {0.01, 0.1, 1.0, 10.0, 120.0, 179.0}) {
        const double width = wide(degrees * kDegree);
        add(list, fmt::format("{} degrees, at the photon ring", degrees), "the picture's finest detail, at any depth",
            {.r = 20, .yaw = aside * onto, .pitch = up * onto, .plane_width = width});
        add(list, fmt::format("{} degrees, past the hole", degrees),
            "a pixel spans less than the resolution of a float direction",
            {.r = 20, .yaw = 0.5, .pitch = 0.2, .plane_width = width});
        add(list, fmt::format("{} degrees, at the disc", degrees), "texture and rims of the disc at any depth",
            {.r = 20, .theta = 1.3, .yaw = 0.3, .plane_width = width}, ring());
    }
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 129}, {129, 1}, {8192, 2}, {2, 8192}, {2, 2}}) {
        CameraSpec& camera =
            add(list, fmt::format("{} x {}", width, height), "image sizes with no neighbouring pixel, or with many",
                {.r = 20, .theta = 1.4}, ring())
                .camera;
        camera.width = width, camera.height = height;
        if (height > width) camera.plane_width /= height;
    }
    add(list, "turned, pitched and rolled", "all three angles at once",
        {.r = 20, .theta = 1.2, .yaw = 0.3, .pitch = -0.2, .roll = 2}, ring());
}

void flat(List& list) {
    const auto straight = [&](const char* name, const CameraSpec& camera, const std::optional<DiscSpec>& disc = {}) {
        add(list, fmt::format("flat, {}", name), "the limit that every other case must approach", camera, disc)
            .spacetime.metric = "minkowski";
    };
    straight("sky", {});
    straight("disc", {.theta = 1.2}, ring());
    straight("disc, in its plane", {.r = 20, .theta = M_PI / 2}, ring());
    straight("0.86 c", {.velocity = {-0.5, 0.1, 0.69}});
    straight("0.999999 c", {.velocity = {0, 0, 0.999999}});
}

List make_cases() {
    List list;
    for (const auto part : {critical_rays, photon_sphere, radii, directions, table_edges, axis_and_plane, discs,
                            motions, moving_zooms, frames, flat})
        part(list);
    for (List& more : std::array{hard_metric_cases(), hard_rotating_cases()})
        std::move(more.begin(), more.end(), std::back_inserter(list));
    return list;
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
    const double place = (direction + texel) * (1 + nearness) + (steps ? step : kOrbitTable) / pixel;
    return {direction + table, star ? std::max(place, swept) : place, swept, direction + inputs};
}

}  // namespace nullscope
