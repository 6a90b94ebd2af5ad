// nullscope capture: a picture of a scene in a file.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "cli/capture.h"
#include "cli/command.h"
#include "cli/cube_faces.h"
#include "cli/film.h"
#include "cli/frame_store.h"
#include "cli/option_rules.h"
#include "cli/picture_file.h"
#include "cli/recorded_options.h"
#include "cli/workers.h"
#include "command/arguments.h"
#include "command/band_pictures.h"
#include "command/flux.h"
#include "command/shot.h"
#include "command/stereo_capture.h"
#include "compare/stokes_measures.h"
#include "image/picture_texts.h"
#include "observer/path.h"
#include "plan/dump_window.h"
#include "plan/shutter.h"
#include "render/picture_bands.h"
#include "scene/medium_bands.h"
#include "scene/medium_dumps.h"
#include "scene/projection.h"
#include "scene/split.h"
#include "scene/stereo.h"
#include "scenefile/picture_scene.h"
#include "scenefile/scene_file.h"
#include "shaderlib/passes.h"
#include "version/version.h"

namespace nullscope::cli {
namespace {

std::string film_folder(const CaptureOptions& options) { return options.output + ".frames"; }

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

Status dump_shader(const Scene& scene, const CaptureOptions& options) {
    if (options.renderer == "reference")
        return bad_input("--dump-shader: the reference has none", "with --renderer gl");
    TRY(method, chosen_method(options.method, options.max_error, scene, options.listener));
    const EffectSet effects = effect_set(required_effects(scene));
    for (const Pass& pass : passes(effects, Output::kDisplay))
        fmt::print("{}", pass_text(pass, effects, *method, scene.spacetime.metric, body_text(scene, effects)));
    return Done{};
}

// What is to be drawn, checked.
struct Job : Shot {
    Frames frames{};
    std::optional<FrameNames> names{};  // of a sequence's files; a film's pictures have a folder of their own
    SceneFolders folders{}, split_folders{};
    bool traced_tiles = false;
};

// Of the frame after this one; nothing after a path's last, or after the last dump of its matter.
std::optional<Scene> next_scene(const Job& job, double time_step, int frame) {
    if (job.path ? frame + 1 >= job.path->frames() : time_step == 0) return {};
    Scene next = scene_at(job, time_step, frame + 1);
    if (has_dumps(next) && medium_time_fault(next, next.time)) return {};
    return next;
}

// Says once that bright points leave dots.
void say_dots(const Job& job, double time_step) {
    int worst = 0, most = 0;
    for (int frame = job.frames.first; frame < job.frames.end; ++frame)
        if (const int smooth = smooth_sub_frames(exposure_in(job, time_step, frame)); smooth > most)
            worst = frame, most = smooth;
    const int given = job.scene.picture.sub_frames;
    if (most > given)
        fmt::print(stderr,
                   "picture.sub_frames: in frame {} the camera turns by {:.1f} px from one to the next, bright points "
                   "leave dots; {} would leave none in any frame\n",
                   worst, kSmoothStep_px * most / given, most);
}

// Says once where time runs backwards between keys that do not: a key without a time has that of the one before.
void say_backwards(const Job& job) {
    if (!job.path || job.path->falls() ||
        !std::ranges::is_sorted(job.scene.path->keys, {}, [](const PathKey& key) { return key.time; }))
        return;
    for (int frame = job.frames.first; frame + 1 < job.frames.end; ++frame)
        if (job.path->clock(frame + 1) < job.path->clock(frame)) {
            fmt::print(stderr, "path.key: time runs backwards from frame {} on; give each key its time, evenly\n",
                       frame);
            return;
        }
}

PictureOrigin origin_of(const Job& job, const CaptureOptions& options, const Exposure& shown, bool with_next,
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

// One picture, or two side by side, into a file. Returns what it was made by, and its flux where that is known.
Result<std::string> draw(const Job& job, Session* session, const Exposure& shown, const CaptureOptions& options,
                         const std::string& file, std::optional<int> frame) {
    const Scene& scene = shown.scene;
    const std::optional<Scene> next =
        options.layers && frame ? next_scene(job, options.time_step, *frame) : std::nullopt;
    const PictureOrigin origin = origin_of(job, options, shown, next.has_value(), frame);
    const bool all_round = scene.camera.stereo == Stereo::kAllRound;
    if (session != nullptr && options.to_exr() && options.to_linear_light() && !options.raydata && !options.layers &&
        options.st_map.empty() && !job.split && !scene.split && !all_round && !names_faces(options) &&
        (options.half || (is_drawn_in_bands(scene) && !has_bands(scene)))) {
        TRY(beside, side_by_side_pictures(shown));
        return capture_large_exr(*session, origin, *beside, options, file);
    }
    const auto drawn = [&](const Exposure& one) {
        DrawOptions drawing = options.drawing();
        drawing.in_bands = drawing.in_bands || has_bands(scene);
        return draw_shot(job, session, one, drawing, !options.plain, next ? &*next : nullptr);
    };
    if (names_faces(options)) return draw_faces(origin, shown, options, drawn);
    TRY(captured, drawn(shown));
    TRY(written, write_picture(file, origin, *captured, options));
    const bool several = job.split || scene.split || scene.camera.stereo != Stereo::kOff;
    const auto flux = captured->bands.empty() ? flux_unit(scene, several) : std::nullopt;
    std::string said = captured->made_by;
    if (const std::string words = band_words(scene, several, captured->bands); !words.empty()) said += ", " + words;
    if (flux && options.to_linear_light() && options.st_map.empty()) said += ", " + flux_words(captured->linear, *flux);
    if (!captured->stokes.empty()) {
        const auto [x, y] = line_of_sight(scene.camera);
        said += ", " + words_of(stokes_measures(captured->stokes, x, y));
    }
    return said;
}

// The scene beside it: of a file, or of the picture that the first is of.
Result<OpenedScene> split_of(const CaptureOptions& options, const OpenedScene& opened) {
    if (!options.split_is_recorded) return open_scene(options.split);
    TRY(scene, scene_of_words(opened.words, kSplitWord, options.scene, options.listener.note));
    return OpenedScene{std::move(*scene), opened.folders};
}

Result<Job> job_of(const CaptureOptions& options, const OpenedScene& opened) {
    Job job{{opened.scene}};
    job.folders = opened.folders;
    if (job.scene.path) {
        TRY(made, CameraPath::make(job.scene));
        job.path = std::move(*made);
    }
    TRY(good, check_output(options));
    TRY(agree, check_rules(options, job.scene));
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
    job.traced_tiles =
        options.tiles == "auto" ? worth_tiles(job, job.frames.end - job.frames.first) : options.tiles == "traced";
    return job;
}

std::string stamp_of(const Job& job, const CaptureOptions& options) {
    const double first_time = job.scene.time - job.time_frame * options.time_step;
    return frame_stamp(
        {job.scene, job.split ? &*job.split : nullptr, options, method_name(job.method), first_time, kVersionText});
}

// Where the pictures of a film or a sequence go, and which of them are there. Nothing: one picture.
Result<std::unique_ptr<FrameStore>> store_of(const Job& job, const CaptureOptions& options) {
    if (!options.to_film() && !job.names) return std::unique_ptr<FrameStore>();
    const std::string stamp = stamp_of(job, options);
    return options.to_film() ? FrameStore::open_film(film_folder(options), stamp)
                             : FrameStore::open_sequence(*job.names, stamp, options.resume);
}

// Draws a frame unless the store has it. False: another run, or worker, is drawing it.
Result<bool> draw_frame(const Job& job, Session* session, const CaptureOptions& options, FrameStore* store,
                        const FrameWatch& watch, int frame, bool wait) {
    const std::string file = store != nullptr ? store->file(frame) : options.output;
    const bool keeps = store != nullptr && (options.resume || options.to_film() || options.workers > 1);
    if (keeps && !store->has(frame)) {
        TRY(reserved, store->reserve(frame, wait));
        if (!*reserved) return false;
    }
    std::string line;
    if (!keeps || !store->has(frame)) {  // another run may have drawn it until now
        watch.begun(frame);
        const Stopwatch clock;
        const Exposure shown = exposure_in(job, options.time_step, frame);
        const bool numbered = store != nullptr || options.one_frame;
        TRY(made_by, draw(job, session, shown, options, file, numbered ? std::optional(frame) : std::nullopt));
        const std::string blur = shown.sub_frames.empty() ? ""
                                                          : fmt::format(", {} sub-frames in {:.1f} s",
                                                                        shown.sub_frames.size(), clock.seconds());
        const auto [width, height] = stereo_size(job.scene.camera);
        if (!options.to_film())
            line = fmt::format("{}: {}x{}, {}{}\n", files_of(file, job.scene, options), width, height, *made_by, blur);
    }
    if (keeps) store->release(frame);
    watch.done(frame, line);
    return true;
}

// Those that the store has not. What other runs are drawing comes last: it is drawn here if they end before.
Status draw_frames(const Job& job, Session* session, const CaptureOptions& options, FrameStore* store,
                   const FrameWatch& watch) {
    std::vector<int> left;
    for (int frame = job.frames.first; frame < job.frames.end; ++frame) {
        TRY(done, draw_frame(job, session, options, store, watch, frame, false));
        if (!*done) left.push_back(frame);
    }
    for (const int frame : left) {
        TRY(done, draw_frame(job, session, options, store, watch, frame, true));
    }
    return Done{};
}

Status draw_here(const Job& job, const CaptureOptions& options, FrameStore* store, const FrameWatch& watch) {
    std::optional<Session> session;
    if (options.renderer == "gl") {
        TRY(opened, open_session(options.context));
        session = std::move(*opened);
        session->renderer->set_method(job.method);
        session->renderer->limit_tiles(job.traced_tiles ? Tiles::kTraced : Tiles::kBodies);
    }
    return draw_frames(job, session ? &*session : nullptr, options, store, watch);
}

// By this process, or by workers.
Status draw_all(const Job& job, const CaptureOptions& options, FrameStore* store) {
    const int count = job.frames.end - job.frames.first;
    std::optional<Progress> progress;
    if (count > 1) progress.emplace("frames", count);
    std::set<int> there;
    int drawn = 0;
    const FrameWatch watch{
        [](int) {},
        [&](int frame, const std::string& line) {
            drawn += line.empty() ? 0 : 1;
            if (store != nullptr) store->drew_one();
            if (progress && !line.empty() && ::isatty(STDOUT_FILENO) == 1) progress->clear();
            fmt::print("{}", line);
            if (there.insert(frame).second && progress) progress->advance();
        },
    };
    const int workers = std::min(options.workers, count);
    const auto draw_by = [&]() -> Status {
        if (workers == 1) return draw_here(job, options, store, watch);
        return draw_in_workers(
            workers,
            [&](const FrameWatch& told) -> Status {
                TRY(own, store->reopen());
                return draw_here(job, options, store, told);
            },
            watch, progress ? &*progress : nullptr, [&] { return static_cast<int>(there.size()) < count; });
    };
    TRY(done, draw_by());
    if (options.resume && drawn == 0) fmt::print(stderr, "{}: all {} frames were there\n", options.output, count);
    return Done{};
}

// What a film says of itself: as its pictures do, of all of them. picture: one of them, which knows the driver.
Result<std::map<std::string, std::string>> film_words(const Job& job, const CaptureOptions& options,
                                                      const std::string& picture) {
    PictureOrigin origin = origin_of(job, options, job.scene, true, std::nullopt);
    origin.times = times_in(job, options.time_step, job.frames);
    origin.options +=
        fmt::format("{}--frames {}:{}", origin.options.empty() ? "" : " ", job.frames.first, job.frames.end);
    if (!job.path) origin.options += fmt::format(" --time-frame {}", job.time_frame);
    if (!options.ffmpeg.empty()) origin.options += fmt::format(" -- {}", fmt::join(options.ffmpeg, " "));
    TRY(said, load_texts(picture));
    origin.renderer = (*said)["nullscope.renderer"], origin.version = kVersionText;
    TRY(words, picture_words(origin));
    words->insert({"title", job.scene.name});
    return std::move(*words);
}

Status finish_film(const Job& job, const CaptureOptions& options, FrameStore& store) {
    const double rate = job.scene.path ? job.scene.path->rate : PathSpec{}.rate;
    const int count = job.frames.end - job.frames.first;
    TRY(words, film_words(job, options, store.file(job.frames.first)));
    TRY(made, encode_film({film_folder(options), job.frames.first, count, rate, options.output, options.ffmpeg,
                           options.words_asked(), std::move(*words), sphere_in(job, options.time_step, job.frames)}));
    std::error_code error;
    std::filesystem::remove_all(film_folder(options), error);
    const auto [width, height] = stereo_size(job.scene.camera);
    fmt::print("{}: {}x{}, {} frames at {} a second\n", options.output, width, height, count, rate);
    return Done{};
}

struct CaptureRun {
    CaptureOptions options;
    OpenedScene opened;
};

// What was asked for, with what a picture recorded.
Result<CaptureRun> run_of(CaptureOptions options) {
    if (!options.ffmpeg.empty() && (!options.to_film() || !options.ffmpeg.front().starts_with('-')))
        return bad_input(
            fmt::format("{}: not expected here; after -- are ffmpeg's options for a film", options.ffmpeg.front()));
    const Note note = options.listener.note;
    TRY(opened, open_scene(options.scene, note));
    TRY(whole, with_recorded(std::move(options), *opened, note));
    TRY(scene, sized(std::move(opened->scene), whole->size));
    if (whole->time) scene->time = *whole->time;
    if (whole->samples && whole->renderer == "gl") scene->picture.samples = *whole->samples;
    opened->scene = std::move(*scene);
    return CaptureRun{std::move(*whole), std::move(*opened)};
}

Status run_capture(const CaptureOptions& given) {
    CaptureOptions asked = given;
    if (asked.quiet) asked.listener.note = [](const std::string&) {};
    TRY(run, run_of(std::move(asked)));
    const CaptureOptions& options = run->options;
    if (options.dump_shader) return dump_shader(run->opened.scene, options);
    TRY(job, job_of(options, run->opened));
    if (!options.quiet && job->scene.picture.shutter > 0.0 && !job->path && options.time_step == 0)
        fmt::print(stderr, "picture.shutter: no motion blur, as nothing moves without a [path] or --time-step\n");
    if (!options.quiet && job->scene.picture.shutter > 0.0) say_dots(*job, options.time_step);
    if (!options.quiet) say_backwards(*job);
    TRY(store, store_of(*job, options));
    TRY(drawn, draw_all(*job, options, store->get()));
    return options.to_film() ? finish_film(*job, options, **store) : Status(Done{});
}

}  // namespace

Result<std::string> sequence_stamp(const CaptureOptions& options) {
    if (options.to_film())
        return bad_input(fmt::format("-o {}: a film is made by one run", options.output),
                         fmt::format("names that end in {}", format_endings()));
    TRY(run, run_of(options));
    TRY(job, job_of(run->options, run->opened));
    return stamp_of(*job, run->options);
}

void add_capture(Command& parent) { add_capture_to(parent, run_capture); }

}  // namespace nullscope::cli
