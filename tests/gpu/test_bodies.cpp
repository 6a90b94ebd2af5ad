// Solid bodies: every pixel of many small frames against the reference; what an effect that is off leaves out on the GPU; formulas.
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "base/assets.h"
#include "base/text.h"
#include "expr/formula.h"
#include "scene/bodies.h"
#include "shaderlib/preprocess.h"
#include "spacetime/registry.h"
#include "spacetime/tortoise.h"
#include "support/draft.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr double kScreenError_px = 0.05;  // the project's promise

struct Case {
    const char* name;
    std::function<void(Scene&)> set;
};

void flat(Scene& s) { s.spacetime.metric = "minkowski"; }
void narrow(Scene& s, double fov_rad) { s.camera.plane_width = 2 * std::tan(0.5 * fov_rad); }

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"sphere", [](Scene& s) { add<SphereSpec>(s); }},
        {"sphere, all of it seen", [](Scene& s) { add<SphereSpec>(s).radius = 1.76031; }},
        {"sphere within the photon sphere", [](Scene& s) { add<SphereSpec>(s).radius = 1.2, narrow(s, 0.6); }},
        {"sphere on the photon sphere", [](Scene& s) { add<SphereSpec>(s).radius = 1.5, narrow(s, 0.6); }},
        {"sphere just outside the horizon", [](Scene& s) { add<SphereSpec>(s).radius = 1.001, narrow(s, 0.6); }},
        {"sphere below the camera", [](Scene& s) { add<SphereSpec>(s).radius = 14.99, narrow(s, 2.5); }},
        {"sphere, camera within the photon sphere",
         [](Scene& s) { add<SphereSpec>(s).radius = 1.1, s.camera.r = 1.3, narrow(s, 2.5); }},
        {"sphere from afar", [](Scene& s) { add<SphereSpec>(s).radius = 2, s.camera.r = 1e4, narrow(s, 8e-4); }},
        {"sphere, flat", [](Scene& s) { add<SphereSpec>(s), flat(s); }},
        {"sphere, fast camera",
         [](Scene& s) {
             add<SphereSpec>(s), s.camera.velocity = {-0.3, 0.2, 0.6};
         }},
        {"cylinder", [](Scene& s) { add<CylinderSpec>(s); }},
        {"cylinder from its plane", [](Scene& s) { add<CylinderSpec>(s), s.camera.theta = M_PI / 2; }},
        {"cylinder from the axis", [](Scene& s) { add<CylinderSpec>(s), s.camera.theta = 0; }},
        {"thin cylinder, flat", [](Scene& s) { add<CylinderSpec>(s).height = 0.05, flat(s); }},
        {"ball behind",
         [](Scene& s) {
             add<BallSpec>(s).position = {-12, 1, 0.5};
         }},
        {"ball before",
         [](Scene& s) {
             add<BallSpec>(s).position = {6, 1, -1};
         }},
        {"ball, flat", [](Scene& s) { add<BallSpec>(s), flat(s); }},
        {"small ball behind",
         [](Scene& s) {
             add<BallSpec>(s).position = {-10, 0.3, 0}, first_shape<BallSpec>(s)->radius = 0.3;
         }},
        {"surface", [](Scene& s) { add<SurfaceSpec>(s); }},
        {"surface of two pieces, flat",
         [](Scene& s) {
             add<SurfaceSpec>(s).shape = "min(length(x, y - 3, z) - 1, max(abs(x), max(abs(y + 3), abs(z))) - 1)",
             flat(s);
         }},
        {"all, with discs between",
         [](Scene& s) {
             add<SphereSpec>(s).radius = 1.4, add<CylinderSpec>(s).inner = 5, first_shape<CylinderSpec>(s)->outer = 6,
             add<BallSpec>(s).position = {-9, 3, 2};
             s.disc.emplace().inner = 2, s.disc->outer = 4.5, s.disc->opacity = 0.5;
         }},
    };
    return all;
}

TEST_CASE("bodies: hits, places and fates are the reference's at every pixel" * test::costly()) {
    MeasuredOnce measured;
    on_every_context([&](GpuSession& session) {
        Selection selection(3);
        for (const Case& c : cases()) {
            if (!selection.takes_next()) continue;
            const std::string name = c.name;
            CAPTURE(name);
            Scene scene;
            scene.sky.kind = SkyKind::kBlack;
            scene.camera.width = 161;
            scene.camera.height = 91;
            c.set(scene);
            const RayFrame frame = gl_ray_data(session, scene);
            if (measured.known(name, frame)) continue;
            const RayMeasures m = measure_rays(frame, scene.camera, reference_trace(scene));
            fmt::print("{:<7} {:<40} screen {:.1e}, place {:.1e}, swept {:.1e} px; fate errors {}, forgiven {}\n",
                       session.context->kind(), c.name, m.sky_px.max, m.place_px.max, m.angle_px.max, m.fate_errors,
                       m.forgiven);
            CHECK(m.not_finite == 0);
            CHECK(m.fate_errors == 0);
            CHECK(m.place_px.count > 0);
            CHECK(m.sky_px.max <= kScreenError_px);
            CHECK(m.place_px.max <= kScreenError_px);
            CHECK(m.angle_px.max <= kScreenError_px);
        }
    });
}

// Pixels that show bodies' light though they and all of their neighbours look at the sky.
int lit_beside_bodies(GpuSession& session, Scene& scene) {
    scene.camera.width = 32, scene.camera.height = 18, scene.camera.r = 28.3;
    scene.sky.kind = SkyKind::kPlain;
    scene.picture.refine = false;
    REQUIRE(session.renderer->prepare(scene));
    const Image<float> picture = session.renderer->picture();
    const RayFrame rays = session.renderer->ray_data();
    const float sky = *picture.at(0, 0);
    int lit = 0;
    for (int y = 1; y + 1 < rays.height; ++y)
        for (int x = 1; x + 1 < rays.width; ++x) {
            bool alone = true;
            for (int j = y - 1; j <= y + 1; ++j)
                for (int i = x - 1; i <= x + 1; ++i) alone = alone && rays.at(i, j).fate == Fate::kEscaped;
            lit += alone && std::abs(*picture.at(x, y) - sky) > 1e-4F * sky;
        }
    return lit;
}

// Soft edges are half a pixel wide, and pixels are wide here: what one body's formula is far from it must not count for another's distance.
TEST_CASE("bodies: two kinds side by side shed no light beside them" * test::costly()) {
    const std::vector<std::pair<const char*, void (*)(Scene&)>> bodies = {
        {"sphere", [](Scene& s) { add_body<SphereSpec>(s); }},
        {"cylinder", [](Scene& s) { add_body<CylinderSpec>(s); }},
        {"ball",
         [](Scene& s) {
             add<BallSpec>(s).position = {6, 0, 0};
         }},
        {"steep surface", [](Scene& s) { add<SurfaceSpec>(s).shape = "40 * (length(x, y - 5, z) - 2)"; }},
        {"surface", [](Scene& s) { add_body<SurfaceSpec>(s); }}};
    on_one_context([&](GpuSession& session) {
        const int step = by_depth(6, 3, 1);
        int number = 0;
        for (const char* metric : {"minkowski", "schwarzschild", "kerr"})
            for (std::size_t a = 0; a < bodies.size(); ++a)
                for (std::size_t b = a + 1; b < bodies.size(); ++b) {
                    if (number++ % step != 0) continue;
                    CAPTURE(metric);
                    CAPTURE(bodies[a].first);
                    CAPTURE(bodies[b].first);
                    Scene scene;
                    scene.spacetime.metric = metric;
                    bodies[a].second(scene), bodies[b].second(scene);
                    CHECK(lit_beside_bodies(session, scene) == 0);
                }
    });
}

// A labyrinth wider than the view: every ray ends on it (the reference's all do), so that its edges and what is thinner than a pixel stand
// before more of it, not before the sky. One ray a pixel.
TEST_CASE("bodies: behind a body's edge is what lies behind it") {
    static constexpr float kLeast = 0.98F;  // of its light; 0.85 where edges stand before the sky
    on_one_context([](GpuSession& session) {
        for (const char* metric : {"schwarzschild", "kerr"}) {
            Scene scene = Draft()
                              .metric(metric)
                              .size(64, 36)
                              .sky(SkyKind::kBlack)
                              .body(SurfaceSpec{.kind = SurfaceKind::kGyroid});
            scene.picture.refine = false;
            REQUIRE(session.renderer->prepare(scene));
            const Image<float> picture = session.renderer->picture();
            float sum = 0;
            for (int y = 0; y < 36; ++y)
                for (int x = 0; x < 64; ++x) sum += *picture.at(x, y);
            CAPTURE(metric);
            CHECK(sum / (64 * 36) > kLeast);
        }
    });
}

// A pixel is nearly as wide as the ball, and its texture half dark: half of its light, not that of one place.
TEST_CASE("bodies: a ball of about a pixel shows the mean of its texture") {
    on_one_context([](GpuSession& session) {
        const auto light = [&](double radius, TextureKind texture) {
            Scene scene = Draft().metric("minkowski").size(64, 36).sky(SkyKind::kBlack).scene;
            scene.picture.refine = false;
            scene.camera.r = 50, scene.camera.theta = M_PI / 2;
            narrow(scene, M_PI / 3);
            add(scene, BallSpec{.position = {-100, 3, 1}, .radius = radius});
            Material& material = scene.bodies.back().material;
            material.texture = texture, material.rows = 9;
            material.colour = {1, 1, 1}, material.second_colour = {};
            REQUIRE(session.renderer->prepare(scene));
            return sum_of(session.renderer->picture());
        };
        for (const double radius : {1.5, 2.0, 3.0}) {
            CAPTURE(radius);
            const double share = light(radius, TextureKind::kStripes) / light(radius, TextureKind::kPlain);
            CHECK(share > 0.35);
            CHECK(share < 0.65);
        }
    });
}

// The rounding of the camera's distance is far above a body's size: from there all is as from 1e5 r_s, but for what that is nearer. Moving
// bodies are looked at when light of the same time arrives.
TEST_CASE("bodies: from far away hits and places are those from nearer" * test::costly()) {
    struct Far {
        const char *name, *metrics;
        std::function<void(Scene&)> add;
    };
    const Far bodies[] = {
        {"ball", "minkowski schwarzschild ellis kerr",
         [](Scene& s) {
             add<BallSpec>(s).position = {0, 1.5, 4}, first_shape<BallSpec>(s)->radius = 2;
         }},
        {"cylinder", "minkowski schwarzschild ellis",
         [](Scene& s) { add<CylinderSpec>(s) = {.inner = 3, .outer = 4.5, .height = 1}; }},
        {"torus", "minkowski schwarzschild",
         [](Scene& s) { add<SurfaceSpec>(s) = {.shape = "(length(x, y) - 3.5)^2 + z^2 - 1", .bound = 5}; }},
        {"sphere", "minkowski schwarzschild", [](Scene& s) { add<SphereSpec>(s); }},
        {"disc", "minkowski schwarzschild", [](Scene& s) { s.disc.emplace().inner = 3, s.disc->outer = 4.5; }},
        {"moving ball", "minkowski schwarzschild kerr",
         [](Scene& s) {
             auto& ball = add<BallSpec>(s);
             ball.motion = BallMotion::kPath, ball.radius = 1.5;
             ball.x = "4 * cos(t / 8)", ball.y = "4 * sin(t / 8)", ball.z = "0";
         }},
    };
    constexpr double kHalf = 6, kNear = 1e5, kPlace = 5e-3;  // r_s; of the picture's width
    on_every_context([&](GpuSession& session) {
        for (const Far& body : bodies)
            for (const std::string& metric : split(body.metrics, ' ')) {
                const auto seen_from = [&](double r) {
                    Scene scene;
                    scene.sky.kind = SkyKind::kBlack;
                    scene.spacetime.metric = metric;
                    if (metric == "kerr") scene.spacetime.parameters["spin"] = 0.9;
                    const auto spacetime = make_spacetime(metric, scene.spacetime.parameters);
                    REQUIRE(spacetime);
                    scene.time = r + (metric == "ellis" ? 0 : time_ahead(**spacetime, r)) + 3;
                    scene.camera.r = r, scene.camera.theta = 1.2, scene.camera.plane_width = 2 * kHalf / r;
                    scene.camera.width = 21, scene.camera.height = 15;
                    body.add(scene);
                    return gl_ray_data(session, scene);
                };
                const RayFrame near = seen_from(kNear);
                for (const double r : {1e7, 1e9}) {
                    const std::string name = fmt::format("{}, {}, from {}", metric, body.name, r);
                    CAPTURE(name);
                    const RayFrame far = seen_from(r);
                    int hits = 0, other = 0;
                    double off = 0;
                    for (std::size_t i = 0; i < far.pixels.size(); ++i) {
                        const RayPixel &a = far.pixels[i], &b = near.pixels[i];
                        hits += b.hit != 0, other += a.hit != b.hit;
                        if (a.hit != 0 && b.hit != 0) off = std::max(off, std::hypot(a.u - b.u, a.v - b.v, a.w - b.w));
                    }
                    fmt::print("{:<7} {:<40} {} hits, {} others, places {:.1e} r_s\n", session.context->kind(), name,
                               hits, other, off);
                    CHECK(hits > 10);
                    CHECK(other <= 1);  // next to a silhouette
                    CHECK(off < kPlace);
                }
            }
    });
}

// What is on the GPU for a scene.
std::set<std::string> textures_of(GpuSession& session, const Scene& scene) {
    REQUIRE(session.renderer->prepare(scene));
    std::set<std::string> names;
    for (const auto& line : session.renderer->textures()) names.insert(line.name);
    return names;
}

TEST_CASE("bodies: tables and textures are there for the effects that are on, and go with them") {
    using Names = std::set<std::string>;
    on_every_context([](GpuSession& session) {
        Scene scene;
        scene.camera.width = scene.camera.height = 16;
        scene.sky.kind = SkyKind::kBlack;
        flat(scene);
        const auto now = [&] { return textures_of(session, scene); };
        CHECK(now() == Names{});
        scene.camera.velocity = {0, 0, 0.5};  // aberration has neither
        CHECK(now() == Names{});
        // Nor have bodies and patterns in flat space.
        add_body<SphereSpec>(scene).material.texture = TextureKind::kChecker;
        add_body<CylinderSpec>(scene).material.texture = TextureKind::kNoise;
        add_body<BallSpec>(scene).material.texture = TextureKind::kFormula;
        first_body<BallSpec>(scene)->material.formula = "u";
        CHECK(now() == Names{});
        add<SurfaceSpec>(scene);
        CHECK(now() == Names{"surface clearance"});
        first_body<SphereSpec>(scene)->material.texture = TextureKind::kImage;
        first_body<SphereSpec>(scene)->material.image = assets_directory() / "images" / "accretion-disc.png";
        CHECK(now() == Names{"sphere image", "surface clearance"});
        // One file on bodies of two kinds, and in two mappings, is one texture.
        first_body<CylinderSpec>(scene)->material = first_body<SphereSpec>(scene)->material;
        const Material same = first_body<CylinderSpec>(scene)->material;
        Material& other = add_body<SphereSpec>(scene).material;
        other = same, other.mapping = BodyMapping::kCubeFaces;
        CHECK(now().size() == 2);
        remove_bodies<SphereSpec>(scene), remove_bodies<CylinderSpec>(scene), remove_bodies<BallSpec>(scene),
            remove_bodies<SurfaceSpec>(scene);
        CHECK(now() == Names{});
        scene.disc.emplace();
        CHECK(now() == Names{"disc image"});
        scene.disc->opacity = 0.5;
        CHECK(now() == Names{"disc image"});
        scene.spacetime.metric = "schwarzschild";
        CHECK(now() == Names{"disc image", "strip", "ray ends", "orbit table"});
        scene.disc.reset();
        scene.sky.kind = SkyKind::kStars;
        const Names sky_only = now();
        CHECK(sky_only.count("orbit table") == 0);
        CHECK(sky_only.count("sky") == 1);
        scene.sky.kind = SkyKind::kBlack;
        for (int body = 0; body < 4; ++body) {
            Scene with = scene;
            if (body == 0) add<SphereSpec>(with);
            if (body == 1) add<CylinderSpec>(with);
            if (body == 2) add<BallSpec>(with);
            if (body == 3) add<SurfaceSpec>(with);
            CHECK(textures_of(session, with).count("orbit table") == 1);
            CHECK(textures_of(session, scene).count("orbit table") == 0);
        }
    });
}

TEST_CASE("formulas: the driver computes what C++ does") {
    const std::vector<std::string> texts = {"x + 2 * y - z / 3",
                                            "sin(7 * x) * cos(y)",
                                            "x^3 - y^-2",
                                            "sqrt(x) + log(y)",
                                            "atan(y, x)",
                                            "atan(3 * x)",
                                            "mod(5 * x, 0.7 + y^2)",
                                            "length(x, y, z)",
                                            "noise(9 * x, 9 * y, 3)",
                                            "smoothstep(-0.5, 0.5, x)",
                                            "step(x, y) + floor(4 * x)",
                                            "exp(2 * x) * tan(x)",
                                            "clamp(x, -0.3, 0.4) + mix(x, y, 0.3)",
                                            "abs(x)^1.7",
                                            "1 / (x - x)",
                                            "exp(exp(exp(9)))"};
    on_every_context([&](GpuSession&) {
        constexpr int kSide = 32;
        const gl::VertexArray empty = gl::make_vertex_array();
        for (const std::string& text : texts) {
            CAPTURE(text);
            const auto formula = expr::Formula::parse(text, {"x", "y", "z"});
            REQUIRE(formula);
            std::string fragment = "#version 330 core\n" + resolved_text("effect/expression.glsl", {}, shader_file) +
                                   "out vec4 colour;\nvoid main() {\n    float x = (gl_FragCoord.x - 15.75) / 16.0;\n"
                                   "    float y = (gl_FragCoord.y - 15.75) / 16.0;\n    float z = 0.25;\n" +
                                   formula->glsl("value") + "    colour = vec4(value);\n}\n";
            const gl::Program program =
                gl::make_program("#version 330 core\n" + std::string(shader_file("stage/fullscreen.vert")), fragment);
            const gl::Target target = gl::make_target(kSide, kSide, gl::Format::kRgba32F);
            gl::draw_fullscreen(program, empty, target.framebuffer.id(), kSide, kSide);
            std::vector<float> pixels(4 * kSide * kSide);
            gl::read_rgba32f(target, 0, pixels.data());
            double worst = 0;
            for (int j = 0; j < kSide; ++j)
                for (int i = 0; i < kSide; ++i) {
                    const double values[] = {(i + 0.5 - 15.75) / 16, (j + 0.5 - 15.75) / 16, 0.25},
                                 exact = formula->value(values);
                    const double drawn = pixels[4 * static_cast<std::size_t>(j * kSide + i)];
                    worst = std::max(worst, std::abs(drawn - exact) / std::max(1.0, std::abs(exact)));
                }
            fmt::print("{:<40} {:.1e}\n", text, worst);
            CHECK(worst < 2e-5);  // software drivers' sin, exp and log: some 1e-6 each
        }
    });
}

}  // namespace
