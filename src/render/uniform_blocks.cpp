#include "render/uniform_blocks.h"

#include <array>

#include "render/body_numbers.h"
#include "scene/bodies.h"
#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

constexpr unsigned kFrameBinding = 0, kObjectBinding = 1;
constexpr int kSkyFetches = 24;  // a pixel; beyond it light bent by a hole is blurred along its arcs
constexpr std::size_t kMostObjectVectors = 5 * kMostBodies + 3 * kMostSpots;

float* put(const FrameVector& v, float* to) {
    for (const double value : {v.x, v.y, v.z, v.w}) *to++ = static_cast<float>(value);
    return to;
}

}  // namespace

UniformBlocks::UniformBlocks()
    : frame_(gl::make_uniform_buffer(sizeof(float) * 4 * kFrameVectors)),
      objects_(gl::make_uniform_buffer(sizeof(float) * 4 * kMostObjectVectors)) {}

void UniformBlocks::upload(const FrameTables& tables, const TextureFacts& facts) {
    if (effects_ != tables.effects()) {
        effects_ = tables.effects();
        members_ = block_members(*effects_);
    }
    tables_ = &tables, facts_ = facts;
    samples_.clear();
    pixel_ = frame_numbers(tables.plan(), tables.path(), facts, tables.ball_paths());
    upload_pixel(false);
    std::array<float, 4 * kMostObjectVectors> objects{};
    float* next = objects.data();
    for (const FrameVector& v :
         object_numbers(tables.plan(), tables.path().family(), tables.ball_paths(), tables.clearances()))
        next = put(v, next);
    gl::upload_uniforms(objects_, objects.data(), sizeof(objects));
}

void UniformBlocks::upload_pixel(bool filtered) {
    put_samples(pixel_, 1, 0, 1, filtered ? kSkyFetches : 1);
    upload_frame(pixel_);
}

void UniformBlocks::upload_samples(int samples, int first, int count) {
    auto found = samples_.find(samples);
    if (found == samples_.end())
        found = samples_
                    .emplace(samples,
                             sample_numbers(tables_->plan(), tables_->path(), facts_, tables_->ball_paths(), samples))
                    .first;
    put_samples(found->second, samples, first, count, kSkyFetches);
    upload_frame(found->second);
}

void UniformBlocks::upload_frame(const FrameData& frame) {
    const FrameVectors numbers = vectors_of(frame);
    std::array<float, 4 * kFrameVectors> block{};
    float* next = block.data();
    for (const int member : members_) next = put(numbers[static_cast<std::size_t>(member)], next);
    gl::upload_uniforms(frame_, block.data(), sizeof(block));
}

void UniformBlocks::name(const gl::Program& program) {
    gl::bind_uniform_block(program, "FrameBlock", kFrameBinding);
    gl::bind_uniform_block(program, "ObjectBlock", kObjectBinding);
}

void UniformBlocks::bind() const {
    gl::bind_uniforms(frame_, kFrameBinding);
    gl::bind_uniforms(objects_, kObjectBinding);
}

}  // namespace nullscope
