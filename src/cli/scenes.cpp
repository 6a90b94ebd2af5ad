// nullscope scenes and nullscope info: what ships, and what works on this machine.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "cli/command.h"
#include "command/options.h"
#include "command/session.h"
#include "scenefile/scene_file.h"
#include "scenefile/scene_writer.h"

namespace nullscope::cli {
namespace {

struct ScenesOptions {
    std::string name;
};

Status run_scenes(const ScenesOptions& options) {
    if (!options.name.empty()) {
        TRY(scene, load_scene(options.name));
        fmt::print("{}", scene_file_text(*scene, {}));
        return Done{};
    }
    const auto scenes = shipped_scenes();
    if (scenes.empty()) return failed("no scenes found; set NULLSCOPE_ASSETS to the folder assets/");
    std::size_t widest = 0;
    for (const SceneInfo& scene : scenes) widest = std::max(widest, scene.name.size());
    for (const SceneInfo& scene : scenes) fmt::print("{:<{}}  {}\n", scene.name, widest, scene.description);
    return Done{};
}

}  // namespace

void add_scenes(Command& parent) {
    auto [command, options] = add_command<ScenesOptions>(
        parent, "scenes", "List the built-in scenes, with one sentence each, or print one", run_scenes);
    command.add_option("name", &options.name, "Print this scene's file, with absolute paths: scenes kerr > mine.toml");
}

void add_info(Command& parent) {
    Command& command =
        parent.add_command("info", "Show which OpenGL contexts work here, with driver, version and limits");
    command.on_run([]() -> Result<int> {
        int working = 0;
        for (const std::string& kind : context_kinds()) {
            auto session = open_session(kind);
            if (!session) {
                fmt::print("{}: not here: {}\n", kind, session.error().message());
                continue;
            }
            ++working;
            const gl::Info& i = session->renderer->info();
            fmt::print("{}: OpenGL {}\n  renderer {} ({}), GLSL {}\n  largest texture {}, target {} px\n", kind,
                       i.version, i.renderer, i.vendor, i.glsl, i.max_texture_size, i.max_renderbuffer_size);
        }
        return working > 0 ? 0 : 1;
    });
}

}  // namespace nullscope::cli
