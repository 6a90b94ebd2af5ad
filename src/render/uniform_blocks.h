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
    // Of the last upload: for one ray of every pixel (sample_numbers), or for the pixel itself again.
    void upload_sample(const FrameTables& tables, int column, int row);
    void upload_pixel(const FrameTables& tables);

    static void name(const gl::Program& program);  // where its blocks are
    void bind() const;

private:
    void upload_frame(const FrameTables& tables, const FrameData& frame);

    gl::Buffer frame_, objects_;
    TextureFacts facts_;
    std::optional<EffectSet> effects_;
    std::vector<int> members_;  // of the frame's block with these effects
};

}  // namespace nullscope
