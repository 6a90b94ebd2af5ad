// What a picture's light does in lens and eye: a pyramid of halves, down and up again (shaders/stage/bloom_*.frag), and from its last
// level the mean luminance, which adapts in time.
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "gl/gl.h"

namespace nullscope {

class Bloom {
public:
    // Levels of half the size each until both sides are at most 8 px. Memory: two thirds of the picture's. What was
    // metered stays: exposure goes on from there when a coarse picture follows a whole one.
    void resize(int width, int height);
    void clear() { *this = {}; }
    std::size_t bytes() const;
    static std::size_t bytes(int width, int height);  // of a picture of this size

    // All of them draw with `source_texture` at unit source_unit, `bloom_texture` at bloom_unit.
    void draw_down(const gl::Program& down, const gl::VertexArray& empty, const gl::Texture& picture, int source_unit);
    void draw_up(const gl::Program& up, const gl::VertexArray& empty, int source_unit,
                 int bloom_unit);  // after draw_down
    // share: how far the metered luminance moves to the picture's, 1 at first and where nothing adapts.
    void draw_meter(const gl::Program& meter, const gl::VertexArray& empty, int source_unit,
                    double share);  // after draw_down
    // The sum of all levels; of a picture with one level that level.
    const gl::Texture& halo() const { return (up_.empty() ? down_ : up_).front().colours.front(); }
    const gl::Texture& metered() const { return meter_->colours.front(); }

private:
    static std::vector<std::pair<int, int>> levels(int width, int height);

    int width_ = 0, height_ = 0;
    std::vector<gl::Target> down_, up_;  // up_[i] has the size of down_[i]
    std::optional<gl::Target> meter_;
};

}  // namespace nullscope
