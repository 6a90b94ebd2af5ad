// Lists of rays through a tracer, what nullscope trace does (docs/ray-data.md).
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "context/context.h"
#include "scene/ray.h"
#include "scene/scene.h"
#include "spacetime/spacetime.h"

namespace nullscope::cli {

struct TraceOptions {
    std::string with = "reference";  // core64, core32, gl
    std::string method = "auto";     // of gl
    ContextChoice context{};         // of gl
    int crossings = 0;               // of the equatorial plane, to list
    std::string stage = "fragment";  // of gl: or compute
};

// What becomes of the rays, in any order. Lengths are in r_s: Spacetime::length_unit divides them out again.
struct TraceOutput {
    std::function<void(std::size_t ray, RayRecord&& record)> take;  // a ray that the shader cannot trace is not taken
    std::function<void(long long rays)> done;                       // so many more are traced; may throw
    std::function<Error(std::size_t ray, Error)> error;             // the error of a ray, with what says which
    std::function<void(const std::string&)> note = [](const std::string&) {};  // a line, for people
};

// The scene's metric, disc and bodies are used. Errors: options that do not go together, a ray outside the metric's domain.
Status trace_rays(const Scene& scene, const Spacetime& spacetime, std::span<const RayQuery> rays,
                  const TraceOptions& options, const TraceOutput& output);

// Through the middles of a picture's pixels, row by row from the top, as an observer at rest sees them.
std::vector<RayQuery> rays_of(const CameraSpec& camera);

// What is listed of each crossing, in this order: r and phi, of a disc whose matter moves and shines by itself g, of one that is polarised chi and p.
struct CrossingColumn {
    std::string_view name;  // r of r_1, r_2, ...
    double RayRecord::Crossing::*value;
    bool is_length;
};
std::vector<CrossingColumn> crossing_columns(const Scene& scene, const Spacetime& spacetime);

// What is to be said of rays that the shader cannot trace: how many of how many; and of places that it does not compute. Empty: nothing.
std::string left_out_note(std::size_t left_out, std::size_t of, const TraceOptions& options);
std::string no_places_note(const Scene& scene, const Spacetime& spacetime, std::span<const RayQuery> rays,
                           const TraceOptions& options);

}  // namespace nullscope::cli
