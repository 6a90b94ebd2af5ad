// WebGL2 for src/gl: its functions are those of OpenGL ES 3.0, which page/webgl.js gives. It has no clock.
#include "gl/gl.h"
#include "gl/compute.h"
#include "platform/filters.h"

#include <glad/gl.h>

extern "C" [[noreturn]] __attribute__((import_module("page"), import_name("fail"))) void page_fail(const char* text,
                                                                                                   std::size_t size);

namespace nullscope::gl {

void prepare_context() {}

void fail(const std::string& what) { page_fail(what.data(), what.size()); }

bool filters_floats = false;
Format filtered_light() { return filters_floats ? Format::kRgba32F : Format::kRgba16F; }

// WebGL2 has no compute shaders.
bool computes() { return false; }
std::optional<StoredImage> stored_image(unsigned) { return std::nullopt; }
ComputeProgram make_compute_program(const std::string&, Stored) { return {}; }
void TileList::find(const Program&, int, int, int) {}
void compute_tiles(const Program&, const StoredImage&, const TileList&, int, int, const Layer&) {}
void compute_patches(const Program&, const StoredImage&, const VertexList&, int, int) {}
bool skips_groups() { return false; }
void compute_rows(const Program&, const StoredImage&, int, int, int, const Layer&) {}
void compute_rows(const Program&, const Target&, int, int, int) {}

// page/webgl.js says yes where the browser cannot tell (KHR_parallel_shader_compile).
bool is_compiled(const Program& program) {
    constexpr GLenum kCompletionStatus = 0x91b1;
    GLint done = 0;
    glGetProgramiv(program.id(), kCompletionStatus, &done);
    return done != 0;
}

Query timestamp() { return {}; }

double milliseconds(const Query&, const Query&) { return 0; }

}  // namespace nullscope::gl
