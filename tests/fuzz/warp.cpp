// Warp meshes.
#include <cmath>

#include "fuzz.h"
#include "scene/warp_mesh.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    const auto mesh = WarpMesh::parse(fuzz::text_of(data, size), "mesh.data");
    if (!mesh) {
        fuzz::must_be_a_good_error(mesh.error());
        return 0;
    }
    for (double y = -1.1; y < 1.2; y += 0.1)
        for (double x = -1.9; x < 2.0; x += 0.1) {
            const auto place = mesh->at(x, y);
            if (!place) continue;
            fuzz::must(std::isfinite(place->u) && std::isfinite(place->v), "a place in the picture");
            fuzz::must(place->light >= -1e-5 && place->light <= 1.001 * kMostWarpLight,
                       "light as that of nodes that are drawn");
            if (std::fabs(place->u) > 1.5 || std::fabs(place->v) > 1.5) continue;
            mesh->place_of(place->u, place->v);
        }
    return 0;
}
