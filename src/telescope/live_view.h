// What a panel of telescopes shows of a picture that changes while one looks: some ms each time.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "telescope/first_minimum.h"
#include "telescope/live_source.h"
#include "telescope/observation.h"

namespace nullscope {

using Triangle = std::array<std::size_t, 3>;  // stations, ascending

// A day of an array that sees the source 10 degrees high or more, a scan every 10 minutes of Greenwich sidereal time.
Observation live_day(const std::vector<Station>& stations, const LiveSource& source);
// Those whose stations see the source together, in the stations' order.
std::vector<Triangle> triangles_of(const Observation& day);
// The scan in the middle of those; nullptr: there is none.
const Scan* middle_scan(const Observation& day, const Triangle& triangle);

struct TrianglePhase {
    double hour = 0, phase = 0;  // of the day, [0, 24]; rad, (-pi, pi]
};

struct LiveWish {
    double angle = 0;       // of the curve's baselines, rad from north through east
    double longest = 0;     // of the curve and the plane, wavelengths; above 0
    int points = 129;       // of the curve, from 0 to the longest
    int plane = 64;         // px of the plane's side
    Triangle triangle{};    // whose closure phase is asked for
    bool whole_day = true;  // false: of its middle scan alone
};

struct LiveView {
    std::vector<double> amplitudes;  // |V| of the curve, in the picture's unit
    std::optional<LeastVisibility> minimum;
    // |V| at baselines from the longest to the east and north (first pixel) to the longest to the west and south, both in equal steps.
    Image<float> plane;
    std::vector<TrianglePhase> phases;  // of the scans in which the triangle sees the source
};

// Of I, of points in the pixels' middles. Cost with 128 x 128 px: 6 ms on a core, 1.5 of them of a triangle's whole day.
LiveView live_view(const SkyPicture& picture, const Observation& day, const LiveWish& wish);

// |V| of the plane alone: rows, then columns are summed, 1.2 ms on a core for 64 x 64 of 128 x 128 px.
Image<float> visibility_plane(const SkyPicture& picture, double longest, int side);

}  // namespace nullscope
