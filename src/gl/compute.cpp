#include "gl/compute.h"

#include <glad/gl.h>

#include <utility>

#include "gl/abilities.h"
#include "gl/driver_log.h"

namespace nullscope::gl {
namespace {

constexpr GLenum kStored[] = {GL_RGBA8, GL_RGBA16F, GL_RGBA32F};  // by Format
constexpr const char* kFormats[] = {"rgba8", "rgba16f", "rgba32f"};

GLint integer_of(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

GLint attached(GLenum what) {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, what, &value);
    return value;
}

void bind_image(GLuint unit, unsigned texture, Format format, GLenum access) {
    glBindImageTexture(unit, texture, 0, GL_FALSE, 0, access, kStored[static_cast<int>(format)]);
}

void finish_dispatch() {
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_PIXEL_BUFFER_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    check("compute");
}

void dispatch(const Program& program, int width, int side, int first, int last) {
    set_integer(program, "thread_row", first / side);
    const int across = (width + side - 1) / side, up = (last + side - 1) / side - first / side;
    glDispatchCompute(static_cast<GLuint>(across), static_cast<GLuint>(up), 1);
    finish_dispatch();
}

void bind_layer(const Program& program, const StoredImage& to, int first, int last, const Layer& layer) {
    set_integer(program, "drawn_from", first);
    set_integer(program, "drawn_to", last);
    glUniform1f(glGetUniformLocation(program.id(), "layer_share"), static_cast<float>(layer.share));
    bind_image(0, to.texture, to.format, GL_READ_WRITE);
}

// What a list begins with (shaders/shared/tile_list.glsl): nothing, in no group.
constexpr GLuint kNoTiles[] = {0, 0, 1, 1};
constexpr int kListThreads = 64;
constexpr GLuint kPatchList = 1;  // shaders/stage/patch.glsl

// llvmpipe draws a block of 2 x 2 threads as one vector: what one of them stores the others see at once. With barrier() it keeps what lives in
// loops in memory, which costs 1.4 times as much.
bool draws_in_step() { return names_llvmpipe(info().renderer); }

// Of a driver's log, which may begin with warnings; all of it where no line tells of an error.
std::string first_error(const std::string& log) {
    const std::size_t error = log.find("error");
    const std::size_t begin = error == std::string::npos ? 0 : log.rfind('\n', error) + 1;  // npos + 1: 0
    return log.substr(begin, log.find('\n', begin) - begin);
}

}  // namespace

bool skips_groups() { return !names_llvmpipe(info().renderer); }

bool computes() {
    const GLint major = integer_of(GL_MAJOR_VERSION), minor = integer_of(GL_MINOR_VERSION);
    return (major > 4 || (major == 4 && minor >= 3)) && GLAD_GL_ARB_compute_shader != 0 &&
           GLAD_GL_ARB_shader_image_load_store != 0 && GLAD_GL_ARB_shader_storage_buffer_object != 0;
}

std::optional<StoredImage> stored_image(unsigned framebuffer) {
    if (framebuffer == 0) return std::nullopt;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (attached(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE) return std::nullopt;
    StoredImage image{.texture = static_cast<unsigned>(attached(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME))};
    const auto bound = static_cast<GLuint>(integer_of(GL_TEXTURE_BINDING_2D));
    glBindTexture(GL_TEXTURE_2D, image.texture);
    GLint stored = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &stored);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &image.width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &image.height);
    glBindTexture(GL_TEXTURE_2D, bound);
    for (const Format format : {Format::kRgba8, Format::kRgba16F, Format::kRgba32F}) {
        image.format = format;
        if (kStored[static_cast<int>(format)] == static_cast<GLenum>(stored)) return image;
    }
    return std::nullopt;
}

ComputeProgram make_compute_program(const std::string& text, Stored stored) {
    const std::string source = std::string("#version 430 core\n#define PICTURE_FORMAT ") +
                               kFormats[static_cast<int>(stored.format)] + "\n#define PICTURE_ADDS " +
                               (stored.adds ? "true" : "false") + "\n#define GROUP_WAITS " +
                               (draws_in_step() ? "memoryBarrierShared" : "barrier") + "\n#define GROUP_TOGETHER " +
                               (draws_in_step() ? "false" : "true") + "\n" + text;
    const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
    const char* lines = source.c_str();
    glShaderSource(shader, 1, &lines, nullptr);
    glCompileShader(shader);
    Program program(glCreateProgram());
    glAttachShader(program.id(), shader);
    glLinkProgram(program.id());
    std::string log = log_of(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);  // with the program
    GLint ok = 0;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &ok);
    if (ok == GL_TRUE) return {std::move(program), {}};
    log += log_of(program.id(), glGetProgramiv, glGetProgramInfoLog);
    return {Program(), "the driver refuses a compute shader: " + first_error(explained_log(log, source))};
}

void TileList::find(const Program& program, int across, int first, int last) {
    const int count = across * (last - first);
    if (room_ < count) {
        room_ = count;
        GLuint made = 0;
        glGenBuffers(1, &made);
        buffer_ = Buffer(made);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, made);
        glBufferData(GL_SHADER_STORAGE_BUFFER,
                     static_cast<GLsizeiptr>(sizeof(kNoTiles) + sizeof(GLuint) * static_cast<std::size_t>(room_)),
                     nullptr, GL_DYNAMIC_COPY);
    }
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer_.id());
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof kNoTiles, kNoTiles);
    set_integer(program, "tiles_across", across);
    set_integer(program, "tile_from", first * across);
    set_integer(program, "tile_to", last * across);
    glDispatchCompute(static_cast<GLuint>((count + kListThreads - 1) / kListThreads), 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    check("list tiles");
}

void TileList::dispatch(const Program& program) const {
    glUseProgram(program.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer_.id());
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, buffer_.id());
    glDispatchComputeIndirect(sizeof(GLuint));  // behind their number
    finish_dispatch();
}

void compute_rows(const Program& program, const StoredImage& to, int side, int first, int last, const Layer& layer) {
    bind_layer(program, to, first, last, layer);
    dispatch(program, to.width, side, first, last);
}

void compute_tiles(const Program& program, const StoredImage& to, const TileList& tiles, int first, int last,
                   const Layer& layer) {
    bind_layer(program, to, first, last, layer);
    tiles.dispatch(program);
}

void compute_patches(const Program& program, const StoredImage& to, const VertexList& patches, int side, int last) {
    bind_layer(program, to, 0, last, {});
    set_integer(program, "patch_count", patches.count);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kPatchList, patches.data.id());
    dispatch(program, to.width, side, 0, last);
}

void compute_rows(const Program& program, const Target& to, int side, int first, int last) {
    for (std::size_t i = 0; i < to.colours.size(); ++i)
        bind_image(static_cast<GLuint>(i), to.colours[i].id(), Format::kRgba32F, GL_WRITE_ONLY);
    dispatch(program, to.width, side, first, last);
}

}  // namespace nullscope::gl
