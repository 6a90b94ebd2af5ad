// nullscope compare: how far two pictures, or the ray data of two frames, are from each other.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "cli/command.h"
#include "command/exact_trace.h"
#include "compare/heat_map.h"
#include "compare/image_metrics.h"
#include "compare/ray_channels.h"
#include "compare/ray_metrics.h"
#include "image/image_file.h"
#include "scenefile/scene_file.h"

namespace nullscope::cli {
namespace {

struct CompareOptions {
    std::string a, b, heat_map, scene;
};

constexpr double kPictureThreshold = 2.0 / 255;  // two codes of an 8-bit picture: what rounding twice may differ by
constexpr HeatScale kPictureScale{1e-4, 1};

bool is_exr(const std::string& name) { return name.ends_with(".exr"); }

// Ray data if the file is an EXR that has it.
Result<std::optional<RayFrame>> load_rays(const std::string& name) {
    if (!is_exr(name)) return std::optional<RayFrame>();
    TRY(file, load_exr(name));
    if (!file->channels.contains("fate")) return std::optional<RayFrame>();
    auto frame = ray_frame_from(*file);
    if (!frame) return Error{frame.error().kind, fmt::format("{}: {}", name, frame.error().message())};
    return std::optional<RayFrame>(std::move(*frame));
}

Status save_heat_map(const CompareOptions& options, const Image<float>& values, HeatScale scale) {
    if (options.heat_map.empty()) return Done{};
    return save_png(options.heat_map, heat_map(values, scale));
}

void print_spread(const char* name, const Spread& spread, const char* unit) {
    if (spread.count == 0) return;
    fmt::print("{:<15} max {:<11.4g} 99.9 % {:<11.4g} median {:<11.4g} {}, {} pixels\n", name, spread.max, spread.p999,
               spread.median, unit, spread.count);
}

Status compare_rays(const CompareOptions& options, const RayFrame& a, const RayFrame& b) {
    if (a.width != b.width || a.height != b.height)
        return bad_input(fmt::format("sizes differ: {} is {}x{}, {} is {}x{}", options.a, a.width, a.height, options.b,
                                     b.width, b.height));
    std::optional<Scene> scene;
    if (!options.scene.empty()) {
        TRY(loaded, load_scene(options.scene));
        scene = std::move(*loaded);
        scene->camera.width = a.width;
        scene->camera.height = a.height;
    }
    const double estimate = scene ? 0 : std::max(estimated_pixel_angle(b), kFloatDirection_rad);
    const RayMeasures m =
        scene ? measure_ray_frames(a, b, scene->camera, exact_trace(*scene), kDisplaceAbove_px, kFloatDirection_rad)
              : measure_ray_frames(
                    a, b, [&](int, int) { return estimate; }, Vec3{});
    if (!scene)
        fmt::print(
            "pixel angle assumed {:.4g} rad, the median over the sky of {}; --scene SCENE gives the exact angle and "
            "closer "
            "bounds\n",
            estimate, options.b);
    if (const double angle = scene ? smallest_pixel_angle(scene->camera) : estimate; angle <= kFloatDirection_rad)
        fmt::print(
            "pixels are narrower than {:.2g} rad, to which files hold a direction: that is taken for a pixel along the "
            "ring\n",
            kFloatDirection_rad);
    print_spread("forward error", m.forward_rad, "rad");
    print_spread("screen error", m.sky_px, "px");
    print_spread("place on disc", m.place_px, "px");
    print_spread("swept angle", m.angle_px, "px");
    print_spread("g", m.g_px, "px");
    fmt::print("{:<15} {} of {} pixels (all, also at edges)\n", "fate differs", m.fate_errors, m.pixels.size());
    fmt::print("{:<15} {} pixels of {}\n", "not finite", m.not_finite, options.a);
    Image<float> values(m.width, m.height, 1);
    std::ranges::transform(m.pixels, values.data.begin(), &PixelErrors::worst_px);
    return save_heat_map(options, values, kPixelHeat);
}

Status compare_pictures(const CompareOptions& options) {
    TRY(a, load_image(options.a));
    TRY(b, load_image(options.b));
    const bool linear = is_exr(options.a) && is_exr(options.b);
    if (!linear) *a = display_values(*a), *b = display_values(*b);
    const auto m = measure_images(*a, *b, kPictureThreshold);
    if (!m) return bad_input(fmt::format("{}, {}: {}", options.a, options.b, m.error().message()));
    fmt::print("values          {}\n", linear ? "linear light" : "display-encoded, 0 to 1");
    fmt::print("difference      max {:.4g}  99.9 % {:.4g}  median {:.4g} (largest of a pixel's colours)\n", m->max,
               m->p999, m->median);
    fmt::print("mean            {:.4g}\n", m->mean);
    fmt::print("PSNR            {:.2f} dB\n", m->psnr_db);
    fmt::print("above {:.4f}    {:.4f} % of {} pixels\n", kPictureThreshold, 100 * m->fraction_above,
               m->difference.data.size());
    return save_heat_map(options, m->difference, kPictureScale);
}

Status run_compare(const CompareOptions& options) {
    if (!options.heat_map.empty() && !options.heat_map.ends_with(".png"))
        return bad_input(fmt::format("--heatmap {}: unknown kind of file", options.heat_map), "names that end in .png");
    TRY(a, load_rays(options.a));
    TRY(b, load_rays(options.b));
    if (!a->has_value() && !b->has_value() && !options.scene.empty())
        return bad_input(fmt::format("--scene {}: these are pictures, without ray data", options.scene),
                         "two .exr of capture --raydata, or no --scene");
    if (a->has_value() != b->has_value())
        return bad_input(
            fmt::format("{} has ray data and {} has none (no channel \"fate\"); make it with: nullscope "
                        "capture SCENE --raydata -o FILE.exr",
                        a->has_value() ? options.a : options.b, a->has_value() ? options.b : options.a));
    return a->has_value() ? compare_rays(options, **a, **b) : compare_pictures(options);
}

}  // namespace

void add_compare(Command& parent) {
    auto [command, options] = add_command<CompareOptions>(
        parent, "compare", "Compare two pictures, or the ray data of two frames; B is taken as exact", run_compare);
    required_option(command, "a", options.a,
                    "An image that scenes read too; or an EXR with ray data (nullscope capture --raydata)");
    required_option(command, "b", options.b, "The exact picture or ray data, in the same kind of file");
    command.add_option("--heatmap", &options.heat_map,
                       "PNG to write: the difference at each pixel as a colour, with a legend");
    command.add_option("--scene", &options.scene,
                       "For ray data: the scene of both, whose camera gives the angle of a pixel; errors next to the "
                       "photon ring become exact");
}

}  // namespace nullscope::cli
