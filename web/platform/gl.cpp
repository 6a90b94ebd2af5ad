// WebGL2 for src/gl: its functions are those of OpenGL ES 3.0, which page/webgl.js gives. It has no clock.
#include "gl/gl.h"

extern "C" [[noreturn]] __attribute__((import_module("page"), import_name("fail"))) void page_fail(const char* text,
                                                                                                   std::size_t size);

namespace nullscope::gl {

void prepare_context() {}

void fail(const std::string& what) { page_fail(what.data(), what.size()); }

Query timestamp() { return {}; }

double milliseconds(const Query&, const Query&) { return 0; }

}  // namespace nullscope::gl
