// Warp meshes made of functions, as files.
#pragma once
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>

#include "base/atomic_file.h"
#include "scene/warp_mesh.h"
#include "support/temporary_folder.h"

namespace nullscope::test {

// Nodes on a grid of the screen, x from -aspect to aspect; move: changes x, y, u, v and light, which are those of a mesh of identity for a
// picture as wide as the screen.
inline std::string warp_text(int columns, int rows, double aspect, const std::function<void(WarpNode&)>& move,
                             int kind = 2) {
    std::string text = fmt::format("{}\n{} {}\n", kind, columns, rows);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double s = static_cast<double>(column) / (columns - 1), t = static_cast<double>(row) / (rows - 1);
            WarpNode node{(2 * s - 1) * aspect, 2 * t - 1, s, t, 1.0};
            move(node);
            text +=
                fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", node.x, node.y, node.u, node.v, node.light);
        }
    return text;
}

inline void write_warp(const std::filesystem::path& file, const std::string& text) {
    if (const Status written = write_text_atomically(file, text); !written) {
        std::fprintf(stderr, "write_warp: %s\n", written.error().message().c_str());
        std::abort();
    }
}

}  // namespace nullscope::test
