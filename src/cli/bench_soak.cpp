// nullscope bench soak: thousands of frames along a random path with changes of scene. Memory stays, nothing is reported by OpenGL,
// no channel of any frame is NaN or infinite. Memory is its peak over 500 frames, in which every kind of scene comes up once:
// within them it goes up and down with what a scene calls for.
#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <random>
#include <vector>

#include "base/atomic_file.h"
#include "base/progress.h"
#include "cli/arguments.h"
#include "cli/bench.h"
#include "cli/json.h"
#include "cli/session.h"
#include "compare/ray_errors.h"

namespace nullscope::cli {
namespace {

struct Options {
    std::string size = "96x54", context = "auto", json;
    int frames = 20000;
    unsigned seed = 1;
};

constexpr int kSpan = 500;  // frames in which every kind of scene is seen; in the first of them its shader is compiled
constexpr double kMostGrowth = 0.02;  // of the peak: what a heap's fragments come and go by
constexpr int kFramesAScene = 10;     // 24 kinds of scene, each twice a span

double resident_bytes() {
    std::ifstream file("/proc/self/statm");
    double all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

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
    std::vector<double> peaks;  // bytes resident, of each span
    double later() const { return *std::max_element(peaks.begin() + 1, peaks.end()); }
    double growth() const { return (later() - peaks.front()) / peaks.front(); }
};

long long not_finite_of(const Image<float>& picture) {
    return std::count_if(picture.data.begin(), picture.data.end(), [](float v) { return !std::isfinite(v); });
}

Result<Counts> soak(Session& session, const Options& options, int width, int height) {
    const Path path(options.seed);
    Counts counts;
    Progress progress("soak", options.frames);
    for (int frame = 0; frame < options.frames; ++frame, progress.advance()) {
        const Scene scene = path.scene(frame, width, height);
        if (Status ready = session.renderer->prepare(scene); !ready) return ready.error();
        const Image<float> picture = session.renderer->picture();  // throws what OpenGL reports
        const RayFrame rays = session.renderer->ray_data();
        counts.not_finite += not_finite_of(picture);
        counts.not_finite +=
            std::count_if(rays.pixels.begin(), rays.pixels.end(), [](const RayPixel& p) { return !all_finite(p); });
        if (frame % kSpan == 0) counts.peaks.push_back(0);
        counts.peaks.back() = std::max(counts.peaks.back(), resident_bytes());
        if ((frame + 1) % (4 * kSpan) == 0) {
            fmt::print("frame {:6}: {:.1f} MiB resident at most in the last {}\n", frame + 1,
                       counts.peaks.back() / (1 << 20), kSpan);
            std::fflush(stdout);
        }
    }
    return counts;
}

int run(const Options& options) {
    const auto size = parse_size(options.size);
    if (!size) return report(size.error());
    // One heap that gives back what is free: what is measured is what is held, not where a heap of several threads has its gaps.
    ::mallopt(M_ARENA_MAX, 1);
    ::mallopt(M_TRIM_THRESHOLD, 1 << 17);
    ::mallopt(M_MMAP_THRESHOLD, 1 << 17);
    auto session = open_session(options.context);
    if (!session) return report(session.error());
    const auto counts = soak(*session, options, size->width, size->height);
    if (!counts) return report(counts.error());
    const bool flat = counts->growth() <= kMostGrowth, finite = counts->not_finite == 0;
    fmt::print(
        "{} frames on {}: resident memory {:.1f} MiB at most in the first {}, {:.1f} MiB after them: {:+.2f} % ({}); "
        "no OpenGL error; {} values not finite\n",
        options.frames, session->context->kind(), counts->peaks.front() / (1 << 20), kSpan, counts->later() / (1 << 20),
        100 * counts->growth(), flat ? "allowed: 2" : "more than 2", counts->not_finite);
    if (!options.json.empty()) {
        JsonObject o;
        o.add("frames", options.frames)
            .add("context", session->context->kind())
            .add("renderer", session->renderer->info().renderer);
        o.add("first_bytes", counts->peaks.front())
            .add("later_bytes", counts->later())
            .add("growth", counts->growth())
            .add("not_finite", counts->not_finite);
        if (Status written = write_text_atomically(options.json, json_list({o})); !written)
            return report(written.error());
    }
    return flat && finite ? 0 : 1;
}

}  // namespace

void add_bench_soak(Command& bench) {
    auto options = std::make_shared<Options>();
    Command& command = bench.add_command("soak",
                                         "Thousands of frames along a random path with changes of scene; status 1 if "
                                         "memory grows or a value is not finite");
    command.add_option("--frames", &options->frames, "How many").in_range(2 * kSpan, 100000000).show_default();
    command.add_option("--size", &options->size, "Frame size, WIDTHxHEIGHT").show_default();
    command.add_option("--seed", &options->seed, "Another path").in_range(0, 4294967295.0).show_default();
    context_option(command, options->context);
    command.add_option("--json", &options->json, "Write the result to this file");
    command.on_run([options] { return run(*options); });
}

}  // namespace nullscope::cli
