// nullscope figure: the slides' figures, Luminet's isoradials and photon rings, drawn from the reference tracer as SVG.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "cli/photon_ring_figure.h"
#include "cli/table_file.h"
#include "command/svg.h"
#include "reference/isoradial.h"
#include "reference/reference.h"
#include "scenefile/scene_file.h"

namespace nullscope::cli {
namespace {

constexpr double kCriticalQ = 0.38490017945975050967;       // 2/(3 sqrt 3)
constexpr double kEdge = 7.0;                               // half a panel, r_s
constexpr double kPanel = 360, kUnit = kPanel / 2 / kEdge;  // px; of r_s

using Points = std::vector<std::array<double, 2>>;

// The part of a light ray with r <= 1.5 kEdge: from radius r0 with q and direction s, until it ends.
Points path(double q, double r0, int s) {
    constexpr double kStep = 0.01;  // rad
    Points points{{r0, 0}};
    Scene scene;
    for (int i = 1; i < 4000; ++i) {
        RayQuery query;
        query.orbit = ReducedRay{q, 1 / r0, s};
        query.at_angle = i * kStep;
        const auto ray = reference::trace_ray(scene, query);
        if (!ray || !std::isfinite(ray->at) || ray->at <= 1 / (1.5 * kEdge)) break;
        points.push_back({std::cos(i * kStep) / ray->at, std::sin(i * kStep) / ray->at});
    }
    return points;
}

std::string line(Points points) {  // NOLINT(performance-unnecessary-value-param): scaled in place
    for (auto& [x, y] : points) x *= kUnit, y *= -kUnit;
    return svg_curve("polyline", points, 1.6, "#c2410c");
}

// A panel with the horizon (black), the photon sphere (dashed) and what is drawn into it.
std::string panel(int column, int row, const std::string& title, const std::string& inside) {
    return fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\">\n",
                       column * (kPanel + 10), row * (kPanel + 10), kPanel, kPanel, -kPanel / 2, -kPanel / 2, kPanel,
                       kPanel) +
           fmt::format("<rect x=\"{0}\" y=\"{0}\" width=\"{1}\" height=\"{1}\" fill=\"#ffffff\" stroke=\"#d4d4d8\"/>\n",
                       -kPanel / 2, kPanel) +
           fmt::format(
               "<circle r=\"{:.2f}\" fill=\"#18181b\"/><circle r=\"{:.2f}\" fill=\"none\" stroke=\"#a1a1aa\" "
               "stroke-dasharray=\"4 3\"/>\n",
               kUnit, 1.5 * kUnit) +
           inside + svg_text(-kPanel / 2 + 10, -kPanel / 2 + 22, title, 14) + "</svg>\n";
}

std::string document(int columns, int rows, const std::string& panels) {
    return svg_document(columns * (kPanel + 10) - 10, rows * (kPanel + 10) - 10, panels);
}

// "Bending of light rays for Q = 1.85, 6.75, 9.85 and 14.3, where q = q_crit (1 - exp(-Q))": each ray is drawn from its turning
// point both ways, the incoming side horizontal.
std::string bending() {
    std::string panels;
    int i = 0;
    for (const double big_q : {1.85, 6.75, 9.85, 14.3}) {
        const double q = kCriticalQ * (1 - std::exp(-big_q));
        const double start = 1.5 * kEdge;
        RayQuery query;
        query.orbit = ReducedRay{q, 1 / start, 1};
        const auto ray = reference::trace_ray({}, query);
        const double bent = ray ? ray->angle : 0.0;
        panels += panel(i % 2, i / 2, fmt::format("Q = {:g}: swept {:.1f} degrees", big_q, bent * 180 / M_PI),
                        line(path(q, start, 1)));
        ++i;
    }
    return document(2, 2, panels);
}

// "Types of rays, depending on r <> 3M, q <> q_crit and u^r <> 0".
std::string ray_types() {
    struct Kind {
        const char* title;
        double r, k;
        int s;
    };
    const std::vector<Kind> kinds = {{"r &gt; 3M, q &lt; q_crit, inward: turns, escapes", 5, 0.9, 1},
                                     {"r &gt; 3M, q &lt; q_crit, outward: escapes", 5, 0.9, -1},
                                     {"r &gt; 3M, q &gt; q_crit, inward: captured", 5, 1.1, 1},
                                     {"r &gt; 3M, q &gt; q_crit, outward: escapes", 5, 1.1, -1},
                                     {"r &lt; 3M, q &lt; q_crit, inward: captured", 1.2, 0.95, 1},
                                     {"r &lt; 3M, q &lt; q_crit, outward: turns, captured", 1.2, 0.95, -1},
                                     {"r &lt; 3M, q &gt; q_crit, inward: captured", 1.2, 1.1, 1},
                                     {"r &lt; 3M, q &gt; q_crit, outward: escapes", 1.2, 1.02, -1}};
    std::string panels;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const Kind& kind = kinds[i];
        const std::string start = fmt::format("<circle cx=\"{:.1f}\" r=\"4\" fill=\"#1d4ed8\"/>\n", kind.r * kUnit);
        panels += panel(static_cast<int>(i % 4), static_cast<int>(i / 4), kind.title,
                        line(path(kind.k * kCriticalQ, kind.r, kind.s)) + start);
    }
    return document(4, 2, panels);
}

// Isoradials of a scene's camera: the direct images of rings of 3, 5, 10 and 15 r_s (6, 10, 20 and 30 M, as in
// Luminet's figure of 1979) and the next ones, by the reference. Errors: as reference::isoradial.
Result<std::string> isoradials(const std::string& name) {
    constexpr int kPoints = 720;
    TRY(scene, load_scene(name));
    const CameraSpec& camera = scene->camera;
    std::string out(kSvgWhite);
    for (const int image : {1, 2})
        for (const double r : {3.0, 5.0, 10.0, 15.0}) {
            TRY(curve, reference::isoradial(*scene, r, image, kPoints));
            if (curve->empty()) continue;
            out += svg_curve("polygon", *curve, image == 1 ? 1.8 : 1.0, image == 1 ? "#c2410c" : "#1d4ed8");
            const auto& label = (*curve)[3 * curve->size() / 4];
            if (image == 1) out += svg_text(label[0] + 4, label[1] - 4, fmt::format("{:g} M", 2 * r), 13);
        }
    out += svg_text(16, 28,
                    fmt::format("Isoradials seen from {:.0f} degrees: direct images (red), second images (blue)",
                                camera.theta * 180 / M_PI),
                    16);
    return svg_document(camera.width, camera.height, out);
}

struct FigureOptions {
    std::string name, output, scene;
    int rings = 8;
    std::vector<int> angles;
    GivenWords given;
};

// file and, beside it, the table as CSV.
Result<int> photon_ring(const FigureOptions& options, const std::filesystem::path& file) {
    const std::string name = options.scene.empty() ? "photon-ring" : options.scene;
    TRY(scene, load_scene(name));
    TRY(figure, photon_ring_figure(*scene, options.rings, options.angles));
    const auto table = std::filesystem::path(file).replace_extension(".csv");
    if (table == file)
        return bad_input(fmt::format("-o {}: the table beside it has that name", file.string()), "a name in .svg");
    TRY(written, write_table(table.string(), figure->csv, file.string(), figure->svg,
                             {*scene, name, options.given.words(), "reference tracer", figure->columns}));
    fmt::print("{}\n{}, {}\n", figure->table, file.string(), table.string());
    return 0;
}

Result<int> run_figure(const FigureOptions& options) {
    const std::string file = options.output.empty() ? options.name + ".svg" : options.output;
    if (options.name == "photon-ring") return photon_ring(options, file);
    for (const char* option : {"--rings", "--angles"})
        if (options.given.has(option))
            return bad_input(fmt::format("{}: {} has no subrings", option, options.name), "with photon-ring");
    if (options.name != "isoradials" && !options.scene.empty())
        return bad_input(fmt::format("--scene {}: {} is of a Schwarzschild hole, whose camera is its own",
                                     options.scene, options.name),
                         "with isoradials and photon-ring");
    TRY(svg, options.name == "bending"     ? bending()
             : options.name == "ray-types" ? ray_types()
                                           : isoradials(options.scene.empty() ? "luminet" : options.scene));
    TRY(written, write_text_atomically(file, *svg));
    fmt::print("{}\n", file);
    return 0;
}

}  // namespace

void add_figure(Command& parent) {
    auto [command, options] = add_command<FigureOptions>(
        parent, "figure",
        "Draw a figure as SVG: rays near the critical one, types of rays, isoradials (images of rings of the disc), or "
        "the widths of a photon ring's subrings",
        run_figure);
    options.given.of(command);
    command.add_option("name", &options.name, "bending, ray-types, isoradials or photon-ring")
        .required()
        .one_of({"bending", "ray-types", "isoradials", "photon-ring"});
    command.add_option("scene,--scene", &options.scene,
                       "For isoradials and photon-ring: the scene whose camera is used (default luminet, photon-ring)");
    number_option(command, "--rings", options.rings, 2, 16, "For photon-ring: number of subrings");
    command.add_option("--angles", &options.angles,
                       "For photon-ring: positions along the ring, degrees clockwise from the left, as the unrotated "
                       "camera sees it (default: 90; about a rotating hole 30, 90, ..., 330)");
    command.add_option("-o,--output", &options.output, "File to write (default NAME.svg)");
}

}  // namespace nullscope::cli
