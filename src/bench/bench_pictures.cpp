// nullscope bench pictures: what the display shows, against the reference with many rays a pixel. At pixels drawn by lot, for the reference
// takes hours for a whole picture of some scenes. Bloom and automatic exposure, which need the whole picture, are off in both.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "bench/bench.h"
#include "command/arguments.h"
#include "command/json.h"
#include "command/reference_inputs.h"
#include "render/display.h"

namespace nullscope::cli {
namespace {

struct PicturesBench : BenchOptions {
    PicturesBench() { size = "960x540"; }
    int pixels = 4000, samples = 16, seconds = 120;
};

// What a picture may be off by, of 255: on average, and in all but a thousandth of its pixels (told by --help too).
constexpr double kMostMean = 2.0, kMostThousandth = 24.0;
constexpr std::size_t kAtOnce = 64;  // pixels between two looks at the clock
constexpr unsigned kSeed = 20261125;

struct Off {
    double mean = 0.0, hundredth = 0.0, thousandth = 0.0;
};

// By the largest channel of each pixel, but for the mean. parts: of a difference that counts.
Off off_between(const Image<unsigned char>& a, const Image<unsigned char>& b, double part) {
    std::vector<double> most;
    double sum = 0.0;
    for (std::size_t i = 0; i < a.data.size(); i += 3) {
        double largest = 0.0;
        for (std::size_t k = i; k < i + 3; ++k) {
            const double off = part * std::abs(static_cast<double>(a.data[k]) - static_cast<double>(b.data[k]));
            sum += off;
            largest = std::max(largest, off);
        }
        most.push_back(largest);
    }
    std::ranges::sort(most);
    const auto at = [&](double share) {
        return most[std::min(most.size() - 1, static_cast<std::size_t>(share * static_cast<double>(most.size())))];
    };
    return {sum / static_cast<double>(a.data.size()), at(0.99), at(0.999)};
}

struct Compared {
    std::size_t pixels = 0;
    Off picture, reference;  // the latter: of the two halves of its rays, half of the difference
    bool within() const { return picture.mean <= kMostMean && picture.thousandth <= kMostThousandth; }
};

Result<Compared> compare(Session& session, Scene scene, const PicturesBench& options) {
    scene.picture.bloom = 0.0, scene.picture.auto_exposure = false;
    TRY(ready, session.renderer->prepare(scene));
    const Image<float> drawn = session.renderer->picture();
    TRY(inputs, load_reference_inputs(scene));
    std::vector<std::array<int, 2>> places;
    for (int y = 0; y < drawn.height; ++y)
        for (int x = 0; x < drawn.width; ++x) places.push_back({x, y});
    std::ranges::shuffle(places, std::mt19937(kSeed));
    places.resize(std::min(places.size(), static_cast<std::size_t>(options.pixels)));
    const Stopwatch watch;
    std::vector<reference::PixelLight> lights;
    {
        Progress progress("pixels of " + scene.name, static_cast<long long>(places.size()));
        while (lights.size() < places.size() && (lights.empty() || watch.ms() < 1e3 * options.seconds)) {
            const auto first = places.begin() + static_cast<std::ptrdiff_t>(lights.size());
            const std::size_t count = std::min(kAtOnce, places.size() - lights.size());
            TRY(some, reference::render_pixels(scene, (*inputs)->sky, (*inputs)->pictures(scene), options.samples,
                                               {first, first + static_cast<std::ptrdiff_t>(count)}, (*inputs)->far()));
            lights.insert(lights.end(), some->begin(), some->end());
            progress.advance(static_cast<long long>(count));
        }
    }
    const int count = static_cast<int>(lights.size());
    Image<float> shown(count, 1, 3), exact(count, 1, 3), even(count, 1, 3), odd(count, 1, 3);
    for (int i = 0; i < count; ++i) {
        const auto [x, y] = places[static_cast<std::size_t>(i)];
        std::copy_n(drawn.at(x, y), 3, shown.at(i, 0));
        const reference::PixelLight& at = lights[static_cast<std::size_t>(i)];
        const auto put = [i](Image<float>& image, Vec3 light) {
            for (int k = 0; k < 3; ++k)
                image.at(i, 0)[k] = static_cast<float>(k == 0 ? light.x : k == 1 ? light.y : light.z);
        };
        put(exact, at.light), put(even, at.light + at.uncertainty), put(odd, at.light - at.uncertainty);
    }
    const auto displayed = [&](const Image<float>& light) {
        return display_encoded(light, scene.camera.exposure_ev, scene.picture);
    };
    return Compared{lights.size(), off_between(displayed(shown), displayed(exact), 1.0),
                    off_between(displayed(even), displayed(odd), 0.5)};
}

Json picture_json(const Off& off) { return {{"mean", off.mean}, {"p99", off.hundredth}, {"p99.9", off.thousandth}}; }

Result<int> run_pictures(const PicturesBench& options) {
    TRY(session, open_session(options.context));
    Json rows = Json::array();
    bool within = true;
    for (const std::string& name : options.scenes) {
        TRY(scene, load_scene_sized(name, options.size));
        if (scene->sky.kind == SkyKind::kPoints) {
            fmt::print("{:<28} left out: stars drawn as points are no rays of single pixels\n", scene->name);
            continue;
        }
        TRY(compared, compare(*session, *scene, options));
        const Off &picture = compared->picture, &reference = compared->reference;
        fmt::print(
            "{:<28} off by {:.2f} of 255 on average, 99 % within {:.0f}, 99.9 % within {:.0f}{}; the reference's own "
            "{:.2f}, "
            "{:.1f}, {:.1f} ({} pixels)\n",
            scene->name, picture.mean, picture.hundredth, picture.thousandth, compared->within() ? "" : " (too much)",
            reference.mean, reference.hundredth, reference.thousandth, compared->pixels);
        std::fflush(stdout);
        rows.push_back({{"scene", scene->name},
                        {"size", options.size},
                        {"pixels", compared->pixels},
                        {"samples", options.samples},
                        {"renderer", session->renderer->info().renderer},
                        {"difference", picture_json(picture)},
                        {"reference", picture_json(reference)},
                        {"within", compared->within()}});
        within = within && compared->within();
    }
    TRY(written, write_json(options.json, rows));
    return within ? 0 : 1;
}

}  // namespace

void add_bench_pictures(Command& bench) {
    auto [command, options] =
        add_command<PicturesBench>(bench, "pictures",
                                   "Displayed pictures against the reference with many rays a pixel; "
                                   "status 1 if one is off by more than 2 of 255 on "
                                   "average, or by more than 24 in a thousandth of its pixels",
                                   run_pictures);
    command.add_option("scenes", &options.scenes, "Scenes to compare").required();
    size_option(command, options);
    context_option(command, options.context);
    number_option(command, "--pixels", options.pixels, 1, 100000000, "Pixels to compare, chosen at random");
    number_option(command, "--samples", options.samples, 2, 256, "Rays along a side of a pixel, an even number");
    number_option(command, "--seconds", options.seconds, 1, 1000000,
                  "Time for a scene, after which fewer pixels are compared");
    json_option(command, options);
}

}  // namespace nullscope::cli
