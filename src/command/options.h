// Options that several commands have.
#pragma once
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/command_line.h"
#include "base/result.h"
#include "command/arguments.h"
#include "context/context.h"
#include "scenefile/key_place.h"
#include "scenefile/scene_file.h"

namespace nullscope::cli {

// A command whose options live as long as it does; run takes them. What it says of a key of options.scene, if there is that, has file and line.
template <class Options, class Run>
std::pair<Command&, Options&> add_command(Command& parent, const char* name, const char* help, Run run) {
    const auto options = std::make_shared<Options>();
    Command& command = parent.add_command(name, help);
    command.on_run([options, run] {
        if constexpr (requires { options->split.size(); })  // of which of both files a key is, is not known
            if (!options->split.empty()) return run(*options);
        if constexpr (requires { options->scene.size(), options->set.size(); })
            return of_scene(options->scene, options->set, run(*options));
        else if constexpr (requires { options->scene.size(); })
            return of_scene(options->scene, {}, run(*options));
        else
            return run(*options);
    });
    return {command, *options};
}

inline void required_option(Command& command, const char* names, std::string& target, std::string help) {
    command.add_option(names, &target, std::move(help)).required();
}

// A number, both ends allowed; help shows the default of one that always has a value.
template <class Number>
Option& number_option(Command& command, const char* names, Number& target, double least, double most,
                      const std::string& help) {
    Option& option = command.add_option(names, &target, help).in_range(least, most);
    return std::is_arithmetic_v<Number> ? option.show_default() : option;
}

// Text whose default help shows; words: all that it may be, none: anything.
inline void text_option(Command& command, const char* names, std::string& target, std::string help,
                        std::vector<std::string> words = {}) {
    command.add_option(names, &target, std::move(help)).one_of(std::move(words)).show_default();
}

// Values in the place of the scene's (scenefile/scene_override.h).
inline void set_option(Command& command, std::vector<std::string>& set) {
    command
        .add_option("--set", &set,
                    "KEY=VALUE, in the place of the scene's value: --set camera.theta=30 --set 'ball[2].radius=3'; "
                    "KEY= leaves it out: --set spacetime.spin=; once for each key")
        .repeated();
}

// The scene that a command was given, in its --size where it has one, with the values of its --set. Errors: those of load_scene, parse_size.
template <class Options>
Result<Scene> asked_scene(const Options& options) {
    TRY(overrides, parse_overrides(options.set));
    TRY(scene, load_scene(options.scene, note_on_terminal, *overrides));
    if constexpr (requires { options.size.size(); }) return sized(std::move(*scene), options.size);
    return std::move(*scene);
}

// --context and --device of what draws; help says what for.
inline void context_option(Command& command, ContextChoice& context, const std::string& help = "OpenGL context") {
    std::vector<std::string> kinds = context_kinds();
    kinds.insert(kinds.begin(), "auto");
    text_option(command, "--context", context.kind, fmt::format("{}: {}", help, fmt::join(kinds, ", ")), kinds);
    command.add_option("--device", &context.device, "OpenGL device, by its number in: nullscope devices")
        .in_range(0, 1000);
}

inline const char* option_of(const ContextChoice& context) { return context.device ? "--device" : "--context"; }

// Errors: bad input, where options are of the other renderer than that of renderer_option().
inline Status check_context(const std::string& renderer, const ContextChoice& context) {
    if (renderer == "reference" && !context.is_auto())
        return bad_input(fmt::format("{}: the reference tracer does not use OpenGL", option_of(context)),
                         "with --renderer gl");
    return Done{};
}
inline Status check_samples_of_reference(const std::string& renderer, bool samples) {
    if (samples && renderer != "reference")
        return bad_input("--samples: the shader takes one ray a pixel", "with --renderer reference");
    return Done{};
}

// --stage of what draws pictures by the shader.
inline void stage_option(Command& command, std::string& stage) {
    text_option(command, "--stage", stage,
                "Shaders that trace the picture: fragment, or compute, on drivers with OpenGL 4.3; the same functions",
                {"fragment", "compute"});
}

inline void renderer_option(Command& command, std::string& renderer) {
    text_option(command, "--renderer", renderer, "gl: the shader; reference: the double-precision tracer, slow",
                {"gl", "reference"});
}

}  // namespace nullscope::cli
