// What draws the viewer's pictures: renderers and textures of one OpenGL context. All of it belongs to the thread
// whose context it is.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "gl/gl.h"
#include "render/renderer.h"
#include "scene/split.h"
#include "viewer/paint_job.h"

namespace nullscope::viewer {

// How long the dearest row of the last picture took, by which the next is cut into bands.
struct Pace {
    double pixel_ms = 0.0;  // 0: not known
};

// What a picture is told and asked while it is drawn.
struct DrawWatch {
    std::function<bool()> give_up;  // asked between bands
    std::function<void(const PaintProgress&)> tell;
};

struct DrawTimes {
    double draw_ms = 0.0, compile_ms = 0.0;
};

// Draws what is prepared; nothing if it was given up.
std::optional<DrawTimes> draw_in_bands(Renderer& renderer, const gl::Target& target, Pace& pace,
                                       const DrawWatch& watch);

class Workshop {
public:
    Workshop() { renderer_.keep_finer_sky(); }

    // How many times smaller than the job's, in each direction, a coarse picture should be; 1: none is worth its time.
    int coarseness(const PaintJob& job) const;
    // The job's picture, each side divided by `coarseness`; nothing if it was given up. avoid: textures that are in
    // use.
    std::optional<Painting> picture(const PaintJob& job, int coarseness, const std::array<unsigned, 2>& avoid,
                                    const DrawWatch& watch);
    Painting rays(const PaintJob& job);

    Renderer& renderer() { return renderer_; }
    Pace& pace() { return pace_; }
    // One for a scene without an effect; its programs stay until it is dropped.
    Renderer& other() { return other_ == nullptr ? *(other_ = std::make_unique<Renderer>()) : *other_; }
    void drop_other() { other_.reset(); }

private:
    Status prepare(const Scene& scene, const PaintJob& job);
    std::optional<DrawTimes> draw(const gl::Target& target, const DrawWatch& watch);
    const gl::Target& target(int width, int height, const std::array<unsigned, 2>& avoid);
    void add_facts(Painting& painting);

    Renderer renderer_;
    std::unique_ptr<Renderer> right_;  // of a split screen
    std::unique_ptr<Renderer> other_;  // while effects are measured
    std::optional<Halves> split_;      // that is prepared
    std::array<gl::Target, 2> halves_;
    std::array<Pace, 2> half_paces_;
    // Shown, waiting to be shown, drawn to; one more, as coarse and whole take turns.
    std::array<gl::Target, 4> targets_;
    Pace pace_;  // of scenes with these effects and this method
    EffectSet effects_;
    Method method_;
    double picture_ms_ = 0.0;  // the last picture's, a pixel; 0: not known
    double compile_ms_ = 0.0;
};

}  // namespace nullscope::viewer
