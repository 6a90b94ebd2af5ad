// What each OpenGL device here can and draws. A driver may end the process that uses it: each is asked in a process of its own.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "context/context.h"
#include "gl/abilities.h"
#include "gl/gl.h"
#include "image/image.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope::cli {

struct DeviceFacts {
    ContextDevice device{};
    std::string failure{};  // why it gives no context; empty: it gives one, and the others are known
    gl::Info info{};
    gl::Abilities can{};
};

// Of context_devices(), in their order. limit_s: for each. Errors: no process could be made, the libraries ended it.
Result<std::vector<DeviceFacts>> device_facts(double limit_s);

// A scene as a device drew it.
struct DeviceTrial {
    std::string failure{};  // why it did not, or how the driver ended; empty: the others are known
    RayFrame rays{};        // of every kTrialRowStep-th row
    Image<unsigned char> picture{};
    double first_ms = 0;       // wall: the first picture, with all that is made for it
    double frame_ms = 0;       // wall: a later one, the least of three
    double frame_core_ms = 0;  // processor time of such a one, of all threads
};
inline constexpr int kTrialRowStep = 4;

// device: its number. Must be called before this process has threads of its own (TBB). Errors: no process could be made.
Result<DeviceTrial> device_trial(int device, const Scene& scene, double limit_s);

}  // namespace nullscope::cli
