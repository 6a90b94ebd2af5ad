// The frame's numbers as flat inputs of the fragment shader. Software drivers check and load every number of a uniform block for every few
// pixels; inputs are loaded once for a block of them. The numbers are the same, and so is the picture.
#pragma once
#include <string>
#include <vector>

#include "shaderlib/shader_source.h"

namespace nullscope {

// Inputs of four numbers each, at most: OpenGL 3.3 grants 15, llvmpipe 32, and some stages have one of their own.
inline constexpr int kMostFlatInputs = 24;

// Members of the block that a text reads as frame.NAME: those that it reads most often first, else in its order.
std::vector<std::string> frame_members_read(const std::string& text);

// The same program, in which the vertex shader hands on up to `most` members of the block `frame`; of a fragment shader without it the program
// itself.
ShaderSource with_flat_frame(const ShaderSource& source, int most);

// A compute shader that reads up to `most` members of the block once, when it begins.
std::string with_frame_read_once(const std::string& text, int most);

}  // namespace nullscope
