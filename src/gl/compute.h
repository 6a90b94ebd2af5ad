// Compute shaders, of OpenGL 4.3 and up: what a driver with less cannot do is asked for nowhere else.
#pragma once
#include <optional>
#include <string>

#include "gl/gl.h"

namespace nullscope::gl {

// Has the current context compute shaders?
bool computes();

// Do groups that return at once cost little? llvmpipe runs all of a text for them.
bool skips_groups();

// What a framebuffer draws to. Nothing: the window, or what no shader stores to.
struct StoredImage {
    unsigned texture = 0;
    Format format = Format::kRgba8;
    int width = 0, height = 0;
};
std::optional<StoredImage> stored_image(unsigned framebuffer);

// How a program stores a picture: in this format, in the place of what is there or added to it.
struct Stored {
    Format format = Format::kRgba32F;
    bool adds = false;
    auto operator<=>(const Stored&) const = default;  // NOLINT(modernize-use-nullptr): no pointer
};
inline bool adds(const Layer& layer) { return layer.share < 1.0 && !layer.replaces; }

// A program; where the driver refuses it one without a name, and a line that says what it refuses.
struct ComputeProgram {
    Program program;
    std::string refusal;
};
// text: without #version. PICTURE_FORMAT and PICTURE_ADDS stand for how it stores a picture, GROUP_WAITS for what lets the threads of a block of
// 2 x 2 see what the others have stored, GROUP_TOGETHER for whether all of a group must come to it.
ComputeProgram make_compute_program(const std::string& text, Stored stored);

// Tiles of a picture, found by one compute shader and drawn by the next, a group each: software drivers run all of a text for groups that return
// at once too. Column and row are below 65536.
class TileList {
public:
    // Of a picture's tiles, `across` in a row, in the rows from `first` up to but not including `last`, those that `program` lists
    // (shaders/stage/tile_list.comp).
    void find(const Program& program, int across, int first, int last);
    // Groups of a program for them.
    void dispatch(const Program& program) const;

private:
    Buffer buffer_;
    int room_ = 0;
};

// Of the picture the rows from first (counted from the bottom) up to but not including last, in groups of `side` x `side` pixels, a
// thread each (shaders/shared/thread.glsl). layer: marks are not looked at. What is drawn or read after it sees it.
void compute_rows(const Program& program, const StoredImage& to, int side, int first, int last,
                  const Layer& layer = {});
// The same, of listed tiles alone.
void compute_tiles(const Program& program, const StoredImage& to, const TileList& tiles, int first, int last,
                   const Layer& layer = {});
// Patches of rays in an image of their own (render/ray_patches.h), in its rows up to but not including last.
void compute_patches(const Program& program, const StoredImage& to, const VertexList& patches, int side, int last);
// The same of images of numbers, all colours of a target, which the program numbers by their bindings.
void compute_rows(const Program& program, const Target& to, int side, int first, int last);

}  // namespace nullscope::gl
