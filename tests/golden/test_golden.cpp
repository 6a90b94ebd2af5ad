// Every case of cases.csv on every context: ray data against the reference, colours against the golden picture. A failure
// leaves one HTML file in the build folder and prints its path.
#include <algorithm>
#include <numeric>

#include "base/atomic_file.h"
#include "base/text.h"
#include "compare/heat_map.h"
#include "compare/image_metrics.h"
#include "gl/compute.h"
#include "golden/golden_case.h"
#include "image/image_file.h"
#include "scene/split.h"
#include "scenefile/scene_file.h"
#include "support/folders.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

constexpr std::size_t kReportedPixels = 20;

const std::vector<GoldenCase>& golden_cases() {
    static const auto cases = read_golden_cases(golden_folder() / "cases.csv");
    const std::string reason = cases ? "" : cases.error().message();
    REQUIRE_MESSAGE(static_cast<bool>(cases), reason);
    return *cases;
}

const int kRowStep = by_depth(12, 6, 1);  // rows of which every pixel's ray is traced again

// What was drawn on a context and what it should be.
struct Outcome {
    Scene scene;
    RayFrame rays;
    RayMeasures measures;
    Image<unsigned char> picture;
    std::vector<std::string> failures;
    std::vector<PixelPlace> worst;
    Image<float> heat;
    HeatScale scale;
};

Image<float> display_values(const Image<unsigned char>& picture) {
    Image<float> values(picture.width, picture.height, 3);
    std::transform(picture.data.begin(), picture.data.end(), values.data.begin(),
                   [](unsigned char v) { return static_cast<float>(v) / 255; });
    return values;
}

void judge_rays(const GoldenCase& golden, Outcome& outcome) {
    const RayMeasures& m = outcome.measures;
    const auto within = [&](const char* what, double worst) {
        if (!(worst <= golden.rays_px))
            outcome.failures.push_back(fmt::format("{} off by {:.4g} px; allowed: {}", what, worst, golden.rays_px));
    };
    within("sky direction", m.sky_px.max);
    within("place on the disc", m.place_px.max);
    within("swept angle", m.angle_px.max);
    within("g", m.g_px.max);
    if (m.fate_errors > 0) outcome.failures.push_back(fmt::format("{} fate errors; allowed: 0", m.fate_errors));
    if (m.not_finite > 0) outcome.failures.push_back(fmt::format("{} pixels not finite; allowed: 0", m.not_finite));
    outcome.worst = worst_pixels(m, kReportedPixels);
    outcome.heat = Image<float>(m.width, m.height, 1);
    std::transform(m.pixels.begin(), m.pixels.end(), outcome.heat.data.begin(),
                   [](const PixelErrors& e) { return e.worst_px(); });
    outcome.scale = {1e-4, 1};
}

std::vector<PixelPlace> largest_differences(const Image<float>& difference) {
    std::vector<int> order(difference.data.size());
    std::iota(order.begin(), order.end(), 0);
    const std::size_t count = std::min(kReportedPixels, order.size());
    std::partial_sort(
        order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(), [&](int a, int b) {
            return difference.data[static_cast<std::size_t>(a)] > difference.data[static_cast<std::size_t>(b)];
        });
    std::vector<PixelPlace> places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back({order[i] % difference.width, order[i] / difference.width});
    return places;
}

void judge_colours(const GoldenCase& golden, const Image<float>& wanted, Outcome& outcome) {
    const auto m = measure_images(display_values(outcome.picture), wanted, golden.above);
    if (!m) {
        outcome.failures.push_back(m.error().message());
        return;
    }
    fmt::print("{:<17} mean {:.5f}, median {:.4f}, 99.9 % {:.3f}, above {} {:.4f}, PSNR {:.1f} dB\n", golden.name,
               m->mean, m->median, m->p999, golden.above, m->fraction_above, m->psnr_db);
    if (!(m->mean <= golden.mean))
        outcome.failures.push_back(fmt::format("mean difference {:.5f}; allowed: {}", m->mean, golden.mean));
    if (!(m->fraction_above <= golden.fraction))
        outcome.failures.push_back(fmt::format("{:.5f} of the pixels differ by more than {}; allowed: {}",
                                               m->fraction_above, golden.above, golden.fraction));
    outcome.worst = largest_differences(m->difference);
    outcome.heat = m->difference;
    outcome.scale = {1e-3, 1};
}

void fail(const GoldenCase& golden, GpuSession& session, const Outcome& outcome, const std::string& kind,
          const Image<unsigned char>& wanted) {
    const ExactTrace trace = reference_trace(outcome.scene);
    const CoreInput input = session.renderer->tables().core_input();
    FailureReport report;
    report.title = fmt::format("{}: {} on {}", golden.name, kind, session.context->kind());
    report.reasons = outcome.failures;
    report.pictures = {{"drawn", outcome.picture},
                       {"golden, by the reference", wanted},
                       {"difference, " + kind, heat_map(outcome.heat, outcome.scale)}};
    for (const PixelPlace p : outcome.worst) {
        const Witnesses witnesses = witnesses_of(outcome.scene, input, outcome.rays, p.x, p.y);
        const ExactPixel exact = exact_pixel(outcome.scene.camera, trace, p.x, p.y);
        report.pixels.push_back({p.x, p.y, outcome.measures.at(p.x, p.y), witnesses, verdict_of(witnesses, exact)});
    }
    const std::filesystem::path file =
        reports_folder() / fmt::format("{}-{}-{}.html", golden.name, session.context->kind(), kind);
    const Status saved = save_report(file, report);
    std::string sentence =
        fmt::format("{}; see {}", outcome.failures.front(), saved ? file.string() : saved.error().message());
    FAIL_CHECK(sentence);
}

Image<unsigned char> bytes_of(const Image<float>& linear) {
    const Image<float> shown = nullscope::display_values(linear);
    Image<unsigned char> bytes(shown.width, shown.height, 3);
    for (std::size_t i = 0; i < bytes.data.size(); ++i)
        bytes.data[i] = static_cast<unsigned char>(
            255 * shown.data[i / 3 * static_cast<std::size_t>(shown.channels) + i % 3] + 0.5f);
    return bytes;
}

// Of all cases of this program, by fragments and by compute shaders.
MeasuredOnce& measured_rays() {
    static MeasuredOnce measured;
    return measured;
}

// compute: by compute shaders, as far as its parts have them.
void run_case(const GoldenCase& golden, GpuSession& session, MeasuredOnce& measured, bool compute = false) {
    if (golden.contexts.find(session.context->kind()) == std::string::npos) return;
    auto scene = golden_scene(golden);
    const std::string reason = scene ? "" : scene.error().message();
    REQUIRE_MESSAGE(static_cast<bool>(scene), reason);
    const auto file = golden_folder() / "images" / (golden.name + ".png");
    const auto wanted = load_image(file);
    REQUIRE_MESSAGE(static_cast<bool>(wanted), "no golden picture: scripts/update-goldens.sh makes " << file.string());
    session.renderer = std::make_unique<Renderer>();
    session.renderer->compute(compute);
    const auto split = halves(*scene);
    Outcome colours;
    const std::vector<Scene> parts = split ? std::vector<Scene>{split->left, split->right} : std::vector<Scene>{*scene};
    for (const Scene& part : parts) {
        Outcome rays;
        rays.scene = part;
        rays.rays = gl_ray_data(session, part);
        rays.picture = session.renderer->picture8();
        // In a zoom the sky does not move along the ring, and no screen error says what is off there: tests/proof/test_ring_view.cpp.
        const bool known =
            part.camera.zoom || measured.known(golden.name + (&part == &parts.back() ? "" : ", left"), rays.rays);
        if (!known) rays.measures = measure_rays(rays.rays, part.camera, reference_trace(part), kRowStep);
        const Image<unsigned char> before = std::move(colours.picture);
        colours = rays;
        if (before.width > 0) colours.picture = side_by_side(before, rays.picture);
        if (!known) judge_rays(golden, rays);
        if (!rays.failures.empty()) fail(golden, session, rays, "rays", bytes_of(*wanted));
    }
    judge_colours(golden, nullscope::display_values(*wanted), colours);
    if (!colours.failures.empty() && colours.measures.pixels.empty())
        colours.measures = measure_rays(colours.rays, colours.scene.camera, reference_trace(colours.scene));
    if (split) colours.worst.clear();  // places in no single spacetime's picture
    if (!colours.failures.empty()) fail(golden, session, colours, "colours", bytes_of(*wanted));
}

TEST_CASE("every case is as the reference draws it") {
    on_every_context([&](GpuSession& session) {
        int number = 0;
        Selection selection(5);
        for (const GoldenCase& golden : golden_cases()) {
            if (!selection.takes_next()) continue;
            CAPTURE(golden.name);
            if (session.context->kind() == std::string("osmesa") && number++ % 3 != 0 && !everything_asked())
                continue;  // that both draw the same bits has a test
            run_case(golden, session, measured_rays());
        }
    });
}

// Some of them: that all are the same picture as by fragments has a test of its own (gpu/test_compute.cpp).
TEST_CASE("cases are as the reference draws them by compute shaders too") {
    const int step = by_depth(25, 5, 1);
    on_one_context([&](GpuSession& session) {
        if (!gl::computes()) {
            MESSAGE("this OpenGL is older than 4.3");
            return;
        }
        int number = 0;
        for (const GoldenCase& golden : golden_cases()) {
            if (number++ % step != 0) continue;
            CAPTURE(golden.name);
            run_case(golden, session, measured_rays(), true);
            CHECK(session.renderer->computed().drawn() > 0);
        }
    });
}

TEST_CASE("every scene that ships has a case, every picture a case") {
    const auto& cases = golden_cases();
    const auto has = [&](const std::string& name) {
        return std::any_of(cases.begin(), cases.end(), [&](const GoldenCase& c) { return c.name == name; });
    };
    for (const SceneInfo& scene : shipped_scenes())
        CHECK_MESSAGE(has(scene.name), "tests/golden/cases.csv lacks " << scene.name);
    for (const auto& file : std::filesystem::directory_iterator(golden_folder() / "images"))
        CHECK_MESSAGE(has(file.path().stem().string()), "of no case: " << file.path().string());
}

TEST_CASE("a broken list of cases is refused") {
    const auto file = std::filesystem::temp_directory_path() / "nullscope-golden-cases.csv";
    for (const char* line : {"flat, 320x180, egl, 0.05, 1, 0.1", "flat, 320, egl, 0.05, 1, 0.1, 1, why",
                             "flat, 3x2, egl, 0.05, 1, -1, 1, why", "flat, 3x2, egl, 0.05, 1, 0.1, 1,"}) {
        CAPTURE(line);
        REQUIRE(write_text_atomically(file, std::string("scene\n") + line + "\n"));
        CHECK(!read_golden_cases(file));
    }
    std::filesystem::remove(file);
}

}  // namespace
