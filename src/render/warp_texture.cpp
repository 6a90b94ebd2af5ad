#include "render/warp_texture.h"

#include <fmt/format.h>

namespace nullscope {
namespace {

constexpr int kHead = 5;  // two for each kind of bins, and WARP_HALF of shaders/effect/warp.glsl

}  // namespace

std::vector<float> warp_texels(const WarpMesh& mesh, std::array<double, 2> half) {
    const std::array<const CellBins*, 2> kinds{&mesh.bins(), &mesh.picture_bins()};
    std::array<std::size_t, 2> first_bin{}, first_cell{};
    std::size_t count = kHead;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        first_bin[i] = count, first_cell[i] = count + kinds[i]->size();
        count = first_cell[i] + kinds[i]->cells.size();
    }
    const std::size_t first_node = count;
    count += 2 * mesh.nodes().size();
    std::vector<float> texels;
    texels.reserve((count + kWarpRow) * 4);
    const auto add = [&](double x, double y, double z, double w) {
        for (const double value : {x, y, z, w}) texels.push_back(static_cast<float>(value));
    };
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const CellBins& bins = *kinds[i];
        const bool picture = i == 1;  // by u and v
        const double x = picture ? 2 * half[0] : 1.0, y = picture ? 2 * half[1] : 1.0;
        add(bins.left * x - (picture ? half[0] : 0.0), bins.bottom * y - (picture ? half[1] : 0.0),
            bins.columns / ((bins.right - bins.left) * x), bins.rows / ((bins.top - bins.bottom) * y));
        add(bins.size() == 0 ? 0 : bins.columns, bins.size() == 0 ? 0 : bins.rows, static_cast<double>(first_bin[i]),
            0);
    }
    constexpr double kAnywhere = 1e9;
    const bool points = mesh.of_points();
    add(points ? kAnywhere : half[0], points ? kAnywhere : half[1], points ? 0.0 : 1.0, 0);
    const auto node = [&](int number) { return static_cast<double>(first_node) + 2.0 * number; };
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const CellBins& bins = *kinds[i];
        for (std::size_t bin = 0; bin < bins.size(); ++bin)
            add(static_cast<double>(first_cell[i]) + bins.first[bin], bins.first[bin + 1] - bins.first[bin], 0, 0);
        for (const int cell : bins.cells) {
            const auto& corners = mesh.cells()[static_cast<std::size_t>(cell)];
            add(node(corners[0]), node(corners[1]), node(corners[2]), node(corners[3]));
        }
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
    TRY(mesh, load_warp_mesh(camera));
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
