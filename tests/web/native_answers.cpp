// What this machine's own code answers, for the page's tests.
//
//   native_answers texts COUNT TEXELS [FILE...]    random scenes, then the files: a JSON line each with "text" and what core.wasm is asked
//   native_answers rays LINE PIXELS WIDTH HEIGHT ROW_STEP
//                                                  how far the rays in the file PIXELS (RayPixel, every ROW_STEP-th row) are from the
//                                                  reference's; LINE: a file with the scene's line
#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <random>
#include <string>

#include "base/atomic_file.h"
#include "compare/ray_metrics.h"
#include "core/exports.h"
#include "reference/frame_tracer.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_writer.h"
#include "support/random_scene.h"

extern "C" {
bool open_scene(const char* text, std::size_t size, const char* label, std::size_t label_size);
bool scene_as_line();
bool plan();
bool numbers(int texels_each);
}

namespace nullscope::web {
namespace {

// As answers_of() of tests/web/test_answers.py asks core.wasm.
void print_answers(const std::string& text, int texels) {
    const auto said = [](bool good) { return fmt::format("[{}, {}]", good, in_json(answer())); };
    const bool opened = ::open_scene(text.data(), text.size(), "scene.toml", 10);
    std::vector<std::string> answers{said(opened)};
    if (opened)
        for (const auto& ask : {scene_as_line, plan}) answers.push_back(said(ask()));
    if (opened) answers.push_back(said(numbers(texels)));
    std::string list;
    for (const std::string& one : answers) list += (list.empty() ? "" : ", ") + one;
    fmt::print("{{\"text\": {}, \"answers\": [{}]}}\n", in_json(text), list);
}

int print_texts(int count, int texels, int files, char** names) {
    std::mt19937 random(26);
    const auto infos = shipped_scenes();
    for (int i = 0; i < count; ++i) {  // those of one spacetime after each other: its table is made once
        const SceneInfo& info = infos[static_cast<std::size_t>(i) * infos.size() / static_cast<std::size_t>(count)];
        const auto scene = load_scene(info.path.string());
        if (!scene) return 1;
        print_answers(scene_file_text(test::changed_scene(*scene, random), info.path.parent_path()), texels);
    }
    for (int i = 0; i < files; ++i) {
        const auto text = read_text(names[i]);
        if (text) print_answers(*text, texels);
    }
    return 0;
}

int judge_rays(const char* line_file, const char* pixel_file, int width, int height, int row_step) {
    const auto line = read_text(line_file), bytes = read_text(pixel_file);
    if (!line || !bytes) return 1;
    auto scene = scene_of_line(*line);
    if (!scene) return fmt::print(stderr, "{}\n", scene.error().message()), 1;
    scene->camera.width = width, scene->camera.height = height;
    const auto tracer = reference::FrameTracer::make(*scene);
    if (!tracer) return fmt::print(stderr, "{}\n", tracer.error().message()), 1;
    RayFrame frame{width, height, std::vector<RayPixel>(bytes->size() / sizeof(RayPixel)), row_step};
    if (frame.pixels.size() != static_cast<std::size_t>(width * ((height - 1) / row_step + 1))) return 1;
    std::memcpy(frame.pixels.data(), bytes->data(), bytes->size());
    const RayMeasures m = measure_rays(
        frame, scene->camera,
        [&](const std::vector<std::array<double, 2>>& positions) {
            std::vector<RayPixel> rays;
            for (const auto& at : positions) rays.push_back(tracer->pixel(at[0], at[1], false));
            return rays;
        },
        row_step);
    fmt::print(
        R"({{"pixels": {}, "pixel_rad": {:.6g}, "sky_px": {:.6g}, "place_px": {:.6g}, "fate_errors": {}, "forgiven": {}, "not_finite": {}}})"
        "\n",
        m.pixels.size(), smallest_pixel_angle(scene->camera), m.sky_px.max, m.place_px.max, m.fate_errors, m.forgiven,
        m.not_finite);
    return 0;
}

int number(const char* text) {
    int value = 0;
    std::from_chars(text, text + std::strlen(text), value);
    return value;
}

int run(int count, char** words) {
    if (count >= 4 && words[1] == std::string_view("texts"))
        return print_texts(number(words[2]), number(words[3]), count - 4, words + 4);
    if (count == 7 && words[1] == std::string_view("rays"))
        return judge_rays(words[2], words[3], number(words[4]), number(words[5]), number(words[6]));
    return 2;
}

}  // namespace
}  // namespace nullscope::web

int main(int count, char** words) { return nullscope::web::run(count, words); }
