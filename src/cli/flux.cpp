// nullscope flux: the flux density of a scene's matter, and the density of matter at which it has a given one; the derivatives of its flux or of a disc's.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "cli/command.h"
#include "command/arguments.h"
#include "command/capture_picture.h"
#include "command/flux_derivatives.h"
#include "command/session.h"
#include "command/sky_light.h"
#include "plan/medium_model.h"
#include "scenefile/scene_edit.h"
#include "scenefile/scene_keys.h"
#include "scenefile/scene_writer.h"
#include "telescope/flux.h"

namespace nullscope::cli {
namespace {

constexpr double kLeastFlux = 1e-12, kMostFlux = 1e12;  // Jy

struct FluxOptions {
    std::vector<std::string> set;  // scenefile/scene_override.h
    std::string scene, output, size, renderer = "gl";
    ContextChoice context;
    std::optional<double> target;  // Jy
    std::optional<int> samples;    // reference alone
    double tolerance = 1e-4;       // relative to target
    std::string derivatives;       // keys, with commas between
    double error = 1e-3;           // of these, relative
};

// The flux at densities of the scene's matter; each picture's is reported on standard error.
class FluxOfDensity {
public:
    FluxOfDensity(PictureDrawer draw, Scene scene, FluxUnit unit)
        : draw_(std::move(draw)), scene_(std::move(scene)), unit_(unit) {}

    // Errors: the scene's rules out this density; a file, or drawing.
    Result<double> at(double density_scale) {
        scene_.medium->density_scale = density_scale;
        TRY(checked, savable(scene_));
        TRY(drawn, draw_(*checked));
        return flux_of(drawn->linear, unit_, {0, 0, drawn->linear.width, drawn->linear.height});
    }

private:
    PictureDrawer draw_;
    Scene scene_;
    FluxUnit unit_;
};

struct DensityFound {
    double scale, jansky;
    int pictures;
};

// The root of ln(flux/target) as a function of ln(density scale): a bracket in growing steps from the scene's own, then the Illinois method
// (Dowell and Jarratt 1971, BIT 11, 168). Where the flux is not monotonic (opaque matter), the crossing that this meets first. Cost: some
// 6 to 12 pictures.
class DensitySearch {
public:
    DensitySearch(FluxOfDensity& flux, const FluxOptions& options) : flux_(flux), options_(options) {}

    Result<DensityFound> from(double scale) {
        constexpr double kFirstStep = 1.0, kGrowth = 2.0;
        const KeyRange range = key_range("medium.density_scale");
        const double least = std::log(range.low), most = std::log(range.high);
        double here = std::log(scale), excess = excess_at(here), step = kFirstStep;
        while (!done_) {
            const double next = std::clamp(here + (excess < 0 ? step : -step), least, most);
            if (next == here) return out_of_reach(here, excess);
            const double there = excess_at(next);
            if (!done_ && (there < 0) != (excess < 0)) {
                refine(here, excess, next, there);
                break;
            }
            here = next, excess = there, step *= kGrowth;
        }
        if (failed_) return *failed_;
        if (!done_)
            return failed(fmt::format("--target {} Jy: the flux jumps past it near density_scale = {:g}, to {:.6g} Jy",
                                      *options_.target, found_.scale, found_.jansky));
        return found_;
    }

private:
    // 0 where the flux is the target's within the tolerance, or where a picture failed: either ends the search.
    double excess_at(double log_scale) {
        constexpr double kDark = -700;  // stands for ln 0
        const double scale = std::exp(log_scale);
        const auto flux = flux_.at(scale);
        if (!flux) return failed_ = flux.error(), done_ = true, 0.0;
        found_ = {scale, *flux, found_.pictures + 1};
        fmt::print(stderr, "density_scale = {:.6g}: {:.6g} Jy\n", scale, *flux);
        const double excess = *flux > 0 ? std::log(*flux / *options_.target) : kDark;
        done_ = std::abs(excess) <= options_.tolerance;
        return done_ ? 0.0 : excess;
    }

    // Regula falsi, where an end that stays counts half.
    void refine(double a, double excess_a, double b, double excess_b) {
        constexpr int kMost = 60;
        for (int i = 0; i < kMost && !done_; ++i) {
            const double at = (a * excess_b - b * excess_a) / (excess_b - excess_a), excess = excess_at(at);
            if ((excess < 0) == (excess_b < 0))
                excess_a *= 0.5;
            else
                a = b, excess_a = excess_b;
            b = at, excess_b = excess;
        }
    }

    Error out_of_reach(double log_scale, double excess) const {
        return bad_input(fmt::format("--target {} Jy: at density_scale = {:g} it is still {:.4g} Jy", *options_.target,
                                     std::exp(log_scale), found_.jansky),
                         excess < 0 ? "a lesser flux" : "a greater flux");
    }

    FluxOfDensity& flux_;
    const FluxOptions& options_;
    std::optional<Error> failed_;
    DensityFound found_{};
    bool done_ = false;
};

// The scene with its density, as a file where one is asked for.
Status tell_found(const FluxOptions& options, Scene scene, const DensityFound& found) {
    scene.medium->density_scale = found.scale;
    fmt::print("density_scale = {:.9g}\n{:.6g} Jy at {} GHz; {} pictures\n", found.scale, found.jansky,
               scene.medium->frequency_GHz, found.pictures);
    if (options.output.empty()) return Done{};
    const auto folder = std::filesystem::absolute(options.output).parent_path();
    TRY(written, write_text_atomically(options.output, scene_file_text(scene, folder)));
    fmt::print("{}\n", options.output);
    return Done{};
}

Status check(const FluxOptions& options, const Scene& scene) {
    TRY(alone, one_frequency(scene));
    if (!flux_unit(scene, scene.split || scene.camera.stereo != Stereo::kOff))
        return bad_input(fmt::format("{}: its picture has no flux in Jy{}", options.scene,
                                     scene.disc ? "; --derivatives KEY,... has a thermal disc's in luminance" : ""),
                         "a scene whose only light is matter's at one frequency ([medium] but no gas, sky.kind = "
                         "\"black\", no [disc], no bodies) about an [object] of known mass and distance");
    if (options.target && !has_share(scene, kDensityScale))
        return bad_input(
            fmt::format("{}: --target changes density_scale, which this [medium] does not have", options.scene),
            std::string(kinds_with(kDensityScale)));
    if (!options.output.empty() && !options.target) return bad_input("-o: the scene is as it was", "with --target");
    TRY(context, check_context(options.renderer, options.context));
    return check_samples_of_reference(options.renderer, options.samples.has_value());
}

Status run_derivatives(const FluxOptions& options, const Scene& scene) {
    if (options.target) return bad_input("--derivatives: not with --target", "one of them");
    if (!options.output.empty()) return bad_input("-o: the scene is as it was", "with --target");
    const auto table = flux_derivatives(scene, split(options.derivatives, ','), options.error);
    if (!table) {
        Error error = table.error();
        if (error.key.empty()) error.what = "--derivatives: " + error.what;
        return error;
    }
    for (const std::string& note : table->notes) fmt::print(stderr, "{}\n", note);
    fmt::print("{}", flux_csv(*table));
    return Done{};
}

Status run_flux(const FluxOptions& options) {
    TRY(scene, asked_scene(options));
    if (!options.derivatives.empty()) return run_derivatives(options, *scene);
    TRY(good, check(options, *scene));
    std::optional<Session> session;
    if (options.renderer == "gl") {
        TRY(opened, open_session(options.context));
        session = std::move(*opened);
    }
    DrawOptions each;
    each.samples = options.samples.value_or(1);
    TRY(drawer, picture_drawer(session ? &*session : nullptr, *scene, each));
    FluxOfDensity flux(std::move(*drawer), *scene, *flux_unit(*scene, false));
    if (!options.target) {
        TRY(jansky, flux.at(scene->medium->density_scale));
        fmt::print("{:.6g} Jy at {} GHz\n", *jansky, scene->medium->frequency_GHz);
        return Done{};
    }
    TRY(found, DensitySearch(flux, options).from(scene->medium->density_scale));
    return tell_found(options, std::move(*scene), *found);
}

}  // namespace

void add_flux(Command& parent) {
    auto [command, options] = add_command<FluxOptions>(
        parent, "flux",
        "Flux density (Jy) of a scene's matter; with --target, the density at which it has that one; with "
        "--derivatives, how that of matter or a disc changes",
        run_flux);
    required_option(command, "scene", options.scene,
                    "Scene file, or the name of a built-in scene, whose only light is matter's at one frequency, about "
                    "an object of known mass and distance; with --derivatives one with a thermal disc, or matter");
    set_option(command, options.set);
    number_option(command, "--target", options.target, kLeastFlux, kMostFlux,
                  "Flux density to reach, Jy, by medium.density_scale (of a simulation's dump: its unit of mass)");
    number_option(command, "--tolerance", options.tolerance, 1e-6, 0.1,
                  "Relative difference to --target that is enough");
    command.add_option(
        "--derivatives", &options.derivatives,
        "Flux of a thermal disc or of matter (luminance of linear light, summed over pixels) and its derivatives by "
        "KEY,KEY,... of spin, charge, camera.r, .theta, .phi, .yaw, .pitch, .roll, .fov, .velocity_r, "
        "..., disc.inner, .outer, .temperature, .powers, .opacity, .brightness, .tilt, .node, per 1, "
        "r_s, rad, c or K, as CSV; the images of rims move with them");
    number_option(command, "--error", options.error, 1e-5, 0.5,
                  "With --derivatives: relative error of flux and derivatives that is enough (default 1e-3)");
    command.add_option("-o,--output", &options.output, "With --target: scene file to write, with that density_scale");
    command.add_option("--size", &options.size, "Picture size in pixels, WIDTHxHEIGHT (default: the scene's)");
    renderer_option(command, options.renderer);
    number_option(command, "--samples", options.samples, 1, 16,
                  "For --renderer reference: N x N rays per pixel (default 1)");
    context_option(command, options.context);
}

}  // namespace nullscope::cli
