// nullscope bench arithmetic: how many operations a second the driver's fragment and compute shaders do at most, for what a scene's rays cost beside
// it. Chains of multiplications and additions of numbers in registers: nothing is fetched, nothing branches.
#include <fmt/format.h>

#include <functional>
#include <string>

#include "base/progress.h"
#include "bench/bench.h"
#include "command/json.h"
#include "command/stage_choice.h"
#include "gl/compute.h"

namespace nullscope::cli {
namespace {

constexpr int kRounds = 64, kLines = 8;         // of the loop, and of its body
constexpr int kChains = 4;                      // of four numbers each, so that no operation waits for the one before
constexpr double kOperationsALine = 2.0 * 4.0;  // a multiplication and an addition of four numbers
constexpr int kGroupSide = 8;                   // of threads, px

constexpr char kVertex[] = R"(#version 330 core
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
)";

// The compiler knows neither the number of rounds nor the factor; numbers stay between 0 and 2.
std::string worked_text() {
    std::string body;
    for (int line = 0; line < kLines; ++line)
        for (int chain = 0; chain < kChains; ++chain)
            body += fmt::format("        c{0} = c{0} * factor + step;\n", chain);
    std::string text = R"(uniform int rounds;
uniform int thousandths;
vec4 worked(vec2 place) {
    vec4 factor = vec4(float(thousandths) * 1.0e-3), step = vec4(1.0) - factor;
    vec4 c0 = fract(1.0e-3 * place.xyxy), c1 = 1.0 - c0, c2 = c0.yzwx, c3 = c1.zwxy;
    for (int i = 0; i < rounds; ++i) {
)";
    return text + body + "    }\n    return 0.25 * (c0 + c1 + c2 + c3);\n}\n";
}

std::string fragment_text() {
    return "#version 330 core\n" + worked_text() +
           "out vec4 colour;\nvoid main() { colour = worked(gl_FragCoord.xy); }\n";
}

std::string compute_text() {
    return worked_text() + fmt::format(R"(layout(local_size_x = {0}, local_size_y = {0}) in;
layout(binding = 0, PICTURE_FORMAT) uniform image2D picture_image;
void main() {{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(picture_image)))) imageStore(picture_image, pixel, worked(vec2(pixel) + 0.5));
}}
)",
                                       kGroupSide);
}

// Median time of a draw, and what it comes to.
Json row_of_stage(const Bench& bench, const std::string& stage, int frames, const std::function<void()>& draw) {
    draw();  // compiles
    Samples samples;
    Progress progress("arithmetic, " + stage, frames);
    for (int i = 0; i < frames; ++i, progress.advance()) time_one(samples, draw);
    const double gpu_ms = median(samples.gpu_ms),
                 pixels = static_cast<double>(bench.target.width) * bench.target.height,
                 operations = kOperationsALine * kChains * kLines * kRounds * pixels / (1e-3 * gpu_ms);
    fmt::print("{:<9} {:.4g} x 10^12 operations a second ({:.3f} ms)\n", stage, 1e-12 * operations, gpu_ms);
    return Json{{"stage", stage},
                {"gpu_ms", gpu_ms},
                {"operations_a_second", operations},
                {"renderer", bench.driver()},
                {"context", bench.session.context->kind()}};
}

Status run_arithmetic(const BenchOptions& options) {
    TRY(bench, open_bench(options));
    const auto asked = [](const gl::Program& program) {
        gl::set_integer(program, "rounds", kRounds);
        gl::set_integer(program, "thousandths", 999);
    };
    const gl::Target& target = bench->target;
    const gl::Program fragment = gl::make_program(kVertex, fragment_text());
    asked(fragment);
    const gl::VertexArray empty = gl::make_vertex_array();
    Json rows = Json::array();
    rows.push_back(row_of_stage(*bench, kFragmentStage, options.frames, [&] {
        gl::draw_fullscreen(fragment, empty, target.framebuffer.id(), target.width, target.height);
    }));
    const auto stored = gl::computes() ? gl::stored_image(target.framebuffer.id()) : std::nullopt;
    if (stored) {
        const gl::ComputeProgram compute = gl::make_compute_program(compute_text(), {.format = stored->format});
        if (!compute.refusal.empty()) return failed(compute.refusal);
        asked(compute.program);
        rows.push_back(row_of_stage(*bench, kComputeStage, options.frames,
                                    [&] { gl::compute_rows(compute.program, *stored, kGroupSide, 0, target.height); }));
    } else {
        fmt::print("compute   needs OpenGL 4.3\n");
    }
    return write_json(options.json, rows);
}

}  // namespace

void add_bench_arithmetic(Command& bench) {
    auto [command, options] = add_command<BenchOptions>(
        bench, "arithmetic",
        "Operations a second that fragment and compute shaders do at most, a multiplication and an addition being two",
        run_arithmetic);
    draw_options(command, options, 9);
    json_option(command, options);
}

}  // namespace nullscope::cli
