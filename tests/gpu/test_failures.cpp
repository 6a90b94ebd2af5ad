// What the driver reports comes out as one exception that says what it was, and what failed once may succeed again.
// Emulated: a software driver loses no context, and memory cannot be made short for one call.
#include <doctest/doctest.h>

#include <string_view>
#include <utility>

#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

using namespace nullscope;

namespace {

unsigned next_error = 0;
unsigned emulated_get_error() { return std::exchange(next_error, 0u); }

GlProc with_emulated_errors(const char* name, void* user) {
    if (std::string_view(name) == "glGetError") return reinterpret_cast<GlProc>(emulated_get_error);
    return static_cast<GlContext*>(user)->get_proc_address(name);
}

std::string what_is_thrown(Renderer& renderer) {
    try {
        static_cast<void>(renderer.picture8());
    } catch (const gl::GlError& error) {
        return error.what();
    }
    return "nothing";
}

}  // namespace

TEST_CASE("a lost context and a GPU without memory are told apart, and are no crash") {
    test::on_every_context([](test::GpuSession& session) {
        auto scene = load_scene("flat");
        REQUIRE(scene);
        scene->camera.width = scene->camera.height = 16;
        REQUIRE(session.renderer->prepare(*scene));
        const Image<unsigned char> picture = session.renderer->picture8();
        gl::load_functions(with_emulated_errors, session.context.get());
        next_error = 0x0505;
        CHECK(what_is_thrown(*session.renderer) == "framebuffer: the GPU is out of memory");
        next_error = 0x0507;
        CHECK(what_is_thrown(*session.renderer) ==
              "framebuffer: the driver was reset and has lost its context; start again");
        next_error = 0x0502;
        CHECK(what_is_thrown(*session.renderer) == "framebuffer: OpenGL error 0x0502");
        CHECK(session.renderer->picture8().data == picture.data);
    });
}
