// The uniform blocks of a frame's programs: the frame's numbers (shaders/shared/frame_block.glsl), and those of its bodies and hot spots
// (shaders/shared/objects.glsl).
#pragma once
#include <optional>
#include <vector>

#include "gl/gl.h"
#include "render/frame_numbers.h"
#include "render/frame_tables.h"

namespace nullscope {

class UniformBlocks {
public:
    UniformBlocks();

    void upload(const FrameTables& tables, const TextureFacts& facts);
    // Of the last upload: for one ray of every pixel (put_sample), or for the pixel itself again.
    void upload_sample(int column, int row);
    void upload_pixel() { upload_frame(pixel_); }

    static void name(const gl::Program& program);  // where its blocks are
    void bind() const;

private:
    void upload_frame(const FrameData& frame);

    gl::Buffer frame_, objects_;
    FrameData pixel_, sample_;  // sample_: where a pixel has several rays
    int samples_ = 1;
    std::optional<EffectSet> effects_;
    std::vector<int> members_;  // of the frame's block with these effects
};

}  // namespace nullscope
