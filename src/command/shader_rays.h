// Rays through the shader's own text: those that start at one radius are traced together, in one draw (shaders/stage/ray_list.glsl).
#pragma once
#include <span>
#include <string>

#include "base/result.h"
#include "command/ray_trace.h"
#include "context/context.h"
#include "scene/scene.h"
#include "shaderlib/method.h"

namespace nullscope::cli {

struct ShaderRun {
    std::string tracer;       // core64, core32 or gl
    Method method;            // of gl; the C++ core has the strip only
    ContextChoice context{};  // of gl
    bool compute = false;     // of gl: by compute shaders, where the driver has them
    int crossings = 0;        // of the equatorial plane, to find
    bool shifts = false;      // and what frequency light has in the disc's matter there
    bool polarised = false;   // and how it is polarised, in a scene with shifts
};

// A ray is left out whose camera cannot stand in a static frame outside the horizon (or lies beyond kFarthestCamera). Of a record these
// stay empty: turn; delay where the shader does not know it; g unless escaped; crossings from the 13th on, and about a rotating hole their
// windings.
Status trace_with_shader(const Scene& scene, const Spacetime& spacetime, std::span<const RayQuery> rays,
                         const ShaderRun& run, const TraceOutput& output);

inline constexpr double kFarthestCamera = 1e9;  // r_s, as in scene files: the shader's floats hold 1/r and its square

}  // namespace nullscope::cli
