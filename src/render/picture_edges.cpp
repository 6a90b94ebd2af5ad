#include "render/picture_edges.h"

#include <algorithm>

#include "render/ray_patches.h"

namespace nullscope {
namespace {

constexpr int kBlock = 4;  // px, as software drivers shade them

// Of rows up to `row`, those whose neighbours above are there, in whole blocks.
int rows_before(int row, int height) { return row == height ? height : std::max(row - 1, 0) / kBlock * kBlock; }

}  // namespace

void PictureEdges::resize(const std::vector<Pass>& passes, const gl::Target& picture) {
    if (!refines(passes)) {
        *this = PictureEdges();
        return;
    }
    if (marks_.width == picture.width && marks_.height == picture.height && marks_.of == picture.framebuffer.id())
        return;
    marks_ = gl::make_marks(picture);
    seen_.assign(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), 0);
}

void PictureEdges::begin() {
    gl::clear_marks(marks_);
    count_ = 0;
}

void PictureEdges::compare(const gl::Program& program, const gl::VertexArray& empty, int first, int last) {
    const int height = marks_.height;
    const int from = first == 0 ? 0 : rows_before(first, height), to = rows_before(last, height);
    if (to > from) {
        unsigned char* rows = seen_.data() + static_cast<std::size_t>(from) * static_cast<std::size_t>(marks_.width);
        gl::mark_rows(program, empty, marks_, from, to, rows);
        count_ += std::count_if(rows, rows + static_cast<std::ptrdiff_t>(to - from) * marks_.width,
                                [](unsigned char mark) { return mark > 0; });
    }
    first_ = first == 0 ? 0 : rows_before(from, height);
    last_ = rows_before(to, height);
    list_patches();
}

// A pixel gets what the neediest of its block needs: an edge goes on beside it.
void PictureEdges::list_patches() {
    for (std::vector<float>& list : patches_) list.clear();
    for (int y = first_; y < last_; y += kBlock)
        for (int x = 0; x < marks_.width; x += kBlock) {
            const int right = std::min(x + kBlock, marks_.width), top = std::min(y + kBlock, last_);
            const int most = mark_within(x, y, right, top);
            if (most == 0) continue;
            const auto kind = static_cast<std::size_t>((most - 1) / 85);  // marks are thirds of 255
            const int side = patch_pixels(kRefined[kind]);
            for (int up = y; up < top; up += side)
                for (int along = x; along < right; along += side)
                    if (mark_within(along, up, std::min(along + side, right), std::min(up + side, top)) > 0) {
                        patches_[kind].push_back(static_cast<float>(along));
                        patches_[kind].push_back(static_cast<float>(up));
                    }
        }
}

int PictureEdges::mark_within(int left, int low, int right, int top) const {
    int most = 0;
    for (int y = low; y < top; ++y) {
        const unsigned char* row = seen_.data() + static_cast<std::ptrdiff_t>(y) * marks_.width;
        most = std::max<int>(most, *std::max_element(row + left, row + right));
    }
    return most;
}

}  // namespace nullscope
