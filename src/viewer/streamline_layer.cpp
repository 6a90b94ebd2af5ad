#include "viewer/streamline_layer.h"

#include <vector>

#include "annotate/streamlines.h"
#include "render/picture_layers.h"

namespace nullscope::viewer {
namespace {

// rows: RGBA, from the bottom.
void darken(const Image<unsigned char>& mark, std::vector<unsigned char>& rows) {
    const std::size_t row_bytes = static_cast<std::size_t>(mark.width) * 4;
    for (int y = 0; y < mark.height; ++y) {
        unsigned char* row = rows.data() + row_bytes * static_cast<std::size_t>(mark.height - 1 - y);
        for (int x = 0; x < mark.width; ++x)
            for (int c = 0; c < 3; ++c) {
                unsigned char& value = row[4 * x + c];
                value = static_cast<unsigned char>((value * (255 - mark.at(x, y)[3]) + 127) / 255);
            }
    }
}

}  // namespace

bool shows_streamlines(const Scene& scene) { return scene.picture.streamlines && is_polarised(scene) && !scene.split; }

void lay_streamlines(Renderer& renderer, const Scene& scene, const gl::Target& picture) {
    const int width = picture.width, height = picture.height;
    if (!renderer.prepare(streamline_scene(scene, width, height))) return;
    const std::vector<Mark> marks = streamline_marks(draw_stokes(renderer), width, height);
    std::vector<unsigned char> rows(static_cast<std::size_t>(width) * height * 4);
    gl::read_rgba8(picture, rows.data());
    for (const Mark& mark : marks) darken(mark.rgba, rows);
    const gl::Texture darker = gl::make_rgba8_texture(width, height, rows.data());
    gl::blit(darker.id(), width, height, picture.framebuffer.id(), width, height);
}

}  // namespace nullscope::viewer
