#include "render/picture_edges.h"

#include <algorithm>

namespace nullscope {
namespace {

// Of rows up to `row`, those in whole blocks that end before it; all of them where the picture ends.
int blocks_before(int row, int height) {
    return row == height ? height : std::max(row - 1, 0) / kBlockSide * kBlockSide;
}

}  // namespace

void PictureEdges::resize(const std::vector<Pass>& passes, const gl::Target& picture) {
    if (!refines(passes)) {
        *this = PictureEdges();
        return;
    }
    first_number_ = std::ranges::any_of(passes, is_whole, &Pass::stage) ? kFirstPictureTile : 0;
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
    const int from = first == 0 ? 0 : blocks_before(first, height), to = blocks_before(last, height);
    if (to > from) {
        unsigned char* rows = seen_.data() + static_cast<std::size_t>(from) * static_cast<std::size_t>(marks_.width);
        gl::mark_rows(program, empty, marks_, from, to, rows);
        count_ += std::count_if(rows, rows + static_cast<std::ptrdiff_t>(to - from) * marks_.width,
                                [](unsigned char mark) { return mark > 0; });
    }
    first_ = first == 0 ? 0 : blocks_before(from, height);
    last_ = blocks_before(to, height);
    list_blocks();
}

void PictureEdges::list_blocks() {
    const int across = (marks_.width + kTileSide - 1) / kTileSide * (kTileSide / kBlockSide);
    std::array<std::vector<unsigned>, kRefined.size()> numbers;
    std::vector<unsigned char> most(static_cast<std::size_t>(across));
    for (int row = first_ / kBlockSide; row * kBlockSide < last_; ++row) {
        std::fill(most.begin(), most.end(), 0);
        for (int y = std::max(row * kBlockSide, first_); y < std::min((row + 1) * kBlockSide, last_); ++y) {
            const unsigned char* line =
                seen_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(marks_.width);
            for (int x = 0; x < marks_.width; ++x) {
                unsigned char& block = most[static_cast<std::size_t>(x / kBlockSide)];
                block = std::max(block, line[x]);
            }
        }
        for (int column = 0; column < across; ++column)
            if (const unsigned char block = most[static_cast<std::size_t>(column)]; block > 0)
                numbers[static_cast<std::size_t>((block - 1) / 85)].push_back(
                    first_number_ + static_cast<unsigned>(row * across + column));  // marks are thirds of 255
    }
    for (std::size_t i = 0; i < numbers.size(); ++i)
        blocks_[i] = numbers[i].empty() ? gl::PointList() : gl::make_point_list(numbers[i]);
}

}  // namespace nullscope
