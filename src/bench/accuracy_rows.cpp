#include "bench/accuracy_rows.h"

#include <algorithm>
#include <cmath>

#include "base/progress.h"
#include "base/text.h"
#include "command/exact_trace.h"
#include "compare/remembered_trace.h"

namespace nullscope::cli {
namespace {

constexpr int kErrorWidth = 384, kErrorHeight = 216;  // a 4K frame of 90 degrees, every tenth pixel each way
constexpr int kSpinErrorWidth = 160,
              kSpinErrorHeight = 90;      // every 24th: the reference takes steps about a rotating hole
constexpr double kRefineAbove_px = 5e-5;  // of this frame: 0.0005 px of the 4K frame
constexpr double kNear = 1.5;             // horizon radii: nearer cameras about a rotating hole are reported apart

// Core-seconds of a frame beyond which a part of its rows are drawn, in bands, spread over the picture. Each band costs some 0.05 ms besides
// its rays.
constexpr double kLongFrame_s = 0.12;
constexpr int kBand = 4, kSmallestPart = 16;

constexpr std::string_view kMethods =
    "strip strip:cubic table:32:hermite table:64:hermite table:128:hermite table:256:hermite "
    "table:32:cubic table:64:cubic table:128:cubic table:256:cubic "
    "table:64:bilinear table:128:bilinear table:256:bilinear table:512:bilinear table:1024:bilinear "
    "table:64:hardware table:128:hardware table:256:hardware table:512:hardware table:1024:hardware closed-form "
    "integrate:6:1 integrate:6:0.6 integrate:6:0.3 integrate:6:0.2 integrate:6:0.15 "
    "integrate:4:0.4 integrate:4:0.2 integrate:4:0.1 integrate:4:0.05 euler:100 euler:300 euler:1000 euler:3000 "
    "mino:6:1 mino:6:0.8 mino:6:0.6 mino:6:0.45 mino:6:0.3 mino:4:0.6 mino:4:0.3 mino:4:0.15 mino:4:0.075 "
    "kerr-schild:0.32 kerr-schild:0.16 kerr-schild:0.08 kerr-schild:0.04 kerr-schild:0.02 kerr-schild:0.01";

// Cameras far, in the middle, near, on the photon sphere, inside it, next to the horizon, and fast: each sees the whole
// sky, and then a disc that covers as much of it as a disc can. About a rotating hole, the sky alone, which all methods
// draw, of observers without angular momentum: far, middle, near, by the axis, at the photon orbits, in the ergosphere
// and next to the horizon.
std::vector<Scene> cameras(const SpacetimeSpec& spec, const Spacetime& spacetime) {
    struct Place {
        double r, theta, yaw, outward = 0, east = 0;  // the last two: velocity
    };
    const bool spins = !spacetime.planar_rays();
    const double horizon = spins ? *spacetime.horizon_radius() : 0.0;
    const std::vector<Place> still{{1000, 1.2, 0},          {1000, 1.2, 2},   {20, 1.2, 0},
                                   {20, 1.2, M_PI},         {3, 1.2, 0.7},    {1.5, 1.2, 1.2},
                                   {1.2, 1.2, 2.4},         {1.01, 1.2, 2.9}, {10, 1.2, 0.3, -0.5, 0.74},
                                   {10, 1.2, 1.0, 0.9, 0.3}};
    const std::vector<Place> spun{{1000, 1.2, 0}, {20, 1.2, 0},  {20, 1.2, M_PI},           {8, 1.5, 0},
                                  {4, 0.05, 0.3}, {2, 1.2, 0.7}, {1.3 * horizon, 1.4, 2.4}, {1.02 * horizon, 1.0, 2.4}};
    std::vector<Scene> list;
    for (const bool disc : {false, true})
        for (const Place& place : spins ? spun : still) {
            if (spins && disc) continue;
            Scene& scene = list.emplace_back();
            CameraSpec& camera = scene.camera;
            scene.spacetime = spec;
            scene.sky.kind = SkyKind::kBlack;
            if (disc) scene.disc = DiscSpec{};
            if (disc) scene.disc->inner = 1.5, scene.disc->outer = std::fmax(30, 3 * place.r);
            camera.observer = spins ? ObserverKind::kZamo : ObserverKind::kStatic;
            camera.r = place.r, camera.theta = place.theta, camera.yaw = place.yaw, camera.pitch = 0.1;
            camera.velocity = {place.outward, 0.0, place.east};
            camera.plane_width = 2.0;
            camera.width = spins ? kSpinErrorWidth : kErrorWidth;
            camera.height = spins ? kSpinErrorHeight : kErrorHeight;
        }
    return list;
}

void take_errors(const RayMeasures& measures, const ErrorView& view, AccuracyRow& row) {
    const auto to_4k = static_cast<float>(k4kWidth / view.scene.camera.width);
    for (const PixelErrors& pixel : measures.pixels) {
        if (pixel.hit) row.disc.push_back(pixel.place_px * to_4k);
        if (!pixel.escaped || view.scene.disc) continue;
        (view.near ? row.near : row.screen).push_back(pixel.sky_px * to_4k);
        row.forward.push_back(pixel.forward_rad);
    }
    (view.near ? row.near_fate_errors : row.fate_errors) += measures.fate_errors;
}

// What a method's table takes; of a prepared renderer.
void take_table(const Renderer& renderer, AccuracyRow& row) {
    const bool strip = row.method.kind == MethodKind::kStrip;
    if (!strip && row.method.kind != MethodKind::kTable) return;
    const auto& path = renderer.tables().path();
    row.build_ms = path.table_ms + (strip ? path.rows_ms : renderer.gpu_table_ms());
    for (const auto& line : renderer.textures())
        if (line.name == (strip ? "strip" : "deflection table")) row.bytes = line.bytes;
}

// Every part-th band of rows, spread about the middle; how many rows the frame has for each of them.
double rows_for_one(int part) {
    int bands = 0;
    for (int first = (part - 1) * kBand / 2; first + kBand <= kTimeHeight; first += part * kBand) ++bands;
    return static_cast<double>(kTimeHeight) / (bands * kBand);
}
void draw_part(const Bench& bench, Renderer& by, int part) {
    if (part == 1) return bench.draw(by);
    const auto rows = [&](int first, int last) {
        by.draw_rows(bench.target.framebuffer.id(), kTimeWidth, kTimeHeight, Output::kDisplay, first, last);
    };
    rows(0, 0);  // what a picture begins with
    for (int first = (part - 1) * kBand / 2; first + kBand <= kTimeHeight; first += part * kBand)
        rows(first, first + kBand);
}

}  // namespace

Result<std::vector<AccuracyRow>> accuracy_rows(const Spacetime& spacetime) {
    std::vector<AccuracyRow> rows;
    for (const std::string& text : split(kMethods, ' ')) {
        TRY(method, parse_method(text));
        if (!has_method(spacetime, *method)) continue;
        AccuracyRow& row = rows.emplace_back();
        row.name = text, row.method = *method;
    }
    std::stable_partition(rows.begin(), rows.end(), [](const AccuracyRow& row) { return row.is_default(); });
    return rows;
}

std::vector<ErrorView> error_views(const SpacetimeSpec& spec, const Spacetime& spacetime) {
    const double near_radius = spacetime.planar_rays() ? 0.0 : kNear * *spacetime.horizon_radius();
    std::vector<ErrorView> views;
    for (const Scene& scene : cameras(spec, spacetime))
        views.push_back({scene, remembered(exact_trace(scene), scene.camera.width, scene.camera.height),
                         scene.camera.r < near_radius});
    return views;
}

Status measure_errors(Renderer& renderer, const std::vector<ErrorView>& views, AccuracyRow& row,
                      const std::function<void()>& done) {
    renderer.set_method(row.method);
    for (const ErrorView& view : views) {
        TRY(ready, renderer.prepare(view.scene));
        const RayFrame frame = renderer.ray_data();
        for (const RayPixel& pixel : frame.pixels)
            row.steps += pixel.steps, row.most_steps = std::max(row.most_steps, pixel.steps);
        row.rays += static_cast<long long>(frame.pixels.size());
        take_errors(measure_rays(frame, view.scene.camera, view.exact, 1, kRefineAbove_px), view, row);
        done();
    }
    row.screen_px = spread_of(std::move(row.screen)), row.forward_rad = spread_of(std::move(row.forward)),
    row.disc_px = spread_of(std::move(row.disc)), row.near_px = spread_of(std::move(row.near));
    return Done{};
}

Status measure_cost(const Bench& bench, const Scene& scene, int frames, AccuracyRow& row) {
    Renderer& renderer = bench.renderer();
    renderer.set_method(row.method);
    TRY(ready, renderer.prepare(scene));
    take_table(renderer, row);
    const auto in_turn = [&](int part, Samples& method, Samples& floor) {
        time_one(method, [&] { draw_part(bench, renderer, part); });
        time_one(floor, [&] { draw_part(bench, *bench.other, part); });
    };
    Samples first, drawn, floor;
    draw_part(bench, renderer, kSmallestPart);  // compiles
    in_turn(kSmallestPart, first, floor);
    const double long_s = (first.core_s.back() - floor.core_s.back()) * rows_for_one(kSmallestPart);
    while (row.part < kSmallestPart && long_s > kLongFrame_s * row.part) row.part *= 2;
    draw_part(bench, renderer, row.part);
    floor = {};
    for (int frame = 0; frame < frames; ++frame) {
        in_turn(row.part, drawn, floor);
        if (row.part > 1) time_one(row.floor, [&] { bench.draw(*bench.other); });
    }
    row.cost = drawn;
    if (row.part == 1) row.floor = floor;
    const auto as_whole = [&](std::vector<double> Samples::*of) {
        const double times = rows_for_one(row.part), fixed = median(row.floor.*of) - times * median(floor.*of);
        for (double& time : row.cost.*of) time = fixed + times * time;
    };
    as_whole(&Samples::wall_ms), as_whole(&Samples::core_s), as_whole(&Samples::gpu_ms);
    return Done{};
}

Status measure_whole_frames(const Bench& bench, const Scene& scene, int frames, std::vector<AccuracyRow>& rows) {
    Renderer& renderer = bench.renderer();
    Progress progress("whole frames", static_cast<long long>(rows.size()) * frames);
    for (int frame = 0; frame < frames; ++frame)
        for (AccuracyRow& row : rows) {
            renderer.set_method(row.method);
            TRY(ready, renderer.prepare(scene));
            if (frame == 0) bench.draw(renderer);
            time_one(row.whole, [&] { bench.draw(renderer); });
            progress.advance();
        }
    return Done{};
}

}  // namespace nullscope::cli
