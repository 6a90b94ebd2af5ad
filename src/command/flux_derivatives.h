// The flux of a scene's disc, or of its matter, and its derivatives, what nullscope flux --derivatives does (docs/ray-data.md, "Derivatives of a flux").
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace nullscope::cli {

// Of the scene's thermal disc, or of its matter along rays, in its picture. keys: see parameter_names(). error: relative, of the flux and its derivatives. notes: lines for people, of what
// does not count. Some 10 to 100 core-seconds. Errors: PictureLight's, PictureMatter's, flux_gradient's.
struct FluxTable {
    struct Row {
        std::string name;  // flux, d_KEY
        double value, relative, error;
    };
    std::vector<Row> rows;
    std::vector<std::string> notes;
};
Result<FluxTable> flux_derivatives(const Scene& scene, const std::vector<std::string>& keys, double error);

// key,value,relative,error, a row each.
std::string flux_csv(const FluxTable& table);

}  // namespace nullscope::cli
