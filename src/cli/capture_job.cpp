#include "cli/capture_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "base/text.h"
#include "cli/cube_faces.h"
#include "cli/film.h"
#include "cli/option_rules.h"
#include "cli/picture_file.h"
#include "cli/recorded_options.h"
#include "command/band_pictures.h"
#include "command/derivative_channels.h"
#include "command/stereo_capture.h"
#include "compare/stokes_measures.h"
#include "observer/path.h"
#include "plan/dump_window.h"
#include "plan/shutter.h"
#include "render/picture_bands.h"
#include "scene/medium_bands.h"
#include "scene/medium_dumps.h"
#include "scene/projection.h"
#include "scene/split.h"
#include "scene/stereo.h"
#include "shaderlib/passes.h"
#include "telescope/flux.h"
#include "version/version.h"

namespace nullscope::cli {
namespace {

Result<Frames> frames_of(const CaptureOptions& options, const CameraPath* path) {
    if (options.to_film() && path == nullptr && (options.time_step == 0 || options.frames.empty()))
        return bad_input("a film needs a scene with a [path], or --time-step and --frames",
                         fmt::format("-o names that end in {}", format_endings()));
    if (options.to_film() && !have_ffmpeg())
        return failed("ffmpeg is not installed, which films need; without it: -o NAME%05d.png and --frames");
    const bool sequence = !options.to_film() && names_frames(options.output);
    if (options.frames.empty() && sequence && path == nullptr)
        return bad_input(fmt::format("-o {}: a place for the frame's number, but which frames?", options.output),
                         "--frames A:B");
    if (options.frames.empty()) return options.to_film() || sequence ? Frames{0, path->frames()} : Frames{};
    auto frames = parse_frames(options.frames);
    if (frames && path != nullptr && frames->end > path->frames())
        return bad_input(fmt::format("--frames {}: the path has {} frames", options.frames, path->frames()),
                         fmt::format("0:{}", path->frames()));
    return frames;
}

// Of the frame after this one; nothing after a path's last, or after the last dump of its matter.
std::optional<Scene> next_scene(const CaptureJob& job, double time_step, int frame) {
    if (job.path ? frame + 1 > job.path->last() : time_step == 0) return {};
    Scene next = scene_at(job, time_step, frame + 1);
    if (has_dumps(next) && medium_time_fault(next, next.time)) return {};
    return next;
}

// The scene beside it: of a file, or of the picture that the first is of.
Result<OpenedScene> split_of(const CaptureOptions& options, const OpenedScene& opened) {
    if (!options.split_is_recorded) return open_scene(options.split);
    TRY(scene, scene_of_words(opened.words, kSplitWord, options.scene, options.listener.note));
    return OpenedScene{std::move(*scene), opened.folders};
}

}  // namespace

PictureOrigin origin_of(const CaptureJob& job, const CaptureOptions& options, const Exposure& shown, bool with_next,
                        std::optional<int> frame) {
    const bool whole = !shown.sub_frames.empty() || with_next;
    PictureOrigin origin{whole ? job.scene : shown.scene, job.folders, job.split, job.split_folders};
    origin.frame = frame, origin.times = times_of(shown);
    const bool disc = job.scene.disc || (job.split && job.split->disc);
    origin.options = recorded_options(
        {options, job.method, disc ? std::optional(job.traced_tiles) : std::nullopt, frame, whole, job.time_frame},
        origin.scene);
    return origin;
}

Result<DrawnPicture> draw_for(const CaptureJob& job, Session* session, const Exposure& shown,
                              const CaptureOptions& options, const std::string& file, std::optional<int> frame,
                              bool in_flight) {
    const Scene& scene = shown.scene;
    const std::optional<Scene> next =
        options.layers && frame ? next_scene(job, options.time_step, *frame) : std::nullopt;
    PictureOrigin origin = origin_of(job, options, shown, next.has_value(), frame);
    const bool all_round = scene.camera.stereo == Stereo::kAllRound;
    if (session != nullptr && options.to_exr() && options.to_linear_light() && !options.raydata && !options.layers &&
        options.st_map.empty() && !job.split && !scene.split && !all_round && !names_faces(options) &&
        (options.half || (is_drawn_in_bands(scene) && !has_bands(scene)))) {
        TRY(beside, side_by_side_pictures(shown));
        TRY(said, capture_large_exr(*session, origin, *beside, options, file));
        return DrawnPicture{std::move(*said), {}, {}};
    }
    const auto drawn = [&](const Exposure& one) {
        DrawOptions drawing = options.drawing();
        drawing.in_bands = drawing.in_bands || has_bands(scene);
        drawing.in_flight = in_flight && !names_faces(options);
        return draw_shot(job, session, one, drawing, !options.plain, next ? &*next : nullptr);
    };
    if (names_faces(options)) {
        TRY(said, draw_faces(origin, shown, options, drawn));
        return DrawnPicture{std::move(*said), {}, {}};
    }
    TRY(captured, drawn(shown));
    const bool several = job.split || scene.split || scene.camera.stereo != Stereo::kOff;
    const auto flux = captured->bands.empty() ? flux_unit(scene, several) : std::nullopt;
    std::string said = captured->made_by;
    if (const std::string words = band_words(scene, several, captured->bands); !words.empty()) said += ", " + words;
    if (flux && options.to_linear_light() && options.st_map.empty()) said += ", " + flux_words(captured->linear, *flux);
    if (!captured->stokes.empty()) {
        const auto [x, y] = line_of_sight(scene.camera);
        said += ", " + words_of(stokes_measures(captured->stokes, x, y));
    }
    const auto kept = std::make_shared<Captured>(std::move(*captured));  // functions are copied
    return DrawnPicture{
        std::move(said), [kept] { kept->arrive(); },
        [file, origin = std::move(origin), kept, &options] { return write_picture(file, origin, *kept, options); }};
}

Result<std::string> draw_into(const CaptureJob& job, Session* session, const Exposure& shown,
                              const CaptureOptions& options, const std::string& file, std::optional<int> frame) {
    TRY(drawn, draw_for(job, session, shown, options, file, frame));
    if (drawn->arrive) drawn->arrive();
    if (drawn->write) {
        TRY(written, drawn->write());
    }
    return std::move(drawn->said);
}

Result<CaptureJob> capture_job(const CaptureOptions& options, const OpenedScene& opened) {
    CaptureJob job{{opened.scene}};
    job.folders = opened.folders;
    if (job.scene.path) {
        TRY(made, CameraPath::make(job.scene));
        job.path = std::move(*made);
    }
    TRY(good, check_output(options));
    TRY(agree, check_rules(options, job.scene));
    if (!options.derivatives.empty()) {
        TRY(there, check_derivatives(job.scene, split(options.derivatives, ',')));
    }
    if (!options.split.empty()) {
        TRY(other, split_of(options, opened));
        job.split = std::move(other->scene);
        job.split_folders = std::move(other->folders);
        job.scene.split_labels = {job.scene.split_labels.shown};  // the file's own are of its own [split]
        if (options.samples) job.split->picture.samples = job.scene.picture.samples;
    }
    TRY(seen, check_stereo(job.scene, options.drawing(), !options.split.empty()));
    TRY(faces, check_faces(job.scene, options));
    if (job.path && job.path->falls() && options.time_step != 0)
        return bad_input("--time-step: the fall of the camera sets the scene's time",
                         "scenes whose path.kind is not fall");
    if (options.time_step != 0 && options.to_one_picture() && job.scene.picture.shutter <= 0.0)
        return bad_input("--time-step: no effect on one picture without picture.shutter",
                         "with --frames A:B, or a scene with picture.shutter");
    TRY(frames, frames_of(options, job.path ? &*job.path : nullptr));
    job.frames = *frames;
    if (job.path) {
        TRY(eyes, check_stereo_frames(*job.path, job.scene, job.frames.first, job.frames.end));
    }
    if (job.path && options.time_frame)
        return bad_input("--time-frame: a path begins in frame 0", "scenes without a [path]");
    if (!job.path) job.time_frame = options.time_frame.value_or(job.frames.first);
    TRY(there, check_times(job, options.time_step, *frames, options.scene));
    if (!options.to_film() && !options.one_frame && (!options.frames.empty() || names_frames(options.output))) {
        TRY(names, FrameNames::parse(options.output));
        job.names = std::move(*names);
    }
    if (options.renderer != "gl") return job;
    TRY(method, chosen_method(options.method, options.max_error, job.scene, options.listener));
    job.method = *method;
    job.computed = options.stage == "compute";
    job.traced_tiles =
        options.tiles == "auto" ? worth_tiles(job, job.frames.end - job.frames.first) : options.tiles == "traced";
    return job;
}

Result<CaptureRun> capture_run(CaptureOptions options) {
    if (!options.ffmpeg.empty() && (!options.to_film() || !options.ffmpeg.front().starts_with('-')))
        return bad_input(
            fmt::format("{}: not expected here; after -- are ffmpeg's options for a film", options.ffmpeg.front()));
    const Note note = options.listener.note;
    TRY(overrides, parse_overrides(options.set));
    TRY(opened, open_scene(options.scene, note, *overrides));
    TRY(whole, with_recorded(std::move(options), *opened, note));
    TRY(scene, sized(std::move(opened->scene), whole->size));
    if (whole->time) scene->time = *whole->time;
    if (whole->samples && whole->renderer == "gl") scene->picture.samples = *whole->samples;
    opened->scene = std::move(*scene);
    return CaptureRun{std::move(*whole), std::move(*opened)};
}

std::string stamp_of(const CaptureJob& job, const CaptureOptions& options) {
    const double first_time = job.scene.time - job.time_frame * options.time_step;
    return frame_stamp(
        {job.scene, job.split ? &*job.split : nullptr, options, method_name(job.method), first_time, kVersionText});
}

void tell_renderer(Session& session, const CaptureJob& job) {
    session.renderer->set_method(job.method);
    session.renderer->compute(job.computed);
    session.renderer->limit_tiles(job.traced_tiles ? Tiles::kTraced : Tiles::kBodies);
}

Result<std::optional<Session>> capture_session(const CaptureJob& job, const CaptureOptions& options) {
    if (options.renderer != "gl") return std::optional<Session>();
    TRY(session, open_session(options.context));
    tell_renderer(*session, job);
    return std::optional(std::move(*session));
}

}  // namespace nullscope::cli
