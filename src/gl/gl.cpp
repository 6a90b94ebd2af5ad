#include "gl/gl.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <map>
#include <sstream>

#include "gl/driver_log.h"

namespace nullscope::gl {
namespace {

// How a sky's texels are stored and come.
struct SkyTexelKind {
    GLenum stored, format, type;
};
constexpr SkyTexelKind sky_texel_kind(bool halves) {
    if (halves) return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
    return {GL_R11F_G11F_B10F, GL_RGB, GL_UNSIGNED_INT_10F_11F_11F_REV};
}

std::string text_of(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

GLuint begin_shader(GLenum kind, const std::string& source) {
    const GLuint shader = glCreateShader(kind);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    return shader;
}

// fails if the driver refuses it.
void check_shader(GLenum kind, const std::string& source) {
    const GLuint shader = begin_shader(kind, source);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    const std::string log = ok == GL_TRUE ? "" : log_of(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);
    if (ok != GL_TRUE) fail("the driver refuses a shader: " + explained_log(log, source));
}

void set_sampling(GLenum target, GLint minify, GLint magnify) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, minify);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnify);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

GLuint one(void (*generate)(GLsizei, GLuint*)) {
    GLuint id = 0;
    generate(1, &id);
    return id;
}

void bind(int unit, GLenum target, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(target, texture);
}

GLuint new_texture(GLenum target) {
    const GLuint id = one(glGenTextures);
    bind(0, target, id);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    return id;
}

// One level of two dimensions, the same filter for larger and smaller.
Texture plain_texture(int width, int height, GLint stored, GLenum format, GLenum type, const void* data, GLint filter) {
    Texture texture(new_texture(GL_TEXTURE_2D));
    set_sampling(GL_TEXTURE_2D, filter, filter);
    glTexImage2D(GL_TEXTURE_2D, 0, stored, width, height, 0, format, type, data);
    return texture;
}

void read_rows(const Target& target, int attachment, int first, int rows, GLenum type, void* out) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachment));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, first, target.width, rows, GL_RGBA, type, out);
    check("read pixels");
}

}  // namespace

Info info() {
    Info i{text_of(GL_VERSION), text_of(GL_RENDERER), text_of(GL_VENDOR), text_of(GL_SHADING_LANGUAGE_VERSION)};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &i.max_texture_size);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &i.max_renderbuffer_size);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &i.max_layers);
    glGetIntegerv(GL_MAX_VARYING_COMPONENTS, &i.max_varying);
    return i;
}

void check(const char* where) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    if (error == GL_OUT_OF_MEMORY) fail(fmt::format("{}: the GPU is out of memory", where));
    constexpr GLenum kContextLost = 0x0507;  // OpenGL 4.5, KHR_robustness
    if (error == kContextLost)
        fail(fmt::format("{}: the driver was reset and has lost its context; start again", where));
    fail(fmt::format("{}: OpenGL error 0x{:04x}", where, error));
}

std::string explained_log(const std::string& log, const std::string& source) {
    constexpr int kLinesAFile = 10000;  // shaderlib/preprocess.h
    std::map<int, std::string> files, lines;
    std::istringstream in(source);
    std::string line, name, out;
    for (int number = 1; std::getline(in, line);) {
        if (line.starts_with("// ")) name = line.substr(3);
        if (std::sscanf(line.c_str(), "#line %d", &number) == 1)
            files.emplace(number / kLinesAFile, name);
        else
            lines[number++] = line;
    }
    in = std::istringstream(log);
    while (std::getline(in, line)) {
        // "0:123", "ERROR: 0:123:", "0(123) :"
        int number = 0, from = 0, to = 0;
        const std::size_t at = std::min(line.find_first_of("0123456789"), line.size());
        const bool placed = std::sscanf(line.c_str() + at, "%*d%*1[:(]%n%d%n", &from, &number, &to) == 1;
        if (const auto file = files.find(number / kLinesAFile); placed && file != files.end())
            line.replace(
                at, static_cast<std::size_t>(to),
                file->second + line[at + static_cast<std::size_t>(from) - 1] + std::to_string(number % kLinesAFile));
        out += line + "\n";
        if (placed) out += "    " + lines[number] + "\n";
    }
    return out;
}

void delete_program(unsigned id) { glDeleteProgram(id); }
void delete_texture(unsigned id) { glDeleteTextures(1, &id); }
void delete_buffer(unsigned id) { glDeleteBuffers(1, &id); }
void delete_framebuffer(unsigned id) { glDeleteFramebuffers(1, &id); }
void delete_vertex_array(unsigned id) { glDeleteVertexArrays(1, &id); }
void delete_renderbuffer(unsigned id) { glDeleteRenderbuffers(1, &id); }
void delete_query(unsigned id) { glDeleteQueries(1, &id); }

Program begin_program(const std::string& vertex, const std::string& fragment) {
    Program program(glCreateProgram());
    for (const auto& [kind, source] : {std::pair{GL_VERTEX_SHADER, &vertex}, {GL_FRAGMENT_SHADER, &fragment}}) {
        const GLuint shader = begin_shader(static_cast<GLenum>(kind), *source);
        glAttachShader(program.id(), shader);
        glDeleteShader(shader);  // with the program
    }
    glLinkProgram(program.id());
    return program;
}

void finish_program(const Program& program, const std::string& vertex, const std::string& fragment) {
    GLint ok = 0;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &ok);
    if (ok == GL_TRUE) return;
    check_shader(GL_VERTEX_SHADER, vertex);
    check_shader(GL_FRAGMENT_SHADER, fragment);
    fail("the driver cannot link a program: " + log_of(program.id(), glGetProgramiv, glGetProgramInfoLog));
}

Program make_program(const std::string& vertex, const std::string& fragment) {
    Program program = begin_program(vertex, fragment);
    finish_program(program, vertex, fragment);
    return program;
}

void bind_uniform_block(const Program& program, const char* block, unsigned binding) {
    const GLuint index = glGetUniformBlockIndex(program.id(), block);
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(program.id(), index, binding);
}

Texture make_number_texture(int width, int height, int channels, const float* values, bool linear) {
    const bool single = channels == 1;
    Texture texture = plain_texture(width, height, single ? GL_R32F : GL_RGBA32F, single ? GL_RED : GL_RGBA, GL_FLOAT,
                                    values, linear ? GL_LINEAR : GL_NEAREST);
    check("table texture");
    return texture;
}

Texture make_number_layers(int width, int height, int layers, const float* values) {
    Texture texture(new_texture(GL_TEXTURE_2D_ARRAY));
    set_sampling(GL_TEXTURE_2D_ARRAY, GL_NEAREST, GL_NEAREST);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32F, width, height, layers, 0, GL_RGBA, GL_FLOAT, values);
    check("layers of numbers");
    return texture;
}

void set_number_rows(const Texture& texture, int row, int width, int height, int layers, const float* values) {
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.id());
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, row, 0, width, height, layers, GL_RGBA, GL_FLOAT, values);
    check("rows of numbers");
}

Texture make_picture_texture(const std::vector<HalfTexels>& levels) {
    Texture texture(new_texture(GL_TEXTURE_2D));
    set_sampling(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    int level = 0;
    for (const HalfTexels& texels : levels)
        glTexImage2D(GL_TEXTURE_2D, level++, GL_RGBA16F, texels.width, texels.height, 0, GL_RGBA, GL_HALF_FLOAT,
                     texels.rgba);
    check("picture texture");
    return texture;
}

Texture make_rgba8_texture(int width, int height, const unsigned char* rgba) {
    Texture texture = plain_texture(width, height, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, rgba, GL_NEAREST);
    check("overlay texture");
    return texture;
}

Texture make_sky(int size, int levels, int layers, bool halves) {
    const SkyTexelKind kind = sky_texel_kind(halves);
    const auto stored = static_cast<GLint>(kind.stored);
    constexpr GLenum target = GL_TEXTURE_2D_ARRAY;
    Texture texture(new_texture(target));
    set_sampling(target, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, levels - 1);
    for (int level = 0; level < levels; ++level) {
        const int side = size >> level;
        glTexImage3D(target, level, stored, side, side, layers, 0, kind.format, kind.type, nullptr);
    }
    check("sky texture");
    return texture;
}

void fill_sky(const Texture& texture, const SkyTexels& t) {
    bind(0, GL_TEXTURE_2D_ARRAY, texture.id());
    const SkyTexelKind kind = sky_texel_kind(t.halves);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, t.level, 0, t.first_row, t.layer, t.width, t.rows, 1, kind.format, kind.type,
                    t.texels);
}

Buffer make_uniform_buffer(std::size_t bytes) {
    Buffer buffer(one(glGenBuffers));
    upload_uniforms(buffer, nullptr, bytes);
    return buffer;
}

void upload_uniforms(const Buffer& buffer, const void* data, std::size_t bytes) {
    glBindBuffer(GL_UNIFORM_BUFFER, buffer.id());
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
}

void bind_uniforms(const Buffer& buffer, unsigned binding) {
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.id());
}

VertexList make_vertex_list(const std::vector<float>& values, const std::vector<int>& sizes) {
    VertexList list{Buffer(one(glGenBuffers)), make_vertex_array(), 0};
    glBindVertexArray(list.layout.id());
    glBindBuffer(GL_ARRAY_BUFFER, list.data.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data(),
                 GL_STATIC_DRAW);
    int floats = 0;
    for (const int size : sizes) floats += size;
    std::size_t at = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        glEnableVertexAttribArray(static_cast<GLuint>(i));
        glVertexAttribPointer(static_cast<GLuint>(i), sizes[i], GL_FLOAT, GL_FALSE,
                              floats * static_cast<GLsizei>(sizeof(float)),
                              reinterpret_cast<const void*>(at));  // NOLINT: OpenGL's offset
        at += static_cast<std::size_t>(sizes[i]) * sizeof(float);
    }
    list.count = static_cast<int>(values.size()) / floats;
    check("vertices");
    return list;
}

Target make_target(int width, int height, Format format, int count) {
    constexpr GLint kStored[] = {GL_RGBA8, GL_RGBA16F, GL_RGBA32F};  // by Format
    const auto stored = kStored[static_cast<int>(format)];
    const GLenum type = format == Format::kRgba8 ? GL_UNSIGNED_BYTE : GL_FLOAT;
    Target target{width, height, {}, Framebuffer(one(glGenFramebuffers))};
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
    std::vector<GLenum> buffers;
    for (int i = 0; i < count; ++i) {
        target.colours.push_back(plain_texture(width, height, stored, GL_RGBA, type, nullptr, GL_NEAREST));
        buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
        glFramebufferTexture2D(GL_FRAMEBUFFER, buffers.back(), GL_TEXTURE_2D, target.colours.back().id(), 0);
    }
    glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    check("framebuffer");
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        fail(fmt::format("the driver cannot draw to a {}x{} target of this format", width, height));
    return target;
}

std::size_t bytes_of(Format format) { return format == Format::kRgba8 ? 4 : format == Format::kRgba16F ? 8 : 16; }

void clear(const Target& target) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
}

void read_rgba8(const Target& target, unsigned char* out) {
    read_rows(target, 0, 0, target.height, GL_UNSIGNED_BYTE, out);
}
void read_rgba32f(const Target& target, int attachment, float* out) {
    read_rows(target, attachment, 0, target.height, GL_FLOAT, out);
}
void read_rgba32f_row(const Target& target, int attachment, int row, float* out) {
    read_rows(target, attachment, row, 1, GL_FLOAT, out);
}

VertexArray make_vertex_array() { return VertexArray(one(glGenVertexArrays)); }

void set_integer(const Program& program, const char* uniform, int value) {
    glUseProgram(program.id());
    glUniform1i(glGetUniformLocation(program.id(), uniform), value);
}

void bind_texture_2d(int unit, const Texture& texture) { bind(unit, GL_TEXTURE_2D, texture.id()); }
void bind_texture_layers(int unit, const Texture& texture) { bind(unit, GL_TEXTURE_2D_ARRAY, texture.id()); }

void set_linear(const Texture& texture) {
    bind(0, GL_TEXTURE_2D, texture.id());
    set_sampling(GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
}

void blit(unsigned texture, int width, int height, unsigned framebuffer, int to_width, int to_height, int to_x,
          int left_edge) {
    // Framebuffers are no shared objects, and attaching anew shows what another context drew.
    const Framebuffer source(one(glGenFramebuffers));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source.id());
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glDisable(GL_SCISSOR_TEST);
    if (left_edge > 0)
        glEnable(GL_SCISSOR_TEST), glScissor(left_edge, 0, std::max(to_x + to_width - left_edge, 0), to_height);
    const bool same = width == to_width && height == to_height;
    glBlitFramebuffer(0, 0, width, height, to_x, 0, to_x + to_width, to_height, GL_COLOR_BUFFER_BIT,
                      same ? GL_NEAREST : GL_LINEAR);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, to_width, to_height);
    check("blit");
}

void finish() { glFinish(); }

}  // namespace nullscope::gl
