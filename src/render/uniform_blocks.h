// The uniform blocks of a frame's programs: the frame's numbers (shaders/shared/frame_block.glsl), and those of its bodies and hot spots
// (shaders/shared/objects.glsl).
#pragma once
#include <map>
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
    // Of the last upload, whose tables must still be there: for some of samples x samples rays of every pixel (put_samples), or for the pixel
    // itself again, whose footprint on the sky is filtered with one fetch or with several.
    void upload_samples(int samples, int first, int count);
    void upload_pixel(bool filtered);

    static void name(const gl::Program& program);  // where its blocks are
    void bind() const;

private:
    void upload_frame(const FrameData& frame);

    gl::Buffer frame_, objects_;
    const FrameTables* tables_ = nullptr;
    TextureFacts facts_;
    FrameData pixel_;
    std::map<int, FrameData> samples_;  // where a pixel has several rays, by how many along its side
    std::optional<EffectSet> effects_;
    std::vector<int> members_;  // of the frame's block with these effects
};

}  // namespace nullscope
