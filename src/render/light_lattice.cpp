#include "render/light_lattice.h"

#include <algorithm>

namespace nullscope {
namespace {

// Of the picture. Software drivers shade blocks of 4 x 4 pixels, whole ones even where rows end within them: with these the rows of the coarsest
// lattice are such blocks.
constexpr int kRowsAtOnce = 64;
// Software drivers draw a square of so many texels by one thread: of a small lattice each tile lies in one of its own.
constexpr int kThreadSide = 64, kSpreadColumns = 2 * kThreadSide;

// Those beside the cells that hold `length` px: one before, and two behind the cell that is behind the last.
int nodes(int length, int side) { return (length - 1) / side + 5; }

}  // namespace

void LightLattice::resize(const std::vector<Pass>& passes, int width, int height, bool own_steps) {
    longer_ = draft_ && !own_steps;
    if (std::ranges::find(passes, Stage::kLattice, &Pass::stage) == passes.end()) {
        levels_ = {};
        none_ = {};
        longer_ = false;
        return;
    }
    width_ = width, height_ = height;
    for (std::size_t i = 0; i < kSides.size(); ++i) size(i);
    if (none_.nodes.width > 0) return;
    none_.nodes = gl::make_target(3, 5, gl::Format::kRgba32F);
    none_.cells = gl::make_target(5, 5, gl::Format::kRgba32F);
}

void LightLattice::size(std::size_t number) {
    Level& level = levels_[number];
    level.texels = draft_ ? 1 : 2;
    // Of odd sizes: llvmpipe compiles once more for textures whose sides are powers of two.
    const int columns = nodes(width_, kSides[number]), packed = level.texels * columns | 1,
              up = nodes(height_, kSides[number]) | 1;
    level.columns = packed / level.texels;
    level.spread = packed <= kSpreadColumns ? kThreadSide / kTileSide : 1;
    const int across = packed + (packed - 1) / kTileSide * kTileSide * (level.spread - 1);
    if (level.nodes.width == across && level.nodes.height == up) return;
    level.nodes = gl::make_target(across, up, gl::Format::kRgba32F);
    level.cells = gl::make_target(columns | 1, up, gl::Format::kRgba32F);
}

void LightLattice::begin() {
    for (Level& level : levels_) level.rows = 0;
}

void LightLattice::extend(const Programs& programs, int last) {
    const int ahead = (last + kRowsAtOnce - 1) / kRowsAtOnce * kRowsAtOnce;
    extend(kSides.size() - 1, programs, std::min(ahead, height_));
    bind(first_);
}

void LightLattice::extend(std::size_t number, const Programs& programs, int last) {
    Level& level = levels_[number];
    if (last <= level.rows) return;
    const int side = kSides[number], up = level.nodes.height;
    const auto drawn = [&](int rows) { return rows == 0 ? 0 : rows < height_ ? std::min(nodes(rows, side), up) : up; };
    const int from = drawn(level.rows), to = drawn(last);
    if (number > 0) extend(number - 1, programs, std::min((to - 1) * side, height_));
    bind(number > 0 ? levels_[number - 1] : none_);
    const Tell tell_nodes = [&](const gl::Program& program) {
        gl::set_integer(program, "lattice_side", number > 0 ? kSides[number - 1] : 0);
        gl::set_integer(program, "lattice_texels", number > 0 ? levels_[number - 1].texels : 1);
        gl::set_integer(program, "lattice_spread", number > 0 ? levels_[number - 1].spread : 1);
        gl::set_integer(program, "lattice_drawn_texels", level.texels);
        gl::set_integer(program, "lattice_drawn_spread", level.spread);
        gl::set_integer(program, "lattice_drawn", side);
        gl::set_integer(program, "medium_longer", longer_ ? 1 : 0);
        gl::set_integer(program, "lattice_across", level.nodes.width);
        gl::set_integer(program, "lattice_up", up);
    };
    const auto draw_nodes = [&](const gl::Program& program) {
        tell_nodes(program);
        gl::draw_tiles(program, programs.empty, level.nodes.framebuffer.id(), level.nodes.width, up, kTileSide, from,
                       to);
    };
    if (!programs.compute(tell_nodes, level.nodes, from, to)) draw_nodes(programs.traced());
    if (number > 0) draw_nodes(programs.told);
    // The cells of these rows: those above their nodes are not there yet.
    gl::bind_texture_2d(first_, level.nodes.colours.front());
    gl::set_integer(programs.cells, "lattice_texels", level.texels);
    gl::set_integer(programs.cells, "lattice_spread", level.spread);
    gl::set_integer(programs.cells, "lattice_columns", level.columns);
    gl::set_integer(programs.cells, "lattice_error",
                    !draft_                 ? kError
                    : side == kSides.back() ? kFinestDraftError
                                            : kDraftError);
    gl::draw_rows(programs.cells, programs.empty, level.cells.framebuffer.id(), level.cells.width, up,
                  std::max(from - 3, 0), to == up ? up : to - 3);
    level.rows = last;
}

void LightLattice::bind(int first) {
    first_ = first;
    if (none_.nodes.width > 0) bind(levels_.back());
}

void LightLattice::bind(const Level& level) {
    gl::bind_texture_2d(first_, level.nodes.colours.front());
    gl::bind_texture_2d(first_ + 1, level.cells.colours.front());
}

void LightLattice::tell(const gl::Program& program) const {
    gl::set_integer(program, "medium_longer", longer_ ? 1 : 0);
    if (none_.nodes.width == 0) return;
    gl::set_integer(program, "lattice_side", kSides.back());
    gl::set_integer(program, "lattice_texels", levels_.back().texels);
    gl::set_integer(program, "lattice_spread", levels_.back().spread);
}

}  // namespace nullscope
