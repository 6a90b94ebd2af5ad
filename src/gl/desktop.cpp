// What OpenGL on a desktop has and a browser has otherwise: functions that are looked up, failures that are thrown, a clock of the driver's.
#include <fmt/format.h>
#include <glad/gl.h>

#include "gl/driver_death.h"
#include "gl/gl.h"

namespace nullscope::gl {
namespace {

struct Loader {
    void (*(*get_proc_address)(const char*, void*))();
    void* user;
};

GLADapiproc load_one(void* userptr, const char* name) {
    const auto* loader = static_cast<const Loader*>(userptr);
    return reinterpret_cast<GLADapiproc>(loader->get_proc_address(name, loader->user));
}

}  // namespace

void load_functions(void (*(*get_proc_address)(const char*, void*))(), void* user) {
    Loader loader{get_proc_address, user};
    const int version = gladLoadGLUserPtr(load_one, &loader);
    if (version == 0) fail("the OpenGL functions cannot be loaded");
    if (version < GLAD_MAKE_VERSION(3, 3))
        fail(fmt::format("OpenGL 3.3 is needed; this driver has {}.{} ({})", GLAD_VERSION_MAJOR(version),
                         GLAD_VERSION_MINOR(version), info().renderer));
    remember_driver(info().renderer.c_str(), info().version.c_str());
    prepare_context();
}

void prepare_context() { glDisable(GL_DITHER); }

Format filtered_light() { return Format::kRgba32F; }

bool is_compiled(const Program&) { return true; }

void fail(const std::string& what) { throw GlError(what); }

Query timestamp() {
    unsigned id = 0;
    glGenQueries(1, &id);
    Query query(id);
    glQueryCounter(id, GL_TIMESTAMP);
    glFlush();  // drivers that draw tile by tile would do both ends of a picture in each tile
    return query;
}

double milliseconds(const Query& from, const Query& to) {
    GLuint64 began = 0, ended = 0;
    glGetQueryObjectui64v(from.id(), GL_QUERY_RESULT, &began);
    glGetQueryObjectui64v(to.id(), GL_QUERY_RESULT, &ended);
    return 1e-6 * static_cast<double>(ended - began);
}

}  // namespace nullscope::gl
