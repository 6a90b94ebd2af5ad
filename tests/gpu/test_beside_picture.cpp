// What is drawn beside a picture (ray data, layers, depths) is of the very picture, and asking for it changes nothing: whichever of the
// parts of light are switched off.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "command/capture_layers.h"
#include "reference/frame_tracer.h"
#include "render/picture_layers.h"
#include "scenefile/scene_file.h"
#include "support/draft.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kBesideError = 1e-5;  // of the light, and of 1 where there is less: rounding of float sums
constexpr float kWhole = 0.6f;         // of the brightest: above what a body covers whose ray passes it
constexpr double kBallsImage = 1e-3;   // light of a small ball, whose lensed image is a part of a pixel
constexpr double kSamePlace = 1e-4;    // of places, and of r_s: another program's rounding

struct BesideCase {
    std::string_view name;
    Scene scene;
};

Draft beside(const char* metric = "schwarzschild", MetricParameters parameters = {}) {
    return Draft().metric(metric, std::move(parameters)).place(30, M_PI / 3).size(80, 45).sky(SkyKind::kBlack);
}
BallSpec moving(BallMotion motion) { return {{8, 0, 0}, 1, motion, {}, "8 * cos(t / 3)", "8 * sin(t / 3)", "sin(t)"}; }

// Bodies alone before a black sky.
std::vector<BesideCase> bodies() {
    using enum BallMotion;
    Draft fisheye = beside().body(moving(kOrbit)).body(BallSpec{{0, 7, 3}});
    fisheye.scene.camera.projection = Projection::kFisheye;
    return {{"ball on an orbit", beside().body(moving(kOrbit))},
            {"ball on a path, flat", beside("minkowski").body(moving(kPath))},
            {"ball on an orbit, rotating hole", beside("kerr").body(moving(kOrbit))},
            {"ball on a path, charged hole", beside("reissner-nordstrom", {{"charge", 0.8}}).body(moving(kPath))},
            {"ball at rest beside a moving one, fisheye", fisheye},
            {"sphere that pulsates", beside().body(SphereSpec{4, 0.3, 12})},
            {"surface with t in it", beside().surface("length(x, y, z) - 4 - 0.6 * sin(0.5 * t + 3 * atan(y, x))", 6)}};
}

// And what is not opaque, or glows.
std::vector<BesideCase> others() {
    const auto disc = [](const char* metric, double opacity) {
        Draft draft = beside(metric);
        draft.scene.disc.emplace().flow = DiscFlowKind::kKepler;
        draft.scene.disc->material.texture = TextureKind::kGas, draft.scene.disc->opacity = opacity;
        return draft;
    };
    const auto clump = [](Draft draft) {
        MediumSpec& medium = draft.scene.medium.emplace();
        medium.kind = MediumKind::kFormula, medium.emission = MediumEmission::kBlackBody, medium.outer = 12;
        medium.formulas.density = "exp(-((x - 6 * cos(t / 3))^2 + (y - 6 * sin(t / 3))^2 + z^2))";
        return draft;
    };
    Draft spot = disc("kerr", 1), gas = beside().body(moving(BallMotion::kOrbit));
    spot.scene.disc->emission = DiscEmission::kThermal, spot.scene.spots.emplace_back();
    gas.scene.medium.emplace().gas.flow = DiscFlowKind::kKepler;
    return {{"disc of gas that flows", disc("schwarzschild", 0.5)},
            {"spot on a disc about a rotating hole", spot},
            {"matter that moves", clump(beside())},
            {"matter that moves, with a moving ball, flat", clump(beside("minkowski").body(moving(BallMotion::kPath)))},
            {"matter that moves and a disc, rotating hole", clump(disc("kerr", 0.7))},
            {"gas about a hole, with a ball", gas}};
}

struct BesideSwitch {
    const char* name;
    void (*set)(Scene&);
};
constexpr BesideSwitch kSwitches[] = {
    {"as it is", [](Scene&) {}},
    {"delay off", [](Scene& s) { s.light.delay = false; }},
    {"delay and doppler off",
     [](Scene& s) {
         s.light.delay = s.light.doppler = false, s.camera.velocity = {0, 0, 0.3};
     }},
    {"delay, gravity and aberration off",
     [](Scene& s) {
         s.light.delay = s.light.gravity = s.light.aberration = false, s.camera.velocity = {0, 0.2, 0};
     }},
    {"delay off, shift and beaming off", [](Scene& s) { s.light.delay = s.light.shift = s.light.beaming = false; }},
    {"delay off, no more rays at edges", [](Scene& s) { s.light.delay = false, s.picture.refine = false; }},
    {"delay off, four rays a pixel",
     [](Scene& s) { s.light.delay = false, s.picture.refine = false, s.picture.samples = 2; }},
    {"delay and lensing off", [](Scene& s) { s.light.delay = s.light.lensing = false; }},
    {"delay off, later", [](Scene& s) { s.light.delay = false, s.time = 123.4; }},
    {"late and later", [](Scene& s) { s.time = 123.4; }}};

Scene scene_of(const BesideCase& c, const BesideSwitch& switched) {
    Scene scene = c.scene;
    switched.set(scene);
    for (Body& body : scene.bodies) body.material.colour = {1, 1, 1};
    return scene;
}

bool lit(const Image<float>& picture, int x, int y) {
    const float* p = picture.at(x, y);
    return std::max({p[0], p[1], p[2]}) > 0;
}

// Of pictures with a ray a pixel: lit pixels are those that rays hit, but for pixels at an edge, which a body covers in part.
void check_mask(const Image<float>& picture, const RayFrame& rays) {
    int hits = 0, dark = 0, alone = 0;
    float brightest = 0;
    for (const float part : picture.data) brightest = std::max(brightest, part);
    for (int y = 0; y < rays.height; ++y)
        for (int x = 0; x < rays.width; ++x) {
            if (rays.at(x, y).hit != 0) ++hits, dark += !lit(picture, x, y);
            if (rays.at(x, y).hit != 0 ||
                *std::max_element(picture.at(x, y), picture.at(x, y) + 3) < kWhole * brightest)
                continue;
            bool beside = false;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    if (x + dx >= 0 && x + dx < rays.width && y + dy >= 0 && y + dy < rays.height)
                        beside = beside || rays.at(x + dx, y + dy).hit != 0;
            alone += !beside;
        }
    CHECK(hits > 5);
    CHECK(dark == 0);
    CHECK(alone == 0);
}

bool same(const RayFrame& a, const RayFrame& b) {
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const RayPixel &p = a.pixels[i], &q = b.pixels[i];
        const double off = std::max({std::abs(p.u - q.u), std::abs(p.v - q.v), std::abs(p.w - q.w)});
        if (p.hit != q.hit || p.fate != q.fate || off > kSamePlace * std::max(1.0, std::abs(p.u))) return false;
    }
    return true;
}

double beside_off(const Image<float>& a, const Image<float>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i)
        most = std::max(most, std::abs(double(a.data[i]) - b.data[i]) / std::max(1.0, std::abs(double(b.data[i]))));
    return most;
}

void check_beside(GpuSession& session, const Scene& scene, bool bodies_alone) {
    Renderer& renderer = *session.renderer;
    renderer.want_delays(false);
    const Status ready = renderer.prepare(scene);
    const std::string reason = ready ? "" : ready.error().message();
    REQUIRE_MESSAGE(ready, reason);
    const Image<float> picture = renderer.picture();
    const RayFrame rays = renderer.ray_data();
    if (bodies_alone) {
        Scene bare = scene;
        bare.picture.refine = false, bare.picture.samples = 1;
        REQUIRE(renderer.prepare(bare));
        check_mask(renderer.picture(), rays);
    }
    renderer.want_delays(true);
    REQUIRE(renderer.prepare(scene));
    CHECK(renderer.picture().data == picture.data);
    CHECK(same(renderer.ray_data(), rays));
    const PictureLayers layers = draw_layers(renderer);
    CHECK(layers.all.data == picture.data);
    Image<float> sum(picture.width, picture.height, 3);
    for (const LayerImage& layer : layers.each)
        for (std::size_t i = 0; i < sum.data.size(); ++i) sum.data[i] += layer.light.data[i];
    CHECK(beside_off(sum, picture) < kBesideError);
    renderer.want_delays(false);
}

}  // namespace

TEST_CASE("beside the picture: ray data and layers are of it, and change nothing, whatever of light is switched off" *
          test::costly()) {
    on_one_context([](GpuSession& session) {
        const int step = by_depth(7, 2, 1);  // at quick depth of all, and odd: each switch with some things
        int number = 0;
        for (const bool alone : {true, false})
            for (const BesideCase& c : alone ? bodies() : others())
                for (const BesideSwitch& switched : kSwitches) {
                    // The first two of each, and one in `step` of the others.
                    const bool always = depth() != Depth::kQuick && &switched <= &kSwitches[1];
                    if (!always && number++ % step != 0) continue;
                    const Scene scene = scene_of(c, switched);
                    const LightSpec& light = scene.light;
                    if ((scene.medium || scene.spacetime.metric == "kerr") &&
                        !(light.lensing && light.doppler && light.gravity))
                        continue;  // refused
                    CAPTURE(std::string(c.name));
                    CAPTURE(switched.name);
                    check_beside(session, scene, alone);
                }
    });
}

namespace {

constexpr double kMotion_px = 0.02;

// How far, in px, what a pixel sees is from where its motion vector says in the next picture; not a number beside an image's rim.
double motion_error_px(const reference::FrameTracer& next, const RayPixel& seen, double x, double y) {
    constexpr double kStep = 0.02;  // px
    const auto place = [&](double to_x, double to_y) -> std::optional<Vec3> {
        const RayPixel there = next.pixel(to_x, to_y, false);
        if (there.hit != seen.hit || there.fate != seen.fate) return {};
        return seen.hit == 0 ? there.sky : Vec3{there.u, there.v, there.w};
    };
    const auto here = place(x, y), right = place(x + kStep, y), down = place(x, y + kStep);
    if (!here || !right || !down) return kNotANumber;
    const Vec3 wanted = seen.hit == 0 ? seen.sky : Vec3{seen.u, seen.v, seen.w}, off = wanted - *here,
               a = (*right - *here) / kStep, b = (*down - *here) / kStep;
    const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), det = aa * bb - ab * ab;
    return std::hypot((bb * dot(a, off) - ab * dot(b, off)) / det, (aa * dot(b, off) - ab * dot(a, off)) / det);
}

void check_motion(GpuSession& session, const char* name, int width) {
    auto scene = load_scene(name);
    REQUIRE_MESSAGE(scene, name);
    scene->camera.width = width, scene->camera.height = width * 9 / 16;
    scene->light.delay = false;  // what a disc's gas does meanwhile is not the camera's
    Scene next = *scene;
    next.camera.phi += 0.01, next.camera.theta += 0.004, next.camera.r *= 1.005, next.camera.yaw += 0.003;
    session.renderer->want_delays(true);
    const auto layers = cli::capture_layers(session, *scene, &next);
    REQUIRE(layers);
    const auto tracer = reference::FrameTracer::make(next);
    REQUIRE(tracer);
    std::vector<double> errors;
    int beside = 0;
    for (int y = 1; y < scene->camera.height; y += 5)
        for (int x = 1; x < width; x += 5) {
            const std::size_t i = layers->rays.index(x, y);
            if (layers->motion->known[i] == 0.0f) continue;
            const double off = motion_error_px(*tracer, layers->rays.pixels[i], x + 0.5 + layers->motion->right[i],
                                               y + 0.5 - layers->motion->up[i]);
            std::isfinite(off) ? errors.push_back(off) : void(++beside);
        }
    std::ranges::sort(errors);
    fmt::print("{} {} px: {} motion vectors, off by {:.4f} px, 99 of 100 {:.4f}, median {:.5f}; {} beside\n", name,
               width, errors.size(), errors.back(), errors[errors.size() * 99 / 100], errors[errors.size() / 2],
               beside);
    CHECK(errors.size() > 200);
    CHECK(errors.back() < kMotion_px);
}

}  // namespace

TEST_CASE("motion vectors lead to where the reference sees the same in the next picture" * test::costly()) {
    on_one_context([](GpuSession& session) {
        check_motion(session, "kerr", 160);
        if (depth() == Depth::kQuick) return;
        for (const char* name : {"first-light", "gargantua", "kerr"}) check_motion(session, name, 320);
    });
}

TEST_CASE("beside the picture: matter that is seen at once is, whatever moves beside it") {
    on_one_context([](GpuSession& session) {
        for (const char* metric : {"minkowski", "schwarzschild", "kerr"}) {
            CAPTURE(metric);
            const std::vector<BesideCase> all = others();
            const auto clump = std::ranges::find(all, "matter that moves", &BesideCase::name);
            Scene alone = scene_of(*clump, kSwitches[1]);
            alone.spacetime.metric = metric, alone.time = 4.0, alone.picture.refine = false;
            Scene beside = alone;
            BallSpec& ball = add(beside, BallSpec{{0, 100, 0}, 0.01, BallMotion::kOrbit});
            if (metric == std::string_view("minkowski"))
                ball.motion = BallMotion::kPath, ball.x = "0", ball.y = "100 + sin(t)", ball.z = "0";
            const Image<float> picture = picture_of(session, alone);
            CHECK(*std::ranges::max_element(picture.data) > 0.01f);
            CHECK(beside_off(picture_of(session, beside), picture) < kBallsImage);
        }
    });
}
