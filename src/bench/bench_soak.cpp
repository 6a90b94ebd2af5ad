// nullscope bench soak: thousands of frames along a random path with changes of scene. Memory stays, nothing is reported by OpenGL,
// no channel of any frame is NaN or infinite. Memory is the mean over the last 240 of 500 frames, in which every kind of scene comes
// up once, each read in its last frame: in its first ones OpenGL may still hold what the scene before it needed (12 MiB of 146).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "base/progress.h"
#include "bench/bench.h"
#include "command/arguments.h"
#include "command/json.h"
#include "compare/ray_errors.h"
#include "platform/usage.h"

namespace nullscope::cli {
namespace {

struct SoakBench : BenchOptions {
    SoakBench() { size = "96x54", frames = 20000; }
    unsigned seed = 1;
};

constexpr int kSpan = 500;  // frames in which every kind of scene is seen twice, the first time to compile its shader
constexpr double kMostGrowth = 0.02;  // of that memory: what a heap's fragments come and go by
constexpr int kFramesAScene = 10, kScenes = 24;

// A camera that drifts: every coordinate a sum of two waves of random frequency. Every kFramesAScene frames another kind of scene.
class Path {
public:
    explicit Path(unsigned seed) : random_(seed) {
        for (auto& wave : waves_) wave = {unit() * 0.02, unit() * 0.07, 2 * M_PI * unit(), 2 * M_PI * unit()};
    }
    Scene scene(int frame, int width, int height) const {
        Scene scene;
        const int kind = frame / kFramesAScene;
        CameraSpec& camera = scene.camera;
        camera.width = width + kind % 3, camera.height = height + kind % 2;
        camera.r = 1.02 * std::exp(2.5 * (1 + at(0, frame)));
        camera.theta = std::clamp(M_PI / 2 * (1 + at(1, frame)), 0.0, M_PI);
        // A disc that looks narrow has a shader of its own: both are compiled where each kind of scene is seen first.
        if (const int seen = frame % kFramesAScene; frame < kFramesAScene * kScenes && seen < 2)
            camera.r = 10, camera.theta = seen == 0 ? M_PI / 2 : 1.0;
        camera.phi = 3 * at(2, frame);
        camera.yaw = 2 * at(3, frame), camera.pitch = at(4, frame), camera.roll = 3 * at(5, frame);
        camera.plane_width = 2 * std::tan(0.5 * (0.55 + 0.15 * at(6, frame)));  // the sky's texture keeps its size
        if (kind % 2 == 1) camera.velocity = 0.9 * normalized(Vec3{at(7, frame), at(8, frame), at(9, frame) + 1e-3});
        if (kind % 3 != 0) scene.disc = DiscSpec{};
        if (kind % 3 == 2) scene.disc->opacity = 0.5, scene.disc->inner = 1.2, scene.disc->outer = 30;
        if (kind % 4 == 3) scene.spacetime.metric = "minkowski";
        if (kind / 12 % 2 == 1) scene.sky.kind = SkyKind::kBlack, camera.plane_width *= std::exp(4 * at(6, frame) - 3);
        return scene;
    }

private:
    struct Wave {
        double slow, fast, slow_phase, fast_phase;
    };
    double unit() { return static_cast<double>(random_()) / 4294967296.0; }
    double at(int i, int frame) const {  // -1 ... 1
        const Wave& w = waves_[i];
        return 0.6 * std::sin(w.slow * frame + w.slow_phase) + 0.4 * std::sin(w.fast * frame + w.fast_phase);
    }
    std::mt19937 random_;
    Wave waves_[10];
};

struct Counts {
    long long not_finite = 0;   // values of pictures and pixels of ray data
    std::vector<double> means;  // bytes resident, of each span
    double later() const { return *std::max_element(means.begin() + 1, means.end()); }
    double growth() const { return (later() - means.front()) / means.front(); }
};

Result<Counts> soak(Session& session, const SoakBench& options, int width, int height) {
    const Path path(options.seed);
    Counts counts;
    Progress progress("soak", options.frames);
    for (int frame = 0; frame < options.frames; ++frame, progress.advance()) {
        const Scene scene = path.scene(frame, width, height);
        TRY(ready, session.renderer->prepare(scene));
        const Image<float> picture = session.renderer->picture();  // throws what OpenGL reports
        const RayFrame rays = session.renderer->ray_data();
        counts.not_finite += std::ranges::count_if(picture.data, [](float v) { return !std::isfinite(v); });
        counts.not_finite += std::ranges::count(rays.pixels, false, all_finite);
        if (frame % kSpan == 0) counts.means.push_back(0);
        const int left = kSpan - 1 - frame % kSpan;  // frames of the span
        if (left < kFramesAScene * kScenes && left % kFramesAScene == 0)
            counts.means.back() += platform::resident_bytes() / kScenes;
        if ((frame + 1) % (4 * kSpan) == 0) {
            fmt::print("frame {:6}: {:.1f} MiB resident in the last {}\n", frame + 1, counts.means.back() / (1 << 20),
                       kSpan);
            std::fflush(stdout);
        }
    }
    return counts;
}

Result<int> run_soak(const SoakBench& options) {
    TRY(size, parse_size(options.size));
    platform::tighten_heap();
    TRY(session, open_session(options.context));
    TRY(counts, soak(*session, options, size->width, size->height));
    const bool flat = counts->growth() <= kMostGrowth, finite = counts->not_finite == 0;
    fmt::print(
        "{} frames on {}: resident memory {:.1f} MiB in the first {}, at most {:.1f} MiB after them: {:+.2f} % ({}); "
        "no OpenGL error; {} values not finite\n",
        options.frames, session->context->kind(), counts->means.front() / (1 << 20), kSpan, counts->later() / (1 << 20),
        100 * counts->growth(), flat ? "allowed: 2" : "more than 2", counts->not_finite);
    Json row{{"frames", options.frames},
             {"context", session->context->kind()},
             {"renderer", session->renderer->info().renderer},
             {"first_bytes", counts->means.front()},
             {"later_bytes", counts->later()},
             {"growth", counts->growth()},
             {"not_finite", counts->not_finite}};
    TRY(written, write_json(options.json, Json::array({std::move(row)})));
    return flat && finite ? 0 : 1;
}

}  // namespace

void add_bench_soak(Command& bench) {
    auto [command, options] =
        add_command<SoakBench>(bench, "soak",
                               "Draw thousands of frames along a random path through changing scenes; status "
                               "1 if memory grows or a value is not finite",
                               run_soak);
    number_option(command, "--frames", options.frames, 2 * kSpan, 100000000, "Number of frames");
    size_option(command, options);
    number_option(command, "--seed", options.seed, 0, 4294967295.0, "Seed of the random path");
    context_option(command, options.context);
    command.add_option("--json", &options.json, "Write the result to this file");
}

}  // namespace nullscope::cli
