// Which visibilities nullscope visibility was asked for: baselines from a table, on a line, or of an array as the Earth turns.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/table_file.h"
#include "cli/visibility_tables.h"
#include "command/session.h"
#include "scene/known_object.h"

namespace nullscope::cli {

struct VisibilityOptions {
    std::vector<std::string> set;  // scenefile/scene_override.h
    std::string scene, image, output = "visibility", size, renderer = "gl";
    ContextChoice context;
    std::string baselines, array, pixel = "point", scattering = "none";
    std::vector<std::string> radial, hours, source;
    std::optional<double> time, frequency_GHz;
    std::optional<int> samples, noise, mjd;
    int points = 500;
    bool rings = false;
    double elevation_deg = 10, bandwidth_GHz = 2, integration_s = 60;
    GivenWords given;
};

// What is known of the light before it is drawn.
struct LightSource {
    std::optional<double> frequency_GHz;
    std::optional<SkyPlace> place;
};

// GHz: the light's, else as asked, else 230. Error: both, and they differ.
Result<double> frequency_of(const VisibilityOptions& options, const LightSource& light);

// Rows without what is found. Errors (bad input): options that do not go together, files with a fault (file, line, column), no place in the sky.
Result<VisibilityRows> requested_rows(const VisibilityOptions& options, const LightSource& light);

}  // namespace nullscope::cli
