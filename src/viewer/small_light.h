// The linear light of a view in few pixels, beside the picture that is displayed: what telescopes measure is found in it.
#pragma once
#include <memory>

#include "image/image.h"
#include "render/renderer.h"
#include "studio/paint_job.h"

namespace nullscope::viewer {

// The same view, `side` px at its longest or as large as it is.
Scene in_fewer_pixels(Scene scene, int side);

// The job's scene in the size in which its light is drawn: `side` px at its longest.
Scene small_scene(const Scene& scene, int side);

// Belongs to the thread whose context it is.
class SmallLight {
public:
    // RGB, rows from the top; empty where the view cannot be drawn: the picture says why. By programs and tables of its own, which stay until
    // drop().
    Image<float> draw(const PaintJob& job, int side, const StarField::Search& search);
    void drop() { renderer_.reset(); }

private:
    std::unique_ptr<Renderer> renderer_;
};

}  // namespace nullscope::viewer
