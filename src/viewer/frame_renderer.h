// What draws the viewer's pictures: renderers and textures of one OpenGL context. All of it belongs to the thread
// whose context it is.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gl/gl.h"
#include "plan/effects.h"
#include "render/renderer.h"
#include "scene/split.h"
#include "studio/effect_watch.h"
#include "studio/motion_size.h"
#include "studio/paint_job.h"
#include "viewer/band_drawing.h"
#include "viewer/small_light.h"
#include "viewer/stage_pick.h"

namespace nullscope::viewer {

struct Painting {
    PaintJob job;
    Status ready{Done{}};                  // what prepare() said; else there is nothing below
    unsigned texture = 0;                  // RGBA8, display-encoded; valid until the painting after it was taken
    unsigned texture_b = 0;                // likewise, of job.side_b; 0: there is none
    int width = 0, height = 0;             // of the texture; of a coarse picture less than the job's
    std::optional<RayFrame> rays, rays_b;  // of the job, and of job.side_b
    Image<float> light;                    // linear, of small_scene(job.scene); empty: not asked for, or there is none
    Image<float> stokes, stokes_b;         // likewise, where they show ticks, of their number: annotate/ticks.h
    double draw_ms = 0.0;                  // the picture's, finished; compiling apart
    std::vector<std::string> notes;        // what was done to images
    int programs = 0;                      // compiled for pictures until now
    double compile_ms = 0.0 /* of them all, with the driver's own at the first rows */, table_ms = 0.0, rows_ms = 0.0;

    bool draft = false;  // with fewer rays or stars than the job's

    bool coarse() const { return draft || width < job.scene.camera.width || height < job.scene.camera.height; }
};

// Of both sides of the painting that is shown, and of the one that waits; 0: none.
using TexturesInUse = std::array<unsigned, 4>;

class FrameRenderer {
public:
    FrameRenderer();

    // How many times smaller than the job's, in each direction, a picture in motion should be to hold the frame rate; 1: as large.
    double coarseness(const PaintJob& job);
    // Whether a picture of one ray a pixel, with light of matter less exact and star images found quickly, is worth its time.
    bool drafts(const PaintJob& job) const;
    bool searches_stars() const {
        return renderer_.searches_stars() || (right_ != nullptr && right_->searches_stars());
    }
    // The job's picture, each side divided by `coarseness`; nothing if it was given up. first: another follows. avoid: textures that are in
    // use.
    std::optional<Painting> picture(const PaintJob& job, double coarseness, bool first, const TexturesInUse& avoid,
                                    const DrawWatch& watch);
    Painting rays(const PaintJob& job);
    // Compiles one of the programs by which further pictures are drawn sooner (Renderer::build_next); false if none is left.
    bool build_next();
    // Draws a small picture in motion, unseen, once for every set of programs: drivers compile what its state asks for at the first draw.
    void warm_up(const PaintJob& job, const TexturesInUse& avoid, const DrawWatch& watch);

    // Whether the job leaves to their times which shaders trace it, and such a scene, as it was drawn last, was not timed on this device.
    bool asks_to_try_stages(const PaintJob& job) const;
    // Times fragment and compute shaders then; whether it did. The next pictures of the kind are drawn by what took less.
    bool try_stages(const PaintJob& job, const DrawWatch& watch);
    // Which shaders trace what was drawn last, and why: a line.
    const std::string& stage_words() const { return stages_.words(); }

    Renderer& renderer() { return renderer_; }
    double& ray_ms() { return ray_ms_; }
    // One for a scene without an effect; its programs stay until it is dropped.
    Renderer& other() { return other_ == nullptr ? *(other_ = std::make_unique<Renderer>()) : *other_; }
    void drop_other() { other_.reset(); }

private:
    bool renderers_build_next();  // without side B's
    bool is_warm(const PaintJob& job) const;
    Scene in_motion(const PaintJob& job) const;
    double ray_picture_ms(const PaintJob& job) const;
    double quiet_ray_ms(const PaintJob& job) const;
    std::optional<Painting> one_picture(const PaintJob& job, double coarseness, bool first, const TexturesInUse& avoid,
                                        const DrawWatch& watch);
    Status prepare(const Scene& scene, const PaintJob& job, const StarField::Search& search);
    // at_once: in one band.
    std::optional<DrawTimes> draw(const gl::Target& target, bool at_once, const DrawWatch& watch);
    const gl::Target& target(int width, int height, const TexturesInUse& avoid);
    Image<float> tick_stokes(const Scene& scene);
    void add_facts(Painting& painting);

    Renderer renderer_;
    std::unique_ptr<Renderer> right_;        // of a split screen
    std::unique_ptr<FrameRenderer> side_b_;  // of comparisons
    SmallLight light_;                       // while jobs ask for it
    std::unique_ptr<Renderer> other_;        // while effects are measured
    std::optional<Halves> split_;            // that is prepared
    std::array<gl::Target, 2> halves_;
    std::array<double, 2> half_ray_ms_{};
    // Shown, waiting to be shown, drawn to; one more, as coarse and whole take turns.
    std::array<gl::Target, 4> targets_;
    double ray_ms_ = 0.0;  // of scenes with these effects and this method
    EffectSet effects_;
    Method method_;
    StageWish stage_ = StageWish::kAuto;  // likewise
    bool computes_ = false;               // likewise
    StagePick stages_;
    double picture_ms_ = 0.0;    // the last picture's, a ray; 0: not known
    double quiet_ray_ms_ = 0.0;  // likewise, of one that nothing else was drawn beside
    MotionSize motion_size_;
    double coarseness_ = 1.0;  // of the last picture in motion
    double compile_ms_ = 0.0;
    std::optional<std::pair<EffectSet, Method>> warm_;  // of which all programs of motion are there
};

}  // namespace nullscope::viewer
