// How a picture is drawn, whatever becomes of it.
#pragma once
#include <fmt/format.h>

#include <cstdio>
#include <functional>
#include <optional>
#include <string>

#include "base/progress.h"
#include "image/sample.h"

namespace nullscope::cli {

// Who is told of long work and of what people should know; without another: the terminal.
struct Listener {
    BeginProgress progress = progress_on_terminal;
    std::function<void(const std::string& line)> note = [](const std::string& line) {
        fmt::print(stderr, "{}\n", line);
    };
};

struct DrawOptions {
    std::optional<int> samples;  // reference: a side of a pixel; else kSamples
    std::optional<int> largest_texture;
    bool raydata = false, layers = false;
    bool stokes = false;  // where light is polarised, of pictures that are not drawn in bands
    bool bands = false;   // of matter that is seen at several frequencies, each
    std::string st_map;   // sky or plate: instead of colours
    Sample sample = Sample::kLight;
    bool in_bands = false;   // linear light of large pictures is drawn in bands
    bool in_flight = false;  // bytes are read while the next picture is drawn, where nothing else needs them before
    Listener listener;
};
inline constexpr int kSamples = 3;

}  // namespace nullscope::cli
