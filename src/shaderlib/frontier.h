// What every way of tracing was measured to err and to cost, and the choice by an error that is asked for. Written by
// `nullscope bench accuracy --frontier FILE`; the file that ships is assets/frontier.csv.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"
#include "shaderlib/method.h"

namespace nullscope {

struct MeasuredMethod {
    std::string metric;
    Method method;
    double error_px;  // largest screen error on the sky over the cameras of the bench, px of a 4K frame over 90 degrees
    double floor_ratio;  // cost of a frame over the same frame in flat space
    // The same on a disc that covers what a disc can: mostly the orbit table's, whatever the method.
    double disc_error_px = 0.0;
};

// Errors: file missing, a line that is not metric,method,error_px,floor_ratio,disc_error_px.
Result<std::vector<MeasuredMethod>> load_frontier(const std::filesystem::path& path);
std::string frontier_text(const std::vector<MeasuredMethod>& methods);

// The measured error in px of this scene's frame, of the sky or, where there is a disc, the larger of the two: an error in the look
// direction's own angle is worth more pixels the smaller the pixels are, so it is scaled by the smallest (in the frame's corners).
double error_in_frame(const MeasuredMethod& method, const Scene& scene);

// Is another method of the same metric at least as exact and as cheap, and better in one of the two?
bool is_dominated(const MeasuredMethod& method, const std::vector<MeasuredMethod>& methods);

// Of a metric; nullptr where nothing was measured.
const MeasuredMethod* most_exact(const std::vector<MeasuredMethod>& methods, const std::string& metric);

inline constexpr double kDefaultMaxError_px = 0.05;  // of the frame that is drawn

struct Choice {
    Method method;
    double error_px;     // expected at most, px of this camera's frame
    std::string reason;  // one sentence
    bool says = false;   // even where nothing was asked: next to the ring of a rotating hole, where there is one method
};

// The cheapest method whose error stays under max_error_px in this camera's frame.
// Errors: nothing is that exact; the message names the smallest error there is.
Result<Choice> choose_method(const std::vector<MeasuredMethod>& methods, const Scene& scene, double max_error_px);

// What draws a scene for which nothing was asked: by kDefaultMaxError_px, and where the pixels are too small for that to be
// sure of any method, the most exact one. error_px then is a bound by scaling, far too large for pixels much smaller than
// the bench's; where it tells nothing the reason does not give it.
Choice default_method(const std::vector<MeasuredMethod>& methods, const Scene& scene);

}  // namespace nullscope
