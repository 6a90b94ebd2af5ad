// nullscope capture: a picture of a scene in a file.
#include <fmt/format.h>
#include <fmt/ranges.h>

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
#include "cli/capture_job.h"
#include "cli/command.h"
#include "cli/film.h"
#include "cli/frame_store.h"
#include "cli/picture_file.h"
#include "cli/workers.h"
#include "command/frame_writer.h"
#include "command/shot.h"
#include "command/stereo_capture.h"
#include "image/picture_texts.h"
#include "observer/path.h"
#include "plan/shutter.h"
#include "platform/console.h"
#include "platform/fork.h"
#include "scene/stereo.h"
#include "shaderlib/passes.h"
#include "version/version.h"

namespace nullscope::cli {
namespace {

std::string film_folder(const CaptureOptions& options) { return options.output + ".frames"; }

Status dump_shader(const Scene& scene, const CaptureOptions& options) {
    if (options.renderer == "reference")
        return bad_input("--dump-shader: the reference has none", "with --renderer gl");
    TRY(method, chosen_method(options.method, options.max_error, scene, options.listener));
    const EffectSet effects = effect_set(required_effects(scene));
    for (const Pass& pass : passes(effects, Output::kDisplay))
        fmt::print("{}", pass_text(pass, effects, *method, scene.spacetime.metric, body_text(scene, effects)));
    return Done{};
}

// Says once that bright points leave dots.
void say_dots(const CaptureJob& job, double time_step) {
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
void say_backwards(const CaptureJob& job) {
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

// Where the pictures of a film or a sequence go, and which of them are there. Nothing: one picture.
Result<std::unique_ptr<FrameStore>> store_of(const CaptureJob& job, const CaptureOptions& options) {
    if (!options.to_film() && !job.names) return std::unique_ptr<FrameStore>();
    if (platform::Crew::is_member())
        return options.to_film() ? FrameStore::join_film(film_folder(options)) : FrameStore::join_sequence(*job.names);
    const std::string stamp = stamp_of(job, options);
    return options.to_film() ? FrameStore::open_film(film_folder(options), stamp)
                             : FrameStore::open_sequence(*job.names, stamp, options.resume);
}

// Of what is kept of a picture until it is written, at most.
double bytes_of_frame(const CameraSpec& camera, const CaptureOptions& options) {
    const auto [width, height] = stereo_size(camera);
    const double bytes_a_pixel = 18.0 + (options.raydata ? 48.0 : 0.0) + (options.layers ? 200.0 : 0.0);
    return bytes_a_pixel * width * height;
}

// The frames of one process: drawn one after the other, and written meanwhile.
struct FrameLoop {
    const CaptureJob& job;
    Session* session;  // null: the reference draws
    const CaptureOptions& options;
    FrameStore* store;  // null: one picture
    const FrameWatch& watch;
    FrameWriter writer{pictures_written_at_once(options.workers, bytes_of_frame(job.scene.camera, options))};

    std::optional<DrawnPicture> in_flight{};  // drawn, its pixels on their way
    std::function<void()> landed{};           // what follows when it is written

    bool keeps() const { return store != nullptr && (options.resume || options.to_film() || options.workers > 1); }
    Result<bool> draw(int frame, bool wait);
    Status draw_all();
    Status land();  // hands what is in flight to the writer
};

Status FrameLoop::land() {
    if (!in_flight) return Done{};
    const DrawnPicture drawn = *std::exchange(in_flight, std::nullopt);
    if (drawn.arrive) drawn.arrive();
    return writer.add(
        drawn.write ? drawn.write : [] { return Status(Done{}); }, std::move(landed));
}

// Draws a frame unless the store has it. False: another run, or worker, is drawing it.
Result<bool> FrameLoop::draw(int frame, bool wait) {
    const std::string file = store != nullptr ? store->file(frame) : options.output;
    if (keeps() && !store->has(frame)) {
        TRY(reserved, store->reserve(frame, wait));
        if (!*reserved) return false;
    }
    const auto done = [this, frame](const std::string& line) {
        if (keeps()) store->release(frame);
        watch.done(frame, line);
    };
    if (keeps() && store->has(frame)) {  // another run may have drawn it until now
        done("");
        return true;
    }
    watch.begun(frame);
    const Stopwatch clock;
    const Exposure shown = exposure_in(job, options.time_step, frame);
    const bool numbered = store != nullptr || options.one_frame;
    auto drawn = draw_for(job, session, shown, options, file, numbered ? std::optional(frame) : std::nullopt, true);
    TRY(before, land());  // drawn before, whatever became of this one
    if (!drawn) return drawn.error();
    const std::string blur = shown.sub_frames.empty()
                                 ? ""
                                 : fmt::format(", {} sub-frames in {:.1f} s", shown.sub_frames.size(), clock.seconds());
    const auto [width, height] = stereo_size(job.scene.camera);
    const std::string line = options.to_film() ? ""
                                               : fmt::format("{}: {}x{}, {}{}\n", files_of(file, job.scene, options),
                                                             width, height, drawn->said, blur);
    in_flight = std::move(*drawn);
    landed = [done, line] { done(line); };
    return true;
}

// Those that the store has not. What other runs are drawing comes last: it is drawn here if they end before.
Status FrameLoop::draw_all() {
    std::vector<int> left;
    for (int frame = job.frames.first; frame < job.frames.end; ++frame) {
        TRY(done, draw(frame, false));
        if (!*done) left.push_back(frame);
    }
    TRY(last, land());
    TRY(written, writer.finish());  // others may wait for these
    for (const int frame : left) {
        TRY(done, draw(frame, true));
        TRY(last_left, land());
        TRY(left_written, writer.finish());  // another run may wait for this one, and this run for that one's
    }
    return Done{};
}

Status draw_here(const CaptureJob& job, const CaptureOptions& options, FrameStore* store, const FrameWatch& watch) {
    TRY(session, capture_session(job, options));
    return FrameLoop{job, *session ? &**session : nullptr, options, store, watch}.draw_all();
}

// By this process, or by workers.
Status draw_all(const CaptureJob& job, const CaptureOptions& options, FrameStore* store) {
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
            if (progress && !line.empty() && platform::is_terminal(platform::Output::kText)) progress->clear();
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
Result<std::map<std::string, std::string>> film_words(const CaptureJob& job, const CaptureOptions& options,
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

Status finish_film(const CaptureJob& job, const CaptureOptions& options, std::unique_ptr<FrameStore> store) {
    const double rate = job.scene.path ? job.scene.path->rate : PathSpec{}.rate;
    const int count = job.frames.end - job.frames.first;
    TRY(words, film_words(job, options, store->file(job.frames.first)));
    TRY(made, encode_film({film_folder(options), job.frames.first, count, rate, options.output, options.ffmpeg,
                           options.words_asked(), std::move(*words), sphere_in(job, options.time_step, job.frames)}));
    std::error_code error;
    std::filesystem::remove_all(film_folder(options), error);
    if (error) {  // Windows does not remove what is open
        store.reset();
        std::filesystem::remove_all(film_folder(options), error);
    }
    const auto [width, height] = stereo_size(job.scene.camera);
    fmt::print("{}: {}x{}, {} frames at {} a second\n", options.output, width, height, count, rate);
    return Done{};
}

Status run_capture(const CaptureOptions& given) {
    CaptureOptions asked = given;
    if (asked.quiet) asked.listener.note = [](const std::string&) {};
    TRY(run, capture_run(std::move(asked)));
    const CaptureOptions& options = run->options;
    if (options.dump_shader) return dump_shader(run->opened.scene, options);
    TRY(job, capture_job(options, run->opened));
    if (!options.quiet && job->scene.picture.shutter > 0.0 && !job->path && options.time_step == 0)
        fmt::print(stderr, "picture.shutter: no motion blur, as nothing moves without a [path] or --time-step\n");
    if (!options.quiet && job->scene.picture.shutter > 0.0) say_dots(*job, options.time_step);
    if (!options.quiet) say_backwards(*job);
    TRY(store, store_of(*job, options));
    TRY(drawn, draw_all(*job, options, store->get()));
    return options.to_film() ? finish_film(*job, options, std::move(*store)) : Status(Done{});
}

}  // namespace

Result<std::string> sequence_stamp(const CaptureOptions& options) {
    if (options.to_film())
        return bad_input(fmt::format("-o {}: a film is made by one run", options.output),
                         fmt::format("names that end in {}", format_endings()));
    TRY(run, capture_run(options));
    TRY(job, capture_job(run->options, run->opened));
    return stamp_of(*job, run->options);
}

void add_capture(Command& parent) { add_capture_to(parent, run_capture); }

}  // namespace nullscope::cli
