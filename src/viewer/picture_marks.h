// Divider, labels and scale bar over the picture in the window.
#pragma once
#include <vector>

#include "annotate/marks.h"
#include "gl/gl.h"
#include "viewer/window.h"

namespace nullscope::viewer {

class PictureMarks {
public:
    // Of the scene on the screen, drawn in this size; top, bottom: px that the menu and the status line take. Makes textures where
    // something has changed.
    void show(const Scene& scene, PixelSize size, int top, int bottom);
    float labels_bottom() const;  // of those at the top, in ImGui's units; 0: there are none
    void draw() const;            // behind the panels, in the current frame of Dear ImGui

private:
    Annotations annotations_;
    PixelSize size_{};
    int top_ = 0, bottom_ = 0;
    std::vector<Mark> marks_;
    std::vector<gl::Texture> textures_;
};

// Over a picture that is saved. stokes: as of draw_tick_lines().
void mark_saved_picture(const Scene& scene, const Image<float>& stokes, Image<unsigned char>& picture);

}  // namespace nullscope::viewer
