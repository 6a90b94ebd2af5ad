// nullscope figure: the slides' figures and Luminet's isoradials, drawn from the reference tracer as SVG.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <vector>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "cli/isoradials.h"
#include "reference/reference.h"
#include "scene/scene_file.h"

namespace nullscope::cli {
namespace {

constexpr double kCriticalQ = 0.38490017945975050967;  // 2/(3 sqrt 3)
constexpr double kEdge = 7.0;                          // half a panel, r_s
constexpr double kPanel = 360;                         // px

struct Point {
    double x, y;
};

// The part of a light ray with r <= 1.5 kEdge: from radius r0 with q and direction s, until it ends.
std::vector<Point> path(double q, double r0, int s) {
    constexpr double kStep = 0.01;  // rad
    std::vector<Point> points{{r0, 0}};
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

std::string line(const std::vector<Point>& points, double turn, const char* colour) {
    std::string out = "<polyline fill=\"none\" stroke-width=\"1.6\" stroke=\"" + std::string(colour) + "\" points=\"";
    for (const Point& p : points) {
        const double x = std::cos(turn) * p.x - std::sin(turn) * p.y, y = std::sin(turn) * p.x + std::cos(turn) * p.y;
        out += fmt::format("{:.2f},{:.2f} ", x / kEdge * kPanel / 2, -y / kEdge * kPanel / 2);
    }
    return out + "\"/>\n";
}

// A panel with the horizon (black), the photon sphere (dashed) and what is drawn into it.
std::string panel(int column, int row, const std::string& title, const std::string& inside) {
    const double unit = kPanel / 2 / kEdge;
    return fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\">\n",
                       column * (kPanel + 10), row * (kPanel + 10), kPanel, kPanel, -kPanel / 2, -kPanel / 2, kPanel,
                       kPanel) +
           fmt::format("<rect x=\"{0}\" y=\"{0}\" width=\"{1}\" height=\"{1}\" fill=\"#ffffff\" stroke=\"#d4d4d8\"/>\n",
                       -kPanel / 2, kPanel) +
           fmt::format(
               "<circle r=\"{:.2f}\" fill=\"#18181b\"/><circle r=\"{:.2f}\" fill=\"none\" stroke=\"#a1a1aa\" "
               "stroke-dasharray=\"4 3\"/>\n",
               unit, 1.5 * unit) +
           inside +
           fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"14\" fill=\"#18181b\">{}</text>\n</svg>\n",
                       -kPanel / 2 + 10, -kPanel / 2 + 22, title);
}

std::string document(int columns, int rows, const std::string& panels) {
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
               "font-family=\"sans-serif\">\n",
               columns * (kPanel + 10) - 10, rows * (kPanel + 10) - 10) +
           panels + "</svg>\n";
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
                        line(path(q, start, 1), 0, "#c2410c"));
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
        const double unit = kPanel / 2 / kEdge;
        const std::string start = fmt::format("<circle cx=\"{:.1f}\" r=\"4\" fill=\"#1d4ed8\"/>\n", kind.r * unit);
        panels += panel(static_cast<int>(i % 4), static_cast<int>(i / 4), kind.title,
                        line(path(kind.k * kCriticalQ, kind.r, kind.s), 0, "#c2410c") + start);
    }
    return document(4, 2, panels);
}

Result<std::string> isoradials(const std::string& name) {
    const auto scene = load_scene(name);
    if (!scene) return scene.error();
    return isoradials_svg(*scene);
}

struct Options {
    std::string name, output, scene = "luminet";
};

int run(const Options& options) {
    const std::string file = options.output.empty() ? options.name + ".svg" : options.output;
    Result<std::string> svg = options.name == "bending"     ? bending()
                              : options.name == "ray-types" ? ray_types()
                                                            : isoradials(options.scene);
    if (!svg) return report(svg.error());
    if (Status written = write_text_atomically(file, *svg); !written) return report(written.error());
    fmt::print("{}\n", file);
    return 0;
}

}  // namespace

void add_figure(Command& parent) {
    auto options = std::make_shared<Options>();
    Command& command = parent.add_command(
        "figure",
        "Draw as SVG: light rays near the critical one, the types of rays, isoradials (images of rings of the disc)");
    command.add_option("name", &options->name, "bending, ray-types or isoradials")
        .required()
        .one_of({"bending", "ray-types", "isoradials"});
    command.add_option("--scene", &options->scene, "isoradials: scene whose camera looks").show_default();
    command.add_option("-o,--output", &options->output, "File to write (default NAME.svg)");
    command.on_run([options] { return run(*options); });
}

}  // namespace nullscope::cli
