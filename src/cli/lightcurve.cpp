// nullscope lightcurve: the light of a scene, or of a part of its picture, against time.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "base/assets.h"
#include "base/atomic_file.h"
#include "base/progress.h"
#include "cli/arguments.h"
#include "cli/command.h"
#include "cli/session.h"
#include "reference/reference.h"
#include "scene/moving.h"
#include "scene/scene_file.h"
#include "sky/sky.h"
#include "spacetime/circular_orbit.h"
#include "spacetime/registry.h"

namespace nullscope::cli {
namespace {

struct Options {
    std::string scene, output = "lightcurve", size, context = "auto", renderer = "gl";
    std::vector<int> region;  // x, y of the first pixel, x, y behind the last
    std::optional<double> from, to;
    std::optional<int> samples;  // reference alone
    int steps = 120;
};

struct Sample {
    double time;
    std::array<double, 4> flux;  // luminance, red, green, blue, over the solid angle: 1 is a steradian of white
};

// Sum over the region of light times the solid angle of each pixel of the pinhole.
std::array<double, 4> flux_of(const Image<float>& picture, const CameraSpec& camera, const std::vector<int>& region) {
    const double pixel = camera.plane_width / camera.width / camera.focal_distance;
    std::array<double, 4> sum{};
    for (int y = region[1]; y < region[3]; ++y)
        for (int x = region[0]; x < region[2]; ++x) {
            const double u = (x + 0.5 - 0.5 * camera.width) * pixel, v = (y + 0.5 - 0.5 * camera.height) * pixel;
            const double angle = pixel * pixel / std::pow(1 + u * u + v * v, 1.5);
            const float* p = picture.at(x, y);
            for (int c = 0; c < 3; ++c) sum[static_cast<std::size_t>(c) + 1] += angle * p[c];
        }
    sum[0] = 0.2126 * sum[1] + 0.7152 * sum[2] + 0.0722 * sum[3];  // Rec. 709
    return sum;
}

// One turn of the spots, one pulse of the sphere, or 100 r_s/c.
double period_of(const Scene& scene) {
    const auto spacetime = make_spacetime(scene.spacetime.metric, scene.spacetime.parameters);
    if (scene.spot && spacetime)
        if (const auto orbit = circular_orbit(**spacetime, scene.spot->r)) return 2 * M_PI / orbit->omega;
    return scene.sphere && scene.sphere->swing > 0 ? scene.sphere->period : 100.0;
}

std::string csv_of(const Scene& scene, const std::vector<Sample>& curve) {
    std::string text = fmt::format(
        "# {}: light against time. time: r_s/c; flux: luminance times solid angle (sr), white is "
        "1\ntime,flux,red,green,blue\n",
        scene.name);
    for (const Sample& s : curve)
        text +=
            fmt::format("{:.17g},{:.9g},{:.9g},{:.9g},{:.9g}\n", s.time, s.flux[0], s.flux[1], s.flux[2], s.flux[3]);
    return text;
}

std::string svg_of(const Scene& scene, const std::vector<Sample>& curve) {
    constexpr double kWidth = 760, kHeight = 340, kLeft = 84, kBottom = 52, kTop = 40, kRight = 20;
    std::string title;  // no markup of a scene's
    for (const char c : scene.name) title += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    const auto [least, most] = std::minmax_element(
        curve.begin(), curve.end(), [](const Sample& a, const Sample& b) { return a.flux[0] < b.flux[0]; });
    const double low = std::min(least->flux[0], 0.0), high = most->flux[0] > low ? most->flux[0] : low + 1;
    const auto x_of = [&](double t) {
        return kLeft + (t - curve.front().time) / (curve.back().time - curve.front().time) * (kWidth - kLeft - kRight);
    };
    const auto y_of = [&](double f) {
        return kHeight - kBottom - (f - low) / (high - low) * (kHeight - kBottom - kTop);
    };
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" font-size=\"13\" fill=\"#18181b\">\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n<text x=\"{2}\" y=\"24\" font-size=\"15\">{3}</text>\n",
        kWidth, kHeight, kLeft, title);
    for (int i = 0; i <= 4; ++i) {
        const double t = curve.front().time + i * (curve.back().time - curve.front().time) / 4,
                     f = low + i * (high - low) / 4;
        svg += fmt::format(
            "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\" stroke=\"#e4e4e7\"/><text x=\"{0:.1f}\" "
            "y=\"{3:.1f}\" text-anchor=\"middle\">{4:.4g}</text>\n",
            x_of(t), y_of(low), y_of(high), kHeight - kBottom + 20, t);
        svg += fmt::format(
            "<line x1=\"{0:.1f}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#e4e4e7\"/><text x=\"{3:.1f}\" "
            "y=\"{4:.1f}\" text-anchor=\"end\">{5:.3g}</text>\n",
            kLeft, kWidth - kRight, y_of(f), kLeft - 8, y_of(f) + 4, f);
    }
    svg += "<polyline fill=\"none\" stroke=\"#c2410c\" stroke-width=\"1.8\" points=\"";
    for (const Sample& s : curve) svg += fmt::format("{:.2f},{:.2f} ", x_of(s.time), y_of(s.flux[0]));
    return svg + fmt::format("\"/>\n<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">time, r_s/c</text>\n</svg>\n",
                             0.5 * (kLeft + kWidth - kRight), kHeight - 10);
}

// Draws a scene at one time after another.
class Painter {
public:
    static Result<Painter> make(const Options& options, const Scene& scene) {
        Painter painter;
        if (options.renderer == "gl") {
            auto session = open_session(options.context);
            if (!session) return session.error();
            painter.session_ = std::move(*session);
            return painter;
        }
        if (scene.disc && scene.disc->look.texture == TextureKind::kImage &&
            effect_set(required_effects(scene)).contains(Effect::kDiscImage))
            return bad_input(
                "--renderer reference draws light curves of scenes without images; allowed: gl, or another "
                "disc.texture");
        constexpr int kSkyFace = 256;
        auto sky = build_sky(scene.sky, assets_directory(), kSkyFace);
        if (!sky) return sky.error();
        painter.sky_ = std::move(*sky);
        painter.samples_ = options.samples.value_or(1);
        return painter;
    }
    Result<Image<float>> operator()(const Scene& scene) {
        if (sky_) return reference::render_frame(scene, *sky_, {}, samples_, {}, nullptr, {});
        if (Status ready = session_->renderer->prepare(scene); !ready) return ready.error();
        return session_->renderer->picture();
    }

private:
    std::optional<Session> session_;
    std::optional<SkyCube> sky_;
    int samples_ = 1;
};

Result<Scene> scene_for(const Options& options) {
    auto scene = load_scene(options.scene);
    if (!scene || options.size.empty()) return scene;
    const auto size = parse_size(options.size);
    if (!size) return size.error();
    scene->camera.width = size->width, scene->camera.height = size->height;
    return scene;
}

Result<std::vector<int>> region_of(const Options& options, const CameraSpec& camera) {
    if (options.region.empty()) return std::vector<int>{0, 0, camera.width, camera.height};
    const auto& r = options.region;
    if (r[0] >= 0 && r[1] >= 0 && r[0] < r[2] && r[1] < r[3] && r[2] <= camera.width && r[3] <= camera.height) return r;
    return bad_input(
        fmt::format("--region {} {} {} {} is not a part of the picture; allowed: X0 < X1 <= {}, Y0 < Y1 <= {}", r[0],
                    r[1], r[2], r[3], camera.width, camera.height));
}

int run(const Options& options) {
    auto scene = scene_for(options);
    if (!scene) return report(scene.error());
    if (moving_parts(*scene).empty())
        return report(
            bad_input(fmt::format("{}: nothing in it changes with time; allowed: a scene with disc.flow, [spot], "
                                  "sphere.swing, ball.motion or t in surface.shape",
                                  options.scene)));
    if (options.samples && options.renderer != "reference")
        return report(bad_input("--samples: the shader takes one ray a pixel; allowed: with --renderer reference"));
    const auto region = region_of(options, scene->camera);
    if (!region) return report(region.error());
    const double from = options.from.value_or(scene->time), to = options.to.value_or(from + period_of(*scene));
    if (!(to > from)) return report(bad_input(fmt::format("--to {} is not after --from {}", to, from)));
    auto painter = Painter::make(options, *scene);
    if (!painter) return report(painter.error());
    std::vector<Sample> curve;
    {
        Progress progress("light curve", options.steps);
        for (int i = 0; i < options.steps; ++i) {
            scene->time = from + i * (to - from) / (options.steps - 1);
            const auto picture = (*painter)(*scene);
            if (!picture) return report(picture.error());
            curve.push_back({scene->time, flux_of(*picture, scene->camera, *region)});
            progress.advance();
        }
    }
    if (Status written = write_text_atomically(options.output + ".csv", csv_of(*scene, curve)); !written)
        return report(written.error());
    if (Status written = write_text_atomically(options.output + ".svg", svg_of(*scene, curve)); !written)
        return report(written.error());
    const auto peak = std::max_element(curve.begin(), curve.end(),
                                       [](const Sample& a, const Sample& b) { return a.flux[0] < b.flux[0]; });
    fmt::print("{0}.csv, {0}.svg: {1} times from {2:g} to {3:g} r_s/c; brightest at {4:g}, {5:.4g}\n", options.output,
               options.steps, from, to, peak->time, peak->flux[0]);
    return 0;
}

}  // namespace

void add_lightcurve(Command& parent) {
    auto options = std::make_shared<Options>();
    Command& command = parent.add_command("lightcurve", "Light of a scene against time: FILE.csv and FILE.svg");
    command
        .add_option("scene", &options->scene,
                    "Scene file, or the name of one that ships, in which something changes with time")
        .required();
    command.add_option("-o,--output", &options->output, "Files to write, without .csv and .svg").show_default();
    command.add_option("--from", &options->from, "First time, r_s/c (default: the scene's)").in_range(-1e9, 1e9);
    command.add_option("--to", &options->to, "Last time (default: one turn of the spots or one pulse later, else 100)")
        .in_range(-1e9, 1e9);
    command.add_option("--steps", &options->steps, "Number of times").in_range(2, 100000).show_default();
    command.add_option("--size", &options->size, "Picture size in pixels, WIDTHxHEIGHT (default: the scene's)");
    command
        .add_option("--region", &options->region,
                    "X0 Y0 X1 Y1: the part of the picture that counts, px from its top left corner, X1 and Y1 behind "
                    "the last (default: all of it)")
        .count(4);
    command.add_option("--renderer", &options->renderer, "gl: the shader; reference: the double-precision tracer, slow")
        .one_of({"gl", "reference"})
        .show_default();
    command.add_option("--samples", &options->samples, "reference: rays per pixel along each side (default 1)")
        .in_range(1, 16);
    context_option(command, options->context);
    command.on_run([options] { return run(*options); });
}

}  // namespace nullscope::cli
