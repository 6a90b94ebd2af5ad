// What a frame takes by fragment and by compute shaders, of each kind of scene on each device: a small file remembers what was measured.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "plan/effects.h"
#include "shaderlib/method.h"
#include "shaderlib/passes.h"

namespace nullscope {

inline constexpr const char* kFragmentStage = "fragment";
inline constexpr const char* kComputeStage = "compute";

struct StageTimes {
    double fragment_ms = 0.0, compute_ms = 0.0;  // a frame
    bool computes() const { return compute_ms < fragment_ms; }
    const char* stage() const { return computes() ? kComputeStage : kFragmentStage; }
    std::string words() const;  // "12.3 ms a frame by fragments, 3.1042 by compute"
};

// In the user's folder of states (platform/places.h); empty where there is none.
std::filesystem::path stage_file();

// What decides which of both is the lesser, but the device: a line. Of one ray a pixel: more are drawn by the same programs.
std::string scene_kind(const std::string& metric, const EffectSet& effects, const Method& method, Tiles tiles);

class StageMemory {
public:
    struct Row {
        std::string device, kind;
        StageTimes times;
    };
    static constexpr std::size_t kMostRows = 1000;  // the oldest are forgotten

    // Empty: what is measured is known to this object alone. A file that cannot be read, and rows that say nothing, count as not there: they are
    // measured again.
    explicit StageMemory(std::filesystem::path file = stage_file());

    std::optional<StageTimes> find(const std::string& device, const std::string& kind) const;
    // Of every device, oldest first.
    std::vector<Row> of_kind(const std::string& kind) const;
    // With what other processes have kept meanwhile. Errors: the file cannot be written; this object knows it all the same.
    Status keep(const std::string& device, const std::string& kind, const StageTimes& times);

private:
    void read();

    std::filesystem::path file_;
    std::vector<Row> rows_;
};

}  // namespace nullscope
