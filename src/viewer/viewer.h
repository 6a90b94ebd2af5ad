// The viewer itself: window, panels, input and renderer, and the loop that draws when there is something to draw.
#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>

#include "gl/gl.h"
#include "studio/autosave.h"
#include "studio/comparison.h"
#include "studio/history.h"
#include "studio/user_files.h"
#include "viewer/bookmark_panel.h"
#include "viewer/controls.h"
#include "viewer/divider.h"
#include "viewer/file_dialog.h"
#include "viewer/frame_accuracy.h"
#include "viewer/gallery.h"
#include "viewer/layout_log.h"
#include "viewer/loop_log.h"
#include "viewer/menu.h"
#include "viewer/order_overlay.h"
#include "viewer/panel_system.h"
#include "viewer/panels.h"
#include "viewer/picture_marks.h"
#include "viewer/probe.h"
#include "viewer/save_as.h"
#include "viewer/scene_editor.h"
#include "viewer/timeline_panel.h"
#include "viewer/tour_panel.h"

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
    std::string turns;         // file for what the loop does (viewer/loop_log.h), or nothing
    std::string layout;        // file for where the panels' words are (viewer/layout_log.h), or nothing
};

class Viewer {
public:
    // Errors: bad scene, no display, no OpenGL 3.3. throws gl::GlError.
    static Result<std::unique_ptr<Viewer>> open(const ViewerOptions& options);
    Status run();

private:
    explicit Viewer(const ViewerOptions& options) : options_(options) {}
    static constexpr const char* kTitle = " - nullscope";  // of the window, behind the scene's name
    static constexpr int kSettlingFrames =
        3;                // panels answer an event a frame later, and take another to find their size
    Status open_first();  // scene or tour
    Status save_screenshot();
    bool step();                               // one turn of the loop: true if a frame was drawn
    float overlays(float top, float bottom);   // where they end at the picture's top
    void left_corner(float bottom);            // of the picture
    bool panels(const Input& input);           // true if they changed the scene
    bool move(const Input& input, double dt);  // by input, fall and clock: true if something moved
    void follow_changes(bool changed);
    void follow_times();                                        // messages that end, progress that goes on
    double wait_time() const;                                   // for events; 0: do not wait
    bool patient() const { return options_.after_frames > 0; }  // every frame of such a run is of the scene as it is
    bool adapting() const;                                      // pictures are due until exposure has come to rest
    bool in_motion() const;                                     // without a hand: the next picture is due already
    bool settled() const;                                       // the picture is whole, and of the scene as it is
    double elapsed();                                           // since the last step, for motion
    bool fit_to_window();                                       // true if the picture's size changed
    void ask();   // for what is due: a picture of view_, ray data or the effects' times
    bool take();  // what was asked for if it is there: true if there is something new to show
    void show_frame(Painting painting);
    void refuse(const Painting& painting);
    void measure_effects(bool still);
    void probe(const Input& input);
    double adaptation(const Scene& scene);  // what share of its way exposure goes in the next picture
    void log_rest();
    void draw(unsigned framebuffer, PixelSize to);
    void draw_marks();
    void draw_over_sides(float top, float bottom);  // errors, critical curve, divider
    void drag_divider(const Input& input);
    const PaintJob* shown_side_b() const { return picture_.texture_b != 0 ? picture_.job.side_b.get() : nullptr; }
    const PaintJob* shown_side(std::size_t side) const { return side == 0 ? &picture_.job : shown_side_b(); }
    bool shows_orders(std::size_t side) const;  // that side has image orders, and they are switched on
    bool orders_at_work() const { return std::ranges::any_of(orders_, &OrderOverlay::at_work); }
    void present();
    void measure_rate();
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
    const std::vector<TourInfo>& tours();  // that ship, read once
    bool offer_left_scene();               // true if it was taken
    void say(const std::string& message);
    // viewer_bookmarks.cpp; true if the scene changed
    Image<unsigned char> small_picture() const;
    void keep_bookmark();
    bool open_bookmark(const std::string& file);
    bool take_camera(const std::string& file);
    bool draw_bookmarks(float bottom, bool escape);

    ViewerOptions options_;
    ViewState view_;
    ViewState asked_, shown_;  // as it was when a picture was asked for; of the last that could be prepared
    Controls controls_;
    std::unique_ptr<Window> window_;  // the context: outlives what is below
    std::unique_ptr<PanelSystem> panel_system_;
    std::unique_ptr<Painter> painter_;
    Painting picture_;              // that is shown
    int pictures_ = 0;              // until now
    bool picture_due_ = true;       // view_ has changed since the last was asked for
    bool error_stays_ = false;      // view_.error is of the last change, which was undone: until the next one
    bool coarse_wanted_ = true;     // a picture soon rather than a whole one: the user moves it
    bool save_due_ = false;         // F12, while the picture was not whole
    std::optional<Error> refusal_;  // of the first scene: there is nothing to show
    gl::Info info_;
    EffectTimes effect_times_;
    double changed_at_ = 0.0;  // what the effects' times depend on
    bool times_asked_ = false;
    LoopLog log_;
    LayoutLog layout_log_;
    int last_key_ = 0;
    PixelSize size_;                        // of the picture
    std::vector<MeasuredMethod> measured_;  // the frontier that ships
    std::string not_measured_;              // why it could not be read, or nothing
    MethodChoice choice_, asked_choice_;    // of the picture that is shown, of the one asked for
    std::unique_ptr<FrameAccuracy> accuracy_;
    std::array<OrderOverlay, 2> orders_;  // of both sides
    Probe probe_;
    History history_;
    Gallery gallery_;
    FileDialog file_dialog_;
    SceneEditor editor_;
    float strips_top_ = 0.0f;  // of timeline, bookmarks and status line at the window's bottom, in the last frame
    SaveAs save_as_;
    Autosave autosave_;
    Timeline timeline_;
    TimelinePanel timeline_panel_;
    FilmExport film_;
    Bookmarks bookmarks_{state_folder().empty() ? state_folder() : state_folder() / "bookmarks"};
    BookmarkPanel bookmark_panel_;
    bool bookmark_due_ = false;  // Ctrl+B, while the picture was not whole
    TourPanel tour_;
    std::vector<TourInfo> tours_;                // tours()
    std::string timeline_source_;                // the scene that timeline_ knows
    double sampled_at_ = 0.0;                    // s: of the record
    std::optional<std::filesystem::path> left_;  // scene of a viewer that did not end as it should
    Settings settings_, kept_settings_;          // as they are now, and in their file
    double escaped_at_ = -1e9;                   // when Escape had nothing to close: pressed again, it quits
    PictureMarks marks_;
    Divider divider_;
    std::pair<std::string, std::string> side_words_;  // of the picture that is shown
    std::string zoom_words_;                          // likewise; of no zoom empty
    double adapted_at_ = 0.0;                         // s: automatic exposure follows like an eye,
    double exposure_left_ = 0.0;                      // what share of its way is still before it
    std::string message_;
    double message_until_ = 0.0;
    int frames_ = 0, frames_due_ = 3;
    bool moving_ = false, waited_ = true;
    double stepped_at_ = 0.0, drawn_at_ = 0.0, shown_at_ = 0.0, rate_shown_at_ = 0.0, asked_at_ = 0.0;
    // When the input came that waited longest: for the next picture, for the one asked for, for the one to be shown for the first time.
    double turn_began_at_ = 0.0, due_at_ = 0.0, asked_due_at_ = 0.0;
    std::optional<double> news_due_at_;
    PaintProgress progress_;  // that is shown
    double picture_ms_shown_ = 0.0, frame_s_ = 0.0, fps_shown_ = 0.0;
};

}  // namespace nullscope::viewer
