// Compute shaders, of OpenGL 4.3 and up: what a driver with less cannot do is asked for nowhere else.
#pragma once
#include <optional>
#include <string>

#include "gl/gl.h"

namespace nullscope::gl {

// Has the current context compute shaders?
bool computes();

// What a framebuffer draws to. Nothing: the window, or what no shader stores to.
struct StoredImage {
    unsigned texture = 0;
    Format format = Format::kRgba8;
    int width = 0, height = 0;
};
std::optional<StoredImage> stored_image(unsigned framebuffer);

// A program; where the driver refuses it one without a name, and its log, explained.
struct ComputeProgram {
    Program program;
    std::string refusal;
};
// text: without #version. PICTURE_FORMAT stands for the format of the image that it stores a picture to.
ComputeProgram make_compute_program(const std::string& text, Format stored);

// Of the picture the rows from first (counted from the bottom) up to but not including last, in groups of `side` x `side` pixels, a
// thread each (shaders/shared/thread.glsl). layer: marks are not looked at. What is drawn or read after it sees it.
void compute_rows(const Program& program, const StoredImage& to, int side, int first, int last,
                  const Layer& layer = {});
// The same of images of numbers, all colours of a target, which the program numbers by their bindings.
void compute_rows(const Program& program, const Target& to, int side, int first, int last);

}  // namespace nullscope::gl
