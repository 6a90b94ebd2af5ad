// What tests on a GPU share: a renderer on each kind of context, the reference as exact trace, witnesses of a pixel.
#pragma once
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "command/session.h"
#include "compare/ray_metrics.h"
#include "compare/remembered_trace.h"
#include "reference/reference.h"
#include "render/renderer.h"
#include "scenefile/scene_text.h"
#include "support/costly.h"
#include "support/depth.h"
#include "support/reference_memory.h"
#include "support/report.h"

namespace nullscope::test {

using GpuSession = cli::Session;

// Of a picture's red light.
inline double sum_of(const Image<float>& picture) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) sum += picture.at(x, y)[0];
    return sum;
}

// The prepared scene's picture of this size, drawn in pieces: from below, the rows between each of these and the next. Rows from the top.
inline Image<unsigned char> drawn_in_pieces(Renderer& renderer, int width, int height, const std::vector<int>& ends) {
    const gl::Target target = gl::make_target(width, height, gl::Format::kRgba8);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        renderer.draw_rows(target.framebuffer.id(), width, height, Output::kDisplay, ends[i], ends[i + 1]);
    Image<unsigned char> rgba(width, height, 4), picture(width, height, 3);
    gl::read_rgba8(target, rgba.data.data());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) std::copy_n(&rgba.at(x, height - 1 - y)[0], 3, &picture.at(x, y)[0]);
    return picture;
}

// A camera near and far, from any side, turned by at most these angles.
inline Scene seen_from_elsewhere(Scene scene, std::mt19937& random, double yaw, double pitch) {
    const auto among = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    scene.camera.r *= std::exp(among(-1.2, 0.4));
    scene.camera.theta = among(0.05, 3.09);
    scene.camera.phi = among(-3.14, 3.14);
    scene.camera.yaw = yaw * among(-1.0, 1.0);
    scene.camera.pitch = pitch * among(-1.0, 1.0);
    scene.time += among(-30.0, 30.0);
    return scene;
}

inline constexpr const char* kContextKinds[] = {"egl", "osmesa"};

// Nothing where there is no such context; one line says so.
inline std::optional<GpuSession> open_gpu(const std::string& kind) {
    auto session = cli::open_session(kind);
    if (session) return std::move(*session);
    fmt::print("skipped: {}\n", session.error().message());
    return {};
}

// Runs the test on every kind of context that there is, one after the other; fails if there is none.
inline void on_all_contexts(const std::function<void(GpuSession&)>& test, int most = 2) {
    int opened = 0;
    for (const std::string kind : kContextKinds) {
        if (opened == most) break;
        CAPTURE(kind);
        auto session = open_gpu(kind);
        if (!session) continue;
        ++opened;
        test(*session);
    }
    CHECK_MESSAGE(opened > 0, "neither EGL nor OSMesa gives a context");
}

// The same; on the first kind alone at quick depth and, at depth all, in three of four places (another four with
// another NULLSCOPE_RUN). That all draw the same bits has a test of its own (test_repeat.cpp).
inline void on_every_context(const std::function<void(GpuSession&)>& test, const char* file = __builtin_FILE(),
                             int line = __builtin_LINE()) {
    const std::string_view name = std::string_view(file).substr(std::string_view(file).rfind('/') + 1);
    const std::string place = fmt::format("{}{}{}", environment_word("NULLSCOPE_RUN"), name, line);
    const bool second = depth(file) == Depth::kEverything || (depth(file) == Depth::kAll && fnv1a(place) / 8 % 4 == 0);
    on_all_contexts(test, second ? 2 : 1);
}

// On the first kind at any depth, where the second can say nothing new: both are one rasteriser, and the reference, or
// another picture by the same driver, is all that a frame is held against.
inline void on_one_context(const std::function<void(GpuSession&)>& test) { on_all_contexts(test, 1); }

inline RayFrame gl_ray_data(GpuSession& session, const Scene& scene, int row_step = 1) {
    const Status ready = session.renderer->prepare(scene);
    const std::string reason = ready ? "" : ready.error().message();
    REQUIRE_MESSAGE(ready, reason);
    return session.renderer->ray_data(row_step);
}

inline Image<float> picture_of(GpuSession& session, const Scene& scene) {
    REQUIRE(session.renderer->prepare(scene));
    return session.renderer->picture();
}

// A mark of the bits of all that is known of a frame's rays (FNV-1a).
inline std::uint64_t mark_of(const RayFrame& frame) {
    std::uint64_t mark = 14695981039346656037ull;
    for (const RayPixel& p : frame.pixels) {
        const double numbers[] = {
            static_cast<double>(p.fate), p.sky.x, p.sky.y, p.sky.z, p.g, p.delay, p.angle, static_cast<double>(p.order),
            static_cast<double>(p.hit),  p.u,     p.v,     p.w};
        for (const double number : numbers) mark = (mark ^ std::bit_cast<std::uint64_t>(number)) * 1099511628211ull;
    }
    return mark;
}

// What was measured on one context need not be again on another that draws the same bits.
class MeasuredOnce {
public:
    // Whether a frame of this name had the same bits before.
    bool known(const std::string& name, const RayFrame& frame) {
        const std::uint64_t mark = mark_of(frame);
        const auto [before, first] = marks_.try_emplace(name, mark);
        const bool same = !first && before->second == mark;
        count_ += same;
        return same;
    }
    int count() const { return count_; }

private:
    std::map<std::string, std::uint64_t> marks_;  // of the first context
    int count_ = 0;
};

// What is asked of the reference, word for word, and what is in the files that it reads.
inline std::string question_of(const char* what, const Scene& scene) {
    std::string question = std::string(what) + "\n";
    for (const SceneLine& line : scene_lines(scene))
        question += line.name + " = " + (line.file.empty() ? line.value : contents_of(line.file)) + "\n";
    return question;
}

inline ExactTrace reference_trace(const Scene& scene) {
    return [scene, question = question_of("trace_pixels", scene)](const std::vector<std::array<double, 2>>& positions) {
        const std::string places(reinterpret_cast<const char*>(positions.data()),
                                 positions.size() * sizeof(positions[0]));
        return ReferenceMemory::of_this_run().answer<RayPixel>(question + places, [&] {
            auto pixels = reference::trace_pixels(scene, positions);
            if (!pixels) {
                std::fprintf(stderr, "reference_trace: %s\n", pixels.error().message().c_str());
                std::abort();
            }
            return std::move(*pixels);
        });
    };
}

// Every pixel's.
inline RayFrame exact_frame(const CameraSpec& camera, const ExactTrace& trace) {
    std::vector<std::array<double, 2>> middles;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) middles.push_back({x + 0.5, y + 0.5});
    RayFrame frame;
    frame.width = camera.width, frame.height = camera.height;
    frame.pixels = trace(middles);
    return frame;
}
inline RayFrame reference_frame(const Scene& scene) { return exact_frame(scene.camera, reference_trace(scene)); }

inline Witnesses witnesses_of(const Scene& scene, const CoreInput& input, const RayFrame& gl, int x, int y) {
    const double right = x + 0.5 - 0.5 * scene.camera.width, up = 0.5 * scene.camera.height - (y + 0.5);
    return {reference_trace(scene)({{x + 0.5, y + 0.5}})[0], trace_core64(input, right, up),
            trace_core32(input, right, up), gl.at(x, y)};
}

inline std::string spread_text(const Spread& s) {
    return fmt::format("{:.2e} / {:.2e} / {:.2e}", s.max, s.p999, s.median);
}

}  // namespace nullscope::test
