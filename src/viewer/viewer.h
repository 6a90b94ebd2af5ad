// The viewer itself: window, panels, input and renderer, and the loop that draws when there is something to draw.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "gl/gl.h"
#include "studio/adaptation.h"
#include "studio/comparison.h"
#include "studio/effect_watch.h"
#include "studio/flight.h"
#include "studio/history.h"
#include "studio/message.h"
#include "studio/method_choice.h"
#include "studio/pace.h"
#include "studio/picture_rate.h"
#include "studio/user_files.h"
#include "viewer/controls.h"
#include "viewer/gallery.h"
#include "viewer/menu.h"
#include "viewer/panel.h"
#include "viewer/panel_system.h"
#include "viewer/panels.h"
#include "viewer/picture_cover.h"
#include "viewer/polarisation_numbers.h"
#include "viewer/scene_files.h"
#include "viewer/shown_picture.h"
#include "viewer/viewer_logs.h"

namespace nullscope::viewer {

struct ViewerOptions {
    std::string scene;              // file or name; "": first-light, with the gallery before it
    std::optional<PixelSize> size;  // that of the last time, or the scene's, fitted to the screen
    bool gallery = false;           // before the scene
    std::string screenshot;         // written after after_frames frames, panels included; then the viewer ends
    int after_frames = 0;           // 0: run until closed
    bool hidden = false;
    bool one_context = false;  // draws where the panels are drawn, as where a second context cannot be had
    int coarse = 1;            // rendered at 1/N of the window's resolution
    StageWish stage = StageWish::kAuto;
    std::string turns;   // file for what the loop does (viewer/loop_log.h), or nothing
    std::string layout;  // file for where the panels' words are (viewer/layout_log.h), or nothing
};

class Viewer {
public:
    // Errors: bad scene, no display, no OpenGL 3.3. throws gl::GlError.
    static Result<std::unique_ptr<Viewer>> open(const ViewerOptions& options);
    Status run();

private:
    explicit Viewer(const ViewerOptions& options) : options_(options) {}
    static constexpr const char* kTitle = " - nullscope";  // of the window, behind the scene's name
    Status open_first();                                   // scene or tour
    Status save_screenshot();
    bool step();                              // one turn of the loop: true if a frame was drawn
    float overlays(float top, float bottom);  // where they end at the picture's top
    void left_corner(float bottom);           // of the picture
    bool panels(const Input& input);          // true if they changed the scene
    bool follow_panels();                     // likewise
    FrameFacts frame_facts() const;
    bool move(const Input& input, double dt);  // by input, fall and clock: true if something moved
    void follow_changes(bool changed);
    void follow_times();                                        // messages that end, progress that goes on
    double wait_time() const;                                   // for events; 0: do not wait
    bool patient() const { return options_.after_frames > 0; }  // every frame of such a run is of the scene as it is
    bool adapting() const;                                      // pictures are due until exposure has come to rest
    bool in_motion() const;                                     // without a hand: the next picture is due already
    bool settled() const;                                       // the picture is whole, and of the scene as it is
    bool fit_to_window();                                       // true if the picture's size changed
    void ask();   // for what is due: a picture of view_, ray data or the effects' times
    bool take();  // what was asked for if it is there: true if there is something new to show
    void show_frame(Painting painting);
    void refuse(const Painting& painting);
    void measure_effects(bool still);
    void measure_polarisation(bool still);
    void follow_watches();  // of panels: the loop of Q and U, what changes
    void probe(const Input& input);
    void log_rest();
    void draw(unsigned framebuffer, PixelSize to);
    void draw_marks();
    void draw_over_sides(float top, float bottom);  // errors, critical curve, divider
    void drag_divider(const Input& input);
    bool shows_orders(std::size_t side) const;  // that side has image orders, and they are switched on
    void present();
    void save_picture();  // as soon as it is whole
    // viewer_commands.cpp; true if the scene changed
    bool handle_keys(const Input& input);
    bool perform(const Action& action);
    bool step_history(bool back);
    bool paste();
    bool paste_scene(const std::string& line);
    bool add(const std::string& section);
    void pick(double x, double y);  // the body there
    void close_topmost();
    void toggle_potential();
    bool compare();  // or its end
    void navigate();
    void copy_view();
    void fall_freely();  // or a pause of it
    void record();       // or its end
    void leave_scene();  // for another: what was flown and recorded can be brought back
    // viewer_files.cpp
    bool open_file(const std::string& file_or_name);  // true if the scene changed
    bool open_dropped(const Input& input);
    bool open_chosen();                        // with the desktop's dialog
    std::filesystem::path usual_path() const;  // of a saved scene
    void save_scene();
    void save_scene_to(const std::filesystem::path& path);
    void save_scene_as(const std::filesystem::path& path);
    void follow_path();    // before the timeline is drawn or moved
    void sample_flight();  // while one is recorded
    void follow_film();
    void keep_settings();
    // viewer_tours.cpp; true if the scene changed
    Status start_tour(const std::filesystem::path& file);
    bool open_tour(const std::filesystem::path& file);
    bool step_tour(int ahead);
    bool tour_panels(float left, float bottom);
    bool offer_left_scene();  // true if it was taken
    void say(const std::string& message);
    // viewer_bookmarks.cpp; true if the scene changed
    Image<unsigned char> small_picture() const;
    void keep_bookmark();
    bool open_bookmark(const std::string& file);
    bool take_camera(const std::string& file);
    bool follow_bookmarks();

    ViewerOptions options_;
    ViewState view_;
    Controls controls_;
    std::unique_ptr<Window> window_;  // the context: outlives what is below
    std::unique_ptr<PanelSystem> panel_system_;
    std::unique_ptr<Painter> painter_;
    gl::Info info_;
    PixelSize size_;  // of the picture
    ShownPicture shown_;
    AskedPicture asked_;
    DuePicture due_;
    PictureCover cover_;
    PaintProgress progress_;        // that is shown
    std::optional<Error> refusal_;  // of the first scene: there is nothing to show
    MethodTable methods_;
    EffectWatch effects_;
    PolarisationWatch polarisation_;
    Adaptation adaptation_;
    PictureRate rate_;
    Pace pace_;
    bool traces_loop_ = false;  // the painter was asked for one
    bool moving_ = false;       // something did, in this turn of the loop
    Message message_;
    double escaped_at_ = -1e9;  // when Escape had nothing to close: pressed again, it quits
    ViewerLogs logs_;
    History history_;
    Flight flight_;
    Gallery gallery_;
    PanelParts panels_;
    SceneFiles files_;
    KeptSettings settings_;
};

}  // namespace nullscope::viewer
