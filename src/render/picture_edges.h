// Pixels of a picture that differ much from a neighbour, and are worth more rays (shaders/stage/edges.frag). They are found while the picture
// is drawn, from below: rows are compared when the row above is there too, and drawn again when the row above has been compared. So a picture
// drawn in pieces is the same as one drawn at once.
#pragma once
#include <array>
#include <vector>

#include "gl/gl.h"
#include "shaderlib/passes.h"

namespace nullscope {

// A side of the rays of a pixel: where light differs a little, and much; where something thinner than a pixel may lie between rays that went
// different ways.
inline constexpr std::array<int, 3> kRefined = {2, 4, 6};
using BlockLists = std::array<gl::PointList, kRefined.size()>;

class PictureEdges {
public:
    // Of pictures that these passes draw to a target; frees what they do not need.
    void resize(const std::vector<Pass>& passes, const gl::Target& picture);

    // Before the picture is drawn: nothing is marked.
    void begin();

    // The rows [first, last) of the picture are there; those before are too. Compares with the program of stage kEdges, which must find the
    // picture bound. Cost: two fetches a pixel, and the driver is waited for.
    void compare(const gl::Program& program, const gl::VertexArray& empty, int first, int last);

    // Rows that may then be drawn again, and the blocks in them (points of the picture's programs) that hold something marked, by what
    // their pixels need (kRefined).
    int first() const { return first_; }
    int last() const { return last_; }
    const BlockLists& blocks() const { return blocks_; }

    // How many of the last picture's pixels are marked.
    long long count() const { return count_; }

private:
    void list_blocks();

    gl::Marks marks_;
    std::vector<unsigned char> seen_;
    unsigned first_number_ = 0;
    int first_ = 0, last_ = 0;
    long long count_ = 0;
    BlockLists blocks_;
};

}  // namespace nullscope
