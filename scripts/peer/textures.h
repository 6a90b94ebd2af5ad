// What harness.cpp reads: its settings, tables and pictures, and the textures that are made of them.
#pragma once
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace peer {

[[noreturn]] inline void fail(const std::string& what) {
    std::fprintf(stderr, "harness: %s\n", what.c_str());
    std::exit(1);
}

struct Settings {
    std::map<std::string, std::vector<std::string>> lines;
    bool has(const std::string& key) const { return lines.contains(key); }
    const std::string& text(const std::string& key, std::size_t i = 0) const {
        const auto found = lines.find(key);
        if (found == lines.end() || found->second.size() <= i) fail("settings: no value " + key);
        return found->second[i];
    }
    double number(const std::string& key, std::size_t i = 0) const {
        char* end = nullptr;
        const double value = std::strtod(text(key, i).c_str(), &end);
        if (end == text(key, i).c_str() || *end != 0) fail("settings: " + key + ": not a number: " + text(key, i));
        return value;
    }
    int count(const std::string& key, std::size_t i = 0) const { return static_cast<int>(number(key, i)); }
};

inline Settings read_settings(const char* path) {
    std::ifstream file(path);
    if (!file) fail(std::string("cannot read ") + path);
    Settings settings;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string key, word;
        std::getline(words, key, '\t');
        while (std::getline(words, word, '\t')) settings.lines[key].push_back(word);
    }
    return settings;
}

inline std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file || text.str().empty()) fail("cannot read " + path);
    return text.str();
}

inline std::vector<float> read_floats(const std::string& path) {
    const std::string bytes = read_text(path);
    std::vector<float> values(bytes.size() / sizeof(float));
    std::copy_n(bytes.data(), values.size() * sizeof(float), reinterpret_cast<char*>(values.data()));
    return values;
}

// 8 bits, rows from the top.
struct Picture {
    int width = 0, height = 0, channels = 0;
    std::vector<unsigned char> bytes;
};

inline Picture read_png(const std::string& path, int channels) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, path.c_str())) fail(path + ": " + png.message);
    png.format = channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
    Picture picture{static_cast<int>(png.width), static_cast<int>(png.height), channels, {}};
    picture.bytes.resize(PNG_IMAGE_SIZE(png));
    const png_color background{};
    if (!png_image_finish_read(&png, &background, picture.bytes.data(), 0, nullptr)) fail(path + ": " + png.message);
    return picture;
}

inline double decoded(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
// The tone curve "shoulder" of pictures, and back: what is shown as white is 6 times as bright as what 1 - 1/e stands for.
inline double shown_of(double light) { return 1.0 - std::exp(-light); }
inline double light_of(double shown) { return -std::log(std::max(1.0 - shown, std::exp(-6.0))); }
enum Unit : GLenum { kDeflection, kInverseRadius, kSky, kStars, kStarsFar, kBlackBody, kDoppler, kNoise, kImage };

inline void bind_new(Unit unit, GLenum target, bool mipmaps, bool repeats) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target, texture);
    const GLint wrap = repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(target, axis, wrap);
}

// Width, height and pairs of numbers: the peer's tables of rays.
inline void load_pairs(Unit unit, const std::string& path) {
    const std::vector<float> values = read_floats(path);
    const std::size_t width = values.size() < 2 ? 0 : static_cast<std::size_t>(values[0]);
    const std::size_t height = values.size() < 2 ? 0 : static_cast<std::size_t>(values[1]);
    if (width == 0 || values.size() != 2 + 2 * width * height) fail(path + ": not a table of pairs");
    bind_new(unit, GL_TEXTURE_2D, false, false);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, static_cast<GLsizei>(width), static_cast<GLsizei>(height), 0, GL_RG,
                 GL_FLOAT, values.data() + 2);
}

inline void load_light_tables(const Settings& settings) {
    const std::vector<float> black_body = read_floats(settings.text("black_body"));
    if (black_body.size() != 3 * 128) fail(settings.text("black_body") + ": not 128 colours");
    bind_new(kBlackBody, GL_TEXTURE_2D, false, false);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, 128, 1, 0, GL_RGB, GL_FLOAT, black_body.data());
    const std::vector<float> doppler = read_floats(settings.text("doppler"));
    if (doppler.size() != std::size_t{3} * 64 * 32 * 64) fail(settings.text("doppler") + ": not 64 x 32 x 64 colours");
    bind_new(kDoppler, GL_TEXTURE_3D, false, false);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB32F, 64, 32, 64, 0, GL_RGB, GL_FLOAT, doppler.data());
}

inline void load_image(Unit unit, const std::string& path, GLint format, int channels) {
    const Picture picture = read_png(path, channels);
    bind_new(unit, GL_TEXTURE_2D, true, unit == kNoise);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, format, picture.width, picture.height, 0, channels == 1 ? GL_RED : GL_RGB,
                 GL_UNSIGNED_BYTE, picture.bytes.data());
    glGenerateMipmap(GL_TEXTURE_2D);
}

// OpenGL 3.3 core, table 3.19: the direction of a texel of a face of a cube map.
inline std::array<double, 3> direction_of(int face, double s, double t) {
    switch (face) {
        case 0: return {1.0, -t, -s};
        case 1: return {-1.0, -t, s};
        case 2: return {s, 1.0, t};
        case 3: return {s, -1.0, -t};
        case 4: return {s, -t, 1.0};
        default: return {-s, -t, -1.0};
    }
}

// A cube as nullscope draws it for a camera at azimuth 0 in the equatorial plane, which looks along -x with +z up and +y to its right: three
// columns and two rows of faces, left, ahead, right above down, behind, up (docs/scenes.md, projections). Linear light of a direction.
inline const unsigned char* texel_along(const Picture& cube, const std::array<double, 3>& d) {
    const double right = d[1], up = d[2], ahead = -d[0];
    const double most = std::max({std::abs(right), std::abs(up), std::abs(ahead)});
    int column = 1, row = 0;
    double x = right, y = up;  // ahead
    if (most == std::abs(right))
        column = right < 0 ? 0 : 2, x = right < 0 ? ahead : -ahead;
    else if (most == std::abs(up))
        column = up < 0 ? 0 : 2, row = 1, y = up < 0 ? ahead : -ahead;
    else if (ahead < 0)
        row = 1, x = -right;
    const int size = cube.height / 2;
    const auto texel = [&](double v) {
        return std::clamp(static_cast<int>((0.5 + 0.5 * v / most) * size), 0, size - 1);
    };
    const int px = column * size + texel(x), py = row * size + texel(-y);
    return &cube.bytes[3 * (static_cast<std::size_t>(py) * static_cast<std::size_t>(cube.width) +
                            static_cast<std::size_t>(px))];
}

inline std::vector<float> halved(const std::vector<float>& from, int size) {
    const std::size_t half = static_cast<std::size_t>(size) / 2, row = 3 * static_cast<std::size_t>(size);
    std::vector<float> to(3 * half * half);
    for (std::size_t y = 0; y < half; ++y)
        for (std::size_t x = 0; x < half; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const float* at = &from[2 * y * row + 6 * x + c];
                to[3 * (y * half + x) + c] = 0.25F * (at[0] + at[3] + at[row] + at[row + 3]);
            }
    return to;
}

// The peer's format of its sky, all levels. sky PATH GAIN.
inline void load_sky(const Settings& settings) {
    const Picture cube = read_png(settings.text("sky"), 3);
    if (cube.width * 2 != cube.height * 3) fail(settings.text("sky") + ": not 3 x 2 faces");
    const int size = cube.height / 2;
    std::array<float, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = static_cast<float>(light_of(decoded(static_cast<double>(i) / 255.0)) * settings.number("sky", 1));
    bind_new(kSky, GL_TEXTURE_CUBE_MAP, true, false);
    for (int face = 0; face < 6; ++face) {
        std::vector<float> texels(3 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
        float* texel = texels.data();
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x, texel += 3) {
                const unsigned char* from =
                    texel_along(cube, direction_of(face, (2.0 * x + 1.0) / size - 1.0, (2.0 * y + 1.0) / size - 1.0));
                for (int c = 0; c < 3; ++c) texel[c] = light[from[c]];
            }
        for (int level = 0, side = size; side > 0; ++level, side /= 2) {
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), level, GL_RGB9_E5, side, side, 0,
                         GL_RGB, GL_FLOAT, texels.data());
            if (side > 1) texels = halved(texels, side);
        }
    }
}

// A grid on one channel. sky_grid SIZE CELL LINE: texels a side of a face, of a cell, of a line.
inline void load_sky_grid(const Settings& settings) {
    const int size = settings.count("sky_grid", 0), cell = settings.count("sky_grid", 1),
              line = settings.count("sky_grid", 2);
    std::vector<unsigned char> texels;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            texels.push_back((x + line / 2) % cell < line || (y + line / 2) % cell < line ? 255 : 0);
    bind_new(kSky, GL_TEXTURE_CUBE_MAP, true, false);
    for (GLenum face = 0; face < 6; ++face)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_R8, size, size, 0, GL_RED, GL_UNSIGNED_BYTE,
                     texels.data());
    glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
}

inline void load_textures(const Settings& settings) {
    load_pairs(kDeflection, settings.text("deflection"));
    load_pairs(kInverseRadius, settings.text("inverse_radius"));
    load_light_tables(settings);
    load_image(kNoise, settings.text("noise"), GL_R8, 1);
    if (settings.has("image")) load_image(kImage, settings.text("image"), GL_SRGB8, 3);
    if (settings.has("sky")) load_sky(settings);
    if (settings.has("sky_grid")) load_sky_grid(settings);
    if (settings.count("seamless") != 0) glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

}  // namespace peer
