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
// Columns and rows (from below) of patches (render/ray_patches.h), in turn, as vertices have them.
using PatchLists = std::array<std::vector<float>, kRefined.size()>;

class PictureEdges {
public:
    // Of pictures that these passes draw to a target; frees what they do not need.
    void resize(const std::vector<Pass>& passes, const gl::Target& picture);

    // Before the picture is drawn: nothing is marked.
    void begin();

    // The rows [first, last) of the picture are there; those before are too. Compares with the program of stage kEdges, which must find the
    // picture bound. Cost: two fetches a pixel, and the driver is waited for.
    void compare(const gl::Program& program, const gl::VertexArray& empty, int first, int last);

    // Patches with marked pixels in the rows that may then be drawn again, by what these need (kRefined).
    const PatchLists& patches() const { return patches_; }

    // How many of the last picture's pixels are marked.
    long long count() const { return count_; }

private:
    void list_patches();
    int mark_within(int left, int low, int right, int top) const;  // the largest

    gl::Marks marks_;
    std::vector<unsigned char> seen_;
    int first_ = 0, last_ = 0;  // rows that may be drawn again
    long long count_ = 0;
    PatchLists patches_;
};

}  // namespace nullscope
