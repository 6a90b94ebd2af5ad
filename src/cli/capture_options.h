// What nullscope capture was asked for.
#pragma once
#include <optional>
#include <string>

namespace nullscope::cli {

struct CaptureOptions {
    std::string scene, beside, output = "frame.png", size, context = "auto", renderer = "gl", method = "auto", frames;
    std::optional<int> samples;  // reference: a side of a pixel; else kSamples
    std::optional<double> time;
    double time_step = 0;
    std::optional<double> max_error;
    std::optional<int> largest_texture;
    bool raydata = false, dump_shader = false, resume = false;
};
inline constexpr int kSamples = 3;

}  // namespace nullscope::cli
