// The diagram of nullscope spectrum.
#pragma once
#include <optional>
#include <string>

#include "spectrum/line_profile.h"

namespace nullscope::cli {

// SVG: photons per unit of g, or per keV where the line's energy is given, against that; the area below is the share of the line. title and
// words: two lines above.
std::string spectrum_plot(const std::string& title, const std::string& words, const LineProfile& profile,
                          std::optional<double> line_kev);

}  // namespace nullscope::cli
