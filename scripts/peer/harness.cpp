// Draws a full-screen picture by shaders that are read from files and prints what processor time each frame took. peer.py writes the shaders'
// texts, from a checkout of another program, and the settings; here are only an OpenGL context, textures and uniforms. Built by peer.py:
//     g++ -std=c++20 -O2 harness.cpp -lEGL -lGL -lpng
// Usage: harness SETTINGS; each line of this file is a key and its values, with tabs between them. Prints one line of JSON; exit status 1 with a message.
#include "textures.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <ctime>
#include <utility>

namespace peer {
namespace {

bool make_context_on(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
        return false;
    const std::array<EGLint, 5> wanted = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count < 1) return false;
    const std::array<EGLint, 7> attributes = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

// The first place that gives one, in the order of src/context/egl.cpp, so that both programs draw by one driver; peer.py checks its name.
void make_context() {
    const auto display_of =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (display_of != nullptr && query != nullptr && query(16, devices.data(), &count))
        for (EGLint i = 0; i < count; ++i)
            if (make_context_on(display_of(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr)))
                return;
    if (display_of != nullptr &&
        make_context_on(display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)))
        return;
    if (!make_context_on(eglGetDisplay(EGL_DEFAULT_DISPLAY))) fail("EGL: no OpenGL 3.3 core context");
}

GLuint shader_of(GLenum kind, const std::string& path) {
    const std::string text = read_text(path);
    const char* start = text.c_str();
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &start, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    std::array<char, 4096> log{};
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    if (!good) fail(path + ": " + log.data());
    return shader;
}

GLuint program_of(const Settings& settings) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, shader_of(GL_VERTEX_SHADER, settings.text("vertex")));
    glAttachShader(program, shader_of(GL_FRAGMENT_SHADER, settings.text("fragment")));
    glLinkProgram(program);
    GLint good = 0;
    std::array<char, 4096> log{};
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    if (!good) fail(std::string("the shaders do not link: ") + log.data());
    return program;
}

double encoded(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055; }

using Vec3 = std::array<double, 3>;
Vec3 combined(double a, const Vec3& u, double b, const Vec3& v) {
    return {a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]};
}

// A camera at rest at camera R THETA PHI (r_s, degrees) that looks at the centre, its top tilted to its right by ROLL, FOV across the picture.
// By the shader's conventions: e_w to the right, e_h up, e_d backward, in Cartesian components of Schwarzschild's coordinates, so that what points
// along the radius is shortened by sqrt(1 - 1/r).
void set_camera(GLuint program, const Settings& settings, int width, int height) {
    constexpr double kDegree = M_PI / 180.0;
    const double r = settings.number("camera", 0), theta = settings.number("camera", 1) * kDegree,
                 phi = settings.number("camera", 2) * kDegree, roll = settings.number("camera", 3) * kDegree,
                 fov = settings.number("camera", 4) * kDegree, shorter = std::sqrt(1.0 - 1.0 / r);
    const Vec3 radial = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
    const Vec3 up = {-std::cos(theta) * std::cos(phi), -std::cos(theta) * std::sin(phi), std::sin(theta)};
    const Vec3 right = {-std::sin(phi), std::cos(phi), 0.0};
    const auto set = [&](const char* name, const Vec3& v) {
        const std::array<float, 3> value = {static_cast<float>(v[0]), static_cast<float>(v[1]),
                                            static_cast<float>(v[2])};
        glUniform3fv(glGetUniformLocation(program, name), 1, value.data());
    };
    set("camera_size", {0.5 * width, 0.5 * height, 0.5 * width / std::tan(0.5 * fov)});
    set("p", combined(r, radial, 0.0, radial));
    set("e_tau", {0.0, 0.0, 0.0});
    set("e_w", combined(std::cos(roll), right, -std::sin(roll), up));
    set("e_h", combined(std::cos(roll), up, std::sin(roll), right));
    set("e_d", combined(shorter, radial, 0.0, radial));
    glUniform4f(glGetUniformLocation(program, "camera_position"), 0.0F, static_cast<float>(r),
                static_cast<float>(theta), static_cast<float>(phi));
    glUniform4f(glGetUniformLocation(program, "k_s"), static_cast<float>(1.0 / shorter), 0.0F, 0.0F, 0.0F);
}

void set_uniforms(GLuint program, const Settings& settings, int width, int height) {
    glUseProgram(program);
    set_camera(program, settings, width, height);
    const std::array<std::pair<const char*, Unit>, 9> units = {{{"ray_deflection_texture", kDeflection},
                                                                {"ray_inverse_radius_texture", kInverseRadius},
                                                                {"galaxy_cube_texture", kSky},
                                                                {"star_cube_texture", kStars},
                                                                {"star_cube_texture2", kStarsFar},
                                                                {"black_body_texture", kBlackBody},
                                                                {"doppler_texture", kDoppler},
                                                                {"noise_texture", kNoise},
                                                                {"disc_image", kImage}}};
    for (const auto& [name, unit] : units) glUniform1i(glGetUniformLocation(program, name), unit);
    const std::array<float, 9> identity = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    glUniformMatrix3fv(glGetUniformLocation(program, "stars_orientation"), 1, GL_FALSE, identity.data());
    glUniform1f(glGetUniformLocation(program, "min_stars_lod"), 0.0F);
    glUniform3f(glGetUniformLocation(program, "disc_params"), static_cast<float>(settings.number("disc", 0)),
                static_cast<float>(settings.number("disc", 1)), static_cast<float>(settings.number("disc", 2)));
}

void make_target(GLint format, int width, int height) {
    GLuint texture = 0, framebuffer = 0;
    glGenTextures(1, &texture);
    glActiveTexture(GL_TEXTURE15);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) fail("the target is not complete");
    glViewport(0, 0, width, height);
}

void write_picture(const Settings& settings, int width, int height) {
    std::vector<float> light(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, light.data());
    std::vector<unsigned char> bytes;
    for (std::size_t i = 0; i < light.size(); ++i)
        if (i % 4 != 3) {
            if (!std::isfinite(light[i])) fail("the picture has light that is not finite");
            bytes.push_back(static_cast<unsigned char>(
                std::lround(255.0 * encoded(shown_of(std::max(static_cast<double>(light[i]), 0.0))))));
        }
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(width), png.height = static_cast<png_uint_32>(height),
    png.format = PNG_FORMAT_RGB;
    if (!png_image_write_to_file(&png, settings.text("png").c_str(), 0, bytes.data(), -3 * width, nullptr))
        fail(settings.text("png") + ": " + png.message);
}

double core_seconds_of_frame() {
    glFinish();
    const std::clock_t before = std::clock();  // of all threads, as src/bench/bench.cpp
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glFinish();
    return static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
}

}  // namespace
}  // namespace peer

int main(int argc, char** argv) {
    using namespace peer;
    if (argc != 2) fail("usage: harness SETTINGS");
    const Settings settings = read_settings(argv[1]);
    const int width = settings.count("size", 0), height = settings.count("size", 1);
    make_context();
    const GLuint program = program_of(settings);
    load_textures(settings);
    const bool draws_png = settings.has("png");
    make_target(draws_png ? GL_RGBA32F : GL_RGBA8, width, height);
    set_uniforms(program, settings, width, height);
    GLuint array = 0, buffer = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    const std::array<float, 8> corners = {-1, -1, 1, -1, -1, 1, 1, 1};
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
    for (int i = 0; i < settings.count("warm_up"); ++i) core_seconds_of_frame();
    std::string frames;
    for (int i = 0; i < settings.count("frames"); ++i)
        frames += (frames.empty() ? "" : ", ") + std::to_string(core_seconds_of_frame());
    if (draws_png) write_picture(settings, width, height);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) fail("OpenGL error " + std::to_string(error));
    std::printf("{\"renderer\": \"%s\", \"core_seconds\": [%s]}\n",
                reinterpret_cast<const char*>(glGetString(GL_RENDERER)), frames.c_str());
}
