#include "render/warp_texture.h"

#include <fmt/format.h>

namespace nullscope {
namespace {

constexpr int kHead = 2;  // WARP_HEAD of shaders/effect/warp.glsl

}  // namespace

std::vector<float> warp_texels(const WarpMesh& mesh, std::array<double, 2> half) {
    const CellBins& bins = mesh.bins();
    const std::size_t bin_count = bins.first.empty() ? 0 : bins.first.size() - 1, first_cell = kHead + bin_count,
                      first_node = first_cell + bins.cells.size(), count = first_node + 2 * mesh.nodes().size();
    std::vector<float> texels;
    texels.reserve((count + kWarpRow) * 4);
    const auto add = [&](double x, double y, double z, double w) {
        for (const double value : {x, y, z, w}) texels.push_back(static_cast<float>(value));
    };
    add(bins.left, bins.bottom, bins.columns / (bins.right - bins.left), bins.rows / (bins.top - bins.bottom));
    add(bin_count == 0 ? 0 : bins.columns, bin_count == 0 ? 0 : bins.rows, half[0], half[1]);
    for (std::size_t bin = 0; bin < bin_count; ++bin)
        add(static_cast<double>(first_cell) + bins.first[bin], bins.first[bin + 1] - bins.first[bin], 0, 0);
    const auto node = [&](int number) { return static_cast<double>(first_node) + 2.0 * number; };
    for (const int cell : bins.cells) {
        const auto& corners = mesh.cells()[static_cast<std::size_t>(cell)];
        add(node(corners[0]), node(corners[1]), node(corners[2]), node(corners[3]));
    }
    for (const WarpNode& at : mesh.nodes()) {
        add(at.x, at.y, (2 * at.u - 1) * half[0] - at.x, (2 * at.v - 1) * half[1] - at.y);
        add(at.light, 0, 0, 0);
    }
    texels.resize((count + kWarpRow - 1) / kWarpRow * kWarpRow * 4);
    return texels;
}

Status WarpTexture::update(const CameraSpec& camera, int largest) {
    if (camera.warp.empty()) {
        *this = {};
        return Done{};
    }
    TRY(mesh, load_warp_mesh(camera.warp));
    const auto half = input_half(camera);
    if (mesh_ == *mesh && half_ == half) return Done{};
    const std::vector<float> texels = warp_texels(**mesh, half);
    const int rows = static_cast<int>(texels.size() / 4 / kWarpRow);
    if (rows > largest)
        return bad_input(fmt::format("the mesh of camera.warp needs a texture of {} rows", rows),
                         fmt::format("at most {} here", largest));
    texture_ = gl::make_number_texture(kWarpRow, rows, 4, texels.data(), false);
    mesh_ = *mesh, half_ = half, rows_ = rows;
    return Done{};
}

}  // namespace nullscope
