// Draws the viewer's pictures on a thread of its own, in an OpenGL context that shares textures with the window's: while a program
// is compiled, a sky built or an image read, the window keeps its last picture and its panels answer.
//
// Owners: a job is copied in, a painting moved out; the renderers are the thread's alone. A painting's texture is
// drawn to again only after the one that follows it was taken.
//
// A job may give two pictures: a coarse one first (of fewer pixels, of one ray each, of star images found quickly), if the whole
// one takes long. The coarse one is always finished. The whole one is begun when no newer job has come for a tenth of a second, and
// given up between two bands of rows when one comes: motion is followed, and a view at rest gets its whole picture.
#pragma once
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "viewer/frame_renderer.h"
#include "viewer/loop_trace.h"
#include "viewer/polarisation_numbers.h"
#include "viewer/window.h"

namespace nullscope::viewer {

class Painter {
public:
    // threads: false draws in the window's own context within ask(), as where a second context cannot be had. news: called from
    // the thread when a painting or a time is ready. throws gl::GlError.
    Painter(Window& window, bool threads, std::function<void()> news);

    bool in_background() const { return context_ != nullptr; }
    // Only while not busy() or gives_up(). A painting of the job before that was not taken is dropped.
    void ask(PaintJob job);
    bool busy() const { return locked(busy_); }  // asked, and the last painting of that job not taken yet
    // What is drawn now would make room for a job that comes with a coarse picture.
    bool gives_up() const { return locked(gives_up_); }
    bool at_work() const;  // the thread draws or measures
    PaintProgress progress() const { return locked(progress_); }
    std::string stage_words() const { return locked(stage_words_); }  // FrameRenderer::stage_words()
    std::optional<Painting> take();                                   // if there is one; throws what the thread met
    int drawn_by_caller() const { return drawn_by_caller_; }          // jobs that ask() did itself, its caller waiting

    // Measures what each effect of the scene costs, one after the other, until there is a new job.
    void measure(const Scene& scene, const Method& method);
    std::optional<EffectTimes> take_times();  // if there is more than at the last call

    // Between jobs; a job that comes meanwhile waits for it, some 100 ms with llvmpipe, and the first compiles.
    void measure_polarisation(const Scene& scene, const Method& method);
    // If it is done; nothing within: the scene could not be prepared.
    std::optional<std::optional<PolarisationNumbers>> take_polarisation();

    // Follows an orbit's light between jobs, from the first point; nothing: no more of it.
    void trace_loop(std::optional<LoopOrder> order);
    std::optional<StokesLoop> take_loop();  // its points, if there are more than at the last call

private:
    template <class T>
    T locked(const T& member) const {
        const std::lock_guard lock(mutex_);
        return member;
    }
    void work(const std::stop_token& stop);
    void do_job(FrameRenderer& frame_renderer, const PaintJob& job);
    void do_measure(FrameRenderer& frame_renderer, const PaintJob& order);
    void do_polarisation(FrameRenderer& frame_renderer, const PaintJob& order);
    void try_stages(FrameRenderer& frame_renderer, const PaintJob& job);
    void do_loop(LoopTrace& trace, std::unique_lock<std::mutex>& lock);
    void publish(Painting painting, bool last);
    DrawWatch watch(bool whole_job);
    DrawWatch quiet_watch() const;  // of what nobody waits for
    TexturesInUse textures_in_use() const;
    bool interrupted() const;
    bool goes_on();

    SharedContext context_;  // nullptr: jobs are done within ask()
    std::function<void()> news_;
    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<PaintJob> job_, order_;   // order: of the effects' times, for this scene and method
    std::optional<PaintJob> polarisation_;  // likewise, of these numbers
    std::optional<Painting> painting_;
    std::array<unsigned, 2> shown_{};  // textures of the painting that was taken last
    bool last_ = false;                // painting_ is its job's last
    bool busy_ = false, at_work_ = false, gives_up_ = false;
    PaintProgress progress_;
    std::string stage_words_;
    std::optional<EffectTimes> times_;                           // that were not taken yet
    std::optional<std::optional<PolarisationNumbers>> numbers_;  // likewise
    bool loop_asked_ = false, loop_due_ = false;                 // loop_order_ is new; there are points left
    std::optional<LoopOrder> loop_order_;
    std::optional<StokesLoop> loop_;  // that was not taken yet
    std::exception_ptr failure_;
    int drawn_by_caller_ = 0;
    std::unique_ptr<FrameRenderer> own_;  // without a thread
    LoopTrace own_trace_;                 // likewise
    // Last: ends before what it uses; waits for a driver that compiles, a sky that is built, an image that is read.
    std::jthread thread_;
};

}  // namespace nullscope::viewer
