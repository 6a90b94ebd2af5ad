// Files of warp meshes, as programs for domes write them: which kind one is is seen from its beginning.
//
// Paul Bourke's (paulbourke.net/dataformats/meshwarp), a text. Its first line is its kind: 2 rectangular, 1 polar (the last column of nodes is
// joined to the first). The second has the numbers of nodes, nx ny. Then follow nx ny lines: x y u v i. Row by row, or column by column:
// where neighbours lie closer together tells.
// Stellarium's (custom_distortion_file), a text: a line "max_x max_y", then (max_x + 1)(max_y + 1) lines "x y r g b", row by row from below, of
// nodes that stand on the screen in rows of triangles; x and y: px of the picture before it is bent, which is as large as the screen,
// from its lower left corner. Its fisheye's circle is as high as the screen.
// SGC version 1, planar (Uniview, SGCT): binary, little-endian; x, y of the screen from its upper left corner, u, v from the lower left one.
// PFM (of MPCDI): three floats a pixel of the screen. Absolute: u, v, where v falls from row to row the upper row first, otherwise the lower
// one, as PFM has it. Or, as SGCT takes it, by how much each node of an even grid of the picture is moved on the screen, upper row
// first. Absolute is what spans more than half the picture along its rows. NaN, or u and v below 0: nothing is drawn.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace nullscope {

struct WarpNode {
    double x = 0, y = 0, u = 0, v = 0, light = 0;
};

// Of the picture that a mesh is for, px; some kinds of files tell of places in shares of it.
struct WarpScreen {
    int width = 1920, height = 1080;
    double pixel_aspect = 1.0;
    double aspect() const { return width * pixel_aspect / height; }
    friend auto operator<=>(const WarpScreen&, const WarpScreen&) = default;  // NOLINT(modernize-use-nullptr)
};

// nodes: row by row, as scene/warp_mesh.h has them.
struct WarpNodes {
    std::vector<WarpNode> nodes{};
    int columns = 0, rows = 0;
    bool joined = false;     // the last column to the first
    bool of_screen = false;  // the nodes are others for another screen
};

inline constexpr int kMostWarpNodes = 1'000'000, kMostWarpSide = 4096;
inline constexpr double kMostWarpPlace = 100.0, kMostWarpLight = 1000.0;  // of |x|, |y|, |u|, |v|; of i

// name: of the file, for messages. PFM with more nodes are read with every second one, or third. Errors: what is no mesh, a text with its line.
Result<WarpNodes> read_warp_nodes(std::string_view text, const std::string& name, const WarpScreen& screen);

}  // namespace nullscope
