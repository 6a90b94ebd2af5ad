#include "scene/pixel_mesh.h"

#include <fmt/format.h>

#include <atomic>
#include <map>
#include <mutex>
#include <utility>

namespace nullscope {
namespace {

std::mutex held_mutex;
std::map<std::filesystem::path, std::shared_ptr<const WarpMesh>>& held() {
    static std::map<std::filesystem::path, std::shared_ptr<const WarpMesh>> meshes;
    return meshes;
}

}  // namespace

// A pixel is a corner of one cell, two by two pixels share one, and each cell has a bin of its own.
WarpMesh WarpMesh::of_pixels(const std::vector<std::array<double, 2>>& places, int width, int height) {
    WarpMesh mesh;
    mesh.columns_ = width, mesh.rows_ = height, mesh.of_points_ = true;
    const double half = 0.5 * height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto [u, v] = places[mesh.nodes_.size()];
            mesh.nodes_.push_back({(x + 0.5 - 0.5 * width) / half, 1.0 - (y + 0.5) / half, u, v, 1.0});
        }
    CellBins& bins = mesh.bins_;
    bins = {-width / (2.0 * half), -1.0, width / (2.0 * half), 1.0, width / 2, height / 2, {0}, {}};
    for (int row = bins.rows; row-- > 0;)  // from the lower left
        for (int column = 0; column < bins.columns; ++column) {
            const int upper = 2 * (row * width + column), lower = upper + width;
            bins.cells.push_back(static_cast<int>(mesh.cells_.size()));
            bins.first.push_back(static_cast<int>(bins.cells.size()));
            mesh.cells_.push_back({lower, lower + 1, upper + 1, upper});
        }
    mesh.least_area_ = 0;
    return mesh;
}

HeldMesh::HeldMesh(WarpMesh mesh) {
    static std::atomic<int> made = 0;
    name_ = fmt::format("a place for each pixel, {}", ++made);
    const std::lock_guard lock(held_mutex);
    held()[name_] = std::make_shared<const WarpMesh>(std::move(mesh));
}

HeldMesh::~HeldMesh() {
    const std::lock_guard lock(held_mutex);
    held().erase(name_);
}

std::shared_ptr<const WarpMesh> held_mesh(const std::filesystem::path& name) {
    const std::lock_guard lock(held_mutex);
    const auto found = held().find(name);
    return found == held().end() ? nullptr : found->second;
}

}  // namespace nullscope
