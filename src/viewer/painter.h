// Draws the viewer's pictures on a thread of its own, in an OpenGL context that shares textures with the window's: while a program
// is compiled, a sky built or an image read, the window keeps its last picture and its panels answer.
//
// Owners: a job is copied in, a painting moved out; the renderer is the thread's alone. A painting's texture is drawn to again
// only after the one that follows it was taken.
#pragma once
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "gl/gl.h"
#include "render/renderer.h"
#include "viewer/window.h"

namespace nullscope::viewer {

struct PaintJob {
    Scene scene;
    Method method;
    bool rays = false;  // ray data instead of a picture
    double adaptation = 1.0;   // Renderer::set_adaptation
};

// What effects cost in the frame on the screen: the picture's time, less that of the scene without the effect.
struct EffectTime {
    Effect effect;
    double ms = 0.0;
};
struct EffectTimes {
    std::vector<EffectTime> effects;
    double picture_ms = 0.0;  // of the whole
    bool complete = false;
};

struct Painting {
    PaintJob job;
    Status ready{Done{}};  // what prepare() said; else there is nothing below
    unsigned texture = 0;  // RGBA8, of the job's size, display-encoded; valid until the next painting but one is asked for
    std::optional<RayFrame> rays;
    double draw_ms = 0.0;  // the picture's, finished
    std::vector<std::string> notes;   // what was done to images
    int programs = 0;      // compiled for pictures until now
    double compile_ms = 0.0 /* of them all, with the driver's own at the first picture */, table_ms = 0.0, rows_ms = 0.0;
};

class Painter {
public:
    // threads: false draws in the window's own context within ask(), as where a second context cannot be had. news: called from
    // the thread when a painting or a time is ready. throws gl::GlError.
    Painter(Window& window, bool threads, std::function<void()> news);
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    bool in_background() const { return context_ != nullptr; }
    void ask(PaintJob job);      // only while not busy()
    bool busy() const;           // asked, and not taken yet
    bool wait(double seconds);   // true if a painting can be taken; infinite: until then
    std::optional<Painting> take();   // throws what the thread met

    // Measures what each effect of the scene costs, one after the other, until there is a new job.
    void measure(const Scene& scene, const Method& method);
    std::optional<EffectTimes> take_times();   // if there is more than at the last call

private:
    struct Workshop;   // what lives in the context
    struct Order {
        Scene scene;
        Method method;
    };
    void work(const std::stop_token& stop);
    void do_job(Workshop& workshop, PaintJob job);
    void do_measure(Workshop& workshop, const Order& order);
    bool interrupted() const;

    std::unique_ptr<SharedContext> context_;   // nullptr: jobs are done within ask()
    std::function<void()> news_;
    mutable std::mutex mutex_;
    std::condition_variable_any wake_, done_;
    std::optional<PaintJob> job_;
    std::optional<Order> order_;
    std::optional<Painting> painting_;
    EffectTimes times_;
    bool times_new_ = false, busy_ = false;
    std::exception_ptr failure_;
    std::unique_ptr<Workshop> own_;   // without a thread
    std::jthread thread_;             // last: ends before what it uses
};

}  // namespace nullscope::viewer
