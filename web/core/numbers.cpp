// What the scene's picture is computed from, without a context: the bytes of its uniform blocks and the values of its tables.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <span>

#include "core/exports.h"
#include "core/session.h"
#include "render/body_numbers.h"
#include "render/frame_numbers.h"
#include "render/frame_tables.h"
#include "shaderlib/shader_source.h"

namespace nullscope::web {
namespace {

constexpr int kSkySize = 1024, kDiscWidth = 2048;  // px: what textures are taken to have
constexpr int kAngles = 16;                        // of a deflection table, where its sweeps are asked for

// Eight hexadecimal digits each.
std::string floats_json(std::span<const FrameVector> vectors) {
    std::string digits;
    for (const FrameVector& v : vectors)
        for (const double value : {v.x, v.y, v.z, v.w})
            digits += fmt::format("{:08x}", std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    return in_json(digits);
}

// At most most of them, evenly.
std::string some_json(const std::vector<float>& values, std::size_t most) {
    std::vector<std::string> list;
    const std::size_t step = std::max<std::size_t>(values.size() / most, 1) | 1;  // of all four channels
    for (std::size_t i = 0; i < values.size(); i += step) list.push_back(fmt::format("{:.9g}", values[i]));
    return fmt::format("[{}]", fmt::join(list, ","));
}

std::string sweeps_json(const DeflectionTable& table) {
    std::vector<std::string> list;
    for (int i = 1; i < kAngles; ++i)
        for (int j = 1; j < kAngles; ++j) {
            const double x = static_cast<double>(i) / kAngles, y = static_cast<double>(j) / kAngles;
            list.push_back(
                fmt::format("{:.17g},{:.17g}", table.turning_remainder(x, y), table.through_remainder(x, y)));
        }
    return fmt::format("[{}]", fmt::join(list, ","));
}

}  // namespace

// {"frame", "objects": digits of floats, "members": which of the frame's vectors, "table": radians, "texels": {name: [width, height, values]}}.
NULLSCOPE_EXPORT(numbers) bool numbers(int texels_each) {
    static FrameTables tables;
    Scene scene = session().scene;
    scene.path.reset();
    if (const Status made = tables.update(scene); !made) return answer(made.error());
    const TextureFacts facts{kSkySize, kDiscWidth, {}};
    const FrameVectors all = vectors_of(frame_numbers(tables.plan(), tables.path(), facts, tables.ball_paths()));
    const std::vector<int> members = block_members(tables.effects());
    std::vector<FrameVector> frame;
    frame.reserve(members.size());
    for (const int member : members) frame.push_back(all[static_cast<std::size_t>(member)]);
    const std::vector<FrameVector> objects =
        object_numbers(tables.plan(), tables.path().family(), tables.ball_paths(), tables.clearances());
    std::vector<std::string> texels;
    const auto take = [&](std::string_view name, const TexelGrid& grid) {
        texels.push_back(fmt::format("{}: [{}, {}, {}]", in_json(name), grid.width, grid.height,
                                     some_json(grid.texels, static_cast<std::size_t>(texels_each))));
    };
    for (const NamedTexels& named : tables.path().tables()) take(named.name, *named.texels);
    take("ball paths", tables.ball_paths().rows);
    const DeflectionTable* table = tables.path().table();
    return answer(fmt::format(R"({{"frame": {}, "objects": {}, "members": [{}], "table": {}, "texels": {{{}}}}})",
                              floats_json(frame), floats_json(objects), fmt::join(members, ","),
                              table == nullptr ? "[]" : sweeps_json(*table), fmt::join(texels, ", ")));
}

}  // namespace nullscope::web
