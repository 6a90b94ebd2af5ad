// The parameters of a fit: numbers of a scene, each free within a range.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"
#include "scenefile/scene_override.h"

namespace nullscope::fit {

struct FreeParameter {
    std::string key;           // as --set has it: "camera.theta", "ball[2].radius"
    double low = 0, high = 0;  // in the unit of scene files; low < high
    bool is_searched = true;   // else the search begins in the middle of its range alone
    std::string words{};       // of --free: "spin=0:0.99"; empty: others free it
    double at(double share) const { return low + share * (high - low); }
    double share(double value) const { return (value - low) / (high - low); }
};

inline constexpr std::size_t kMostParameters = 12;

// Of "KEY=LOW:HIGH,KEY=LOW:HIGH": keys of a scene file; of a metric's parameter its name alone ("spin"). Errors (bad input): no ranges, LOW not
// below HIGH, a key twice, too many.
Result<std::vector<FreeParameter>> parse_free(const std::string& words);

// A scene whose free parameters are any numbers: read anew for each, so that it is what `--set` makes of it.
class SceneFamily {
public:
    // scene: a file, or the name of one that ships; set: words of --set. Errors: those of the scene; a key that the scene cannot have, that is no
    // number, or whose range is not within the key's own, said of the words of --free.
    static Result<SceneFamily> open(std::string scene, const std::vector<std::string>& set,
                                    std::vector<FreeParameter> free);
    // text: of a scene file (scenefile/scene_writer.h), whose relative paths are of the folder of the scenes that ship.
    static Result<SceneFamily> of_text(std::string text, std::vector<FreeParameter> free);

    const std::vector<FreeParameter>& free() const { return free_; }
    // Its values in the unit of scene files, one for each parameter. Errors (bad input): what the scene's file could not be either. Cost: a
    // millisecond.
    Result<Scene> at(const std::vector<double>& values) const;
    Result<Scene> somewhere() const;  // with every parameter in the middle of its range
    // With further parameters, likewise checked.
    Result<SceneFamily> with(std::vector<FreeParameter> more) const;

private:
    using Read = std::function<Result<Scene>(const SceneOverrides&)>;
    Status check() const;
    Status check_names() const;
    Error said_of_free(Error error) const;
    Read read_;
    std::vector<FreeParameter> free_;
};

}  // namespace nullscope::fit
