// The driver's layout of the uniform block is that of the C++ struct.
#include "shadercore/core_trace.h"
#include "shaderlib/shader_source.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// Members of FrameData as the text declares them.
std::vector<std::string> frame_members() {
    std::vector<std::string> members;
    const std::string text(shader_file("shared/frame_block.glsl"));
    for (std::size_t at = text.find("    vec4 "); at != std::string::npos; at = text.find("    vec4 ", at + 1)) {
        const std::size_t name = at + 9;
        members.push_back("frame." + text.substr(name, text.find(';', name) - name));
    }
    return members;
}

TEST_CASE("uniform block: the driver's offsets are those of the C++ struct") {
    const auto members = frame_members();
    const auto offsets = frame_offsets();
    REQUIRE(members.size() == offsets.size());
    REQUIRE(members.front() == "frame.image");
    on_every_context([&](GpuSession&) {
        const EffectSet all{Effect::kLensing, Effect::kAberration, Effect::kDisc, Effect::kTranslucentDisc,
                            Effect::kSky};
        const ShaderSource source = shader_source(Stage::kPicture, all, Output::kDisplay);
        const gl::Program program = gl::make_program(source.vertex, source.fragment);
        const std::vector<int> driver = gl::uniform_offsets(program, members);
        for (std::size_t i = 0; i < members.size(); ++i) {
            CAPTURE(members[i]);
            CHECK(driver[i] == static_cast<int>(offsets[i]));
        }
    });
}

}  // namespace
