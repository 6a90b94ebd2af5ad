// What a driver says of a broken shader names the file and the line.
#include "plan/effects.h"
#include "shaderlib/shader_source.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// The line of a file of shaders/ that has this text in it.
int line_of(std::string_view file, std::string_view what) {
    const std::string_view text = shader_file(file);
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(text.find(what)), '\n'));
}

TEST_CASE("shader errors: file, line and text of a planted one") {
    const EffectSet effects = {Effect::kLensing, Effect::kDisc, Effect::kDiscImage, Effect::kSky};
    const ShaderSource source = shader_source(Stage::kPicture, effects, Output::kDisplay);
    for (const auto& [file, right] : {std::pair{"core/strip.glsl", "float half_tan = over / under;"},
                                      {"object/disc_cover.glsl", "float aa = dot(a, a);"},
                                      {"stage/ray_light.glsl", "sight.through = 1.0;"}}) {
        CAPTURE(file);
        std::string broken = source.fragment;
        const std::size_t at = broken.find(right);
        REQUIRE(at != std::string::npos);
        broken.replace(at, std::string_view(right).size(), "float planted = nowhere;");
        on_every_context([&](GpuSession&) {
            std::string said;
            try {
                gl::make_program(source.vertex, broken);
            } catch (const gl::GlError& error) {
                said = error.what();
            }
            CAPTURE(said);
            CHECK(said.find(std::string(file) + ":" + std::to_string(line_of(file, right))) != std::string::npos);
            CHECK(said.find("float planted = nowhere;") != std::string::npos);
        });
    }
}

TEST_CASE("shader errors: as the drivers of others write them") {
    const std::string source = "#version 330 core\n// a/b.glsl\n#line 10007\nint a;\nint b;\n#line 10002\nint c;\n";
    CHECK(gl::explained_log("0(10008) : error C1008: undefined", source) ==
          "a/b.glsl(8) : error C1008: undefined\n    int b;\n");
    CHECK(gl::explained_log("ERROR: 0:10002: 'x' : undeclared\nERROR: 1 compilation errors.\n", source) ==
          "ERROR: a/b.glsl:2: 'x' : undeclared\n    int c;\nERROR: 1 compilation errors.\n");
    CHECK(gl::explained_log("0:1(3): error", source) == "0:1(3): error\n    #version 330 core\n");
}

}  // namespace
