// One run of nullscope capture: what is to be drawn, checked, and each of its pictures.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "base/result.h"
#include "cli/capture_options.h"
#include "cli/frame_store.h"
#include "command/arguments.h"
#include "command/session.h"
#include "command/shot.h"
#include "scenefile/picture_scene.h"
#include "scenefile/scene_file.h"

namespace nullscope::cli {

// What was asked for, with what a picture recorded.
struct CaptureRun {
    CaptureOptions options;
    OpenedScene opened;
};
// Errors: a scene that cannot be read, a size, options that do not go together.
Result<CaptureRun> capture_run(CaptureOptions options);

struct CaptureJob : Shot {
    Frames frames{};
    std::optional<FrameNames> names{};  // of a sequence's files; a film's pictures have a folder of their own
    SceneFolders folders{}, split_folders{};
    bool traced_tiles = false, computed = false;
};
// Errors: bad input, all that is wrong before OpenGL and files are opened.
Result<CaptureJob> capture_job(const CaptureOptions& options, const OpenedScene& opened);

// What the pictures depend on (cli/frame_store.h).
std::string stamp_of(const CaptureJob& job, const CaptureOptions& options);

// A session that draws these; nothing for the reference. Errors: no OpenGL.
Result<std::optional<Session>> capture_session(const CaptureJob& job, const CaptureOptions& options);
// What the session's renderer is told of a job before its pictures.
void tell_renderer(Session& session, const CaptureJob& job);

// What a picture says of itself. whole: of all frames.
PictureOrigin origin_of(const CaptureJob& job, const CaptureOptions& options, const Exposure& shown, bool with_next,
                        std::optional<int> frame);

// One picture, or two side by side, that is drawn and not yet in its file.
struct DrawnPicture {
    std::string said;               // what it was made by, and its flux where that is known
    std::function<void()> arrive;   // on the session's thread, before it is written: waits for the GPU
    std::function<Status()> write;  // on any thread, while job and options live; empty: it is in its file already
};
// session: null: the reference draws. in_flight: arrive() is called only after the next one was begun.
Result<DrawnPicture> draw_for(const CaptureJob& job, Session* session, const Exposure& shown,
                              const CaptureOptions& options, const std::string& file, std::optional<int> frame,
                              bool in_flight = false);
// And writes it. Returns what is said of it.
Result<std::string> draw_into(const CaptureJob& job, Session* session, const Exposure& shown,
                              const CaptureOptions& options, const std::string& file, std::optional<int> frame);

}  // namespace nullscope::cli
