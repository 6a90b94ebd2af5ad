// The pictures of a film or a sequence on disk: their names, what they depend on, and which of them are there.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/numbered_files.h"
#include "base/result.h"
#include "cli/capture_options.h"
#include "command/arguments.h"
#include "platform/file_lock.h"
#include "scene/scene.h"

namespace nullscope::cli {

// The names of a sequence's files: a file name with one place for the frame's number.
class FrameNames {
public:
    // pattern: holds one of %d, %5d, %05d (up to 9 digits) or #####. Errors: no such place, or more than one.
    static Result<FrameNames> parse(const std::string& pattern);
    static FrameNames in_folder(const std::string& folder);  // folder/00000.png ...
    std::string of(int frame) const { return files_.of(frame); }
    const std::string& pattern() const { return pattern_; }
    std::string stamp_file() const;  // NAME.png.stamp for NAME%05d.png
    std::vector<int> on_disk() const { return files_.on_disk(); }

private:
    FrameNames(std::string pattern, NumberedFiles files) : pattern_(std::move(pattern)), files_(std::move(files)) {}
    std::string pattern_;
    NumberedFiles files_;
};

inline bool names_frames(const std::string& output) { return names_numbers(output); }

// What the pictures depend on, as text: pictures of two runs may stand in one film only if it is equal.
struct StampInput {
    const Scene& scene;  // with the size and the time that are drawn
    const Scene* split;  // of the right half; null where the picture is one scene's, or the scene names it
    const CaptureOptions& options;
    std::string method;   // that auto chose
    double first_time;    // of frame 0
    std::string version;  // of the program
};

// One line for everything: options, every member of the scenes, the contents of the image files that they name.
std::string frame_stamp(const StampInput& input);

// The names of the lines that differ between two stamps, as a message says it: "camera.r, sky.kind and 2 more".
std::string stamp_difference(const std::string& before, const std::string& now);

// The pictures, and the stamp file with them: the text that frame_stamp() makes. Pictures are kept from one run to the
// next only under an equal stamp. While a run draws, it holds a lock on the stamp file: one that no other run can share,
// or, to resume a sequence, one that runs with an equal stamp share. The kernel frees locks when the process ends,
// however it ends. They are open file description locks, which NFS passes on to its server.
class FrameStore {
public:
    // A folder of the film's own, made if it is missing. Under another stamp its pictures are removed, and one line on
    // standard error says so. Errors: another run draws there (1), what the system says.
    static Result<std::unique_ptr<FrameStore>> open_film(const std::string& folder, const std::string& stamp);
    // The stamp file is NAME.png.stamp for NAME%05d.png. resume: pictures that are there stay, and other runs that resume
    // may draw as well. Errors: as above; pictures of another stamp, or of none (bad input).
    static Result<std::unique_ptr<FrameStore>> open_sequence(const FrameNames& names, const std::string& stamp,
                                                             bool resume);

    // What another process has opened, for which this one draws: reserves frames as reopen() does, and asks for no stamp.
    static Result<std::unique_ptr<FrameStore>> join_film(const std::string& folder);
    static Result<std::unique_ptr<FrameStore>> join_sequence(const FrameNames& names);

    FrameStore(const FrameStore&) = delete;
    FrameStore& operator=(const FrameStore&) = delete;
    ~FrameStore();  // a stamp without pictures goes with it

    std::string file(int frame) const { return names_.of(frame); }
    // Whether that picture is there and was drawn under this stamp: it is not older than the stamp file.
    bool has(int frame) const;
    // Reserves a frame, so that runs which share the stamp do not both draw it. False: another run is drawing it; wait:
    // until that run has ended or released it. Errors: what the system says.
    Result<bool> reserve(int frame, bool wait) const;
    void release(int frame) const;
    // In a process that was forked from the one which opened the store: reserves frames as a run of its own would. That
    // run's lock is held until the last of these processes has ended. Errors: what the system says.
    Status reopen();
    void drew_one() { new_ = false; }

private:
    enum class Lock { kShared, kExclusive };
    FrameStore(FrameNames names, std::string stamp_file, platform::LockFile locks);
    // patience_s: how long to wait for another run's lock.
    static Result<std::unique_ptr<FrameStore>> lock(const FrameNames& names, const std::string& stamp_file,
                                                    const std::string& what, Lock kind, double patience_s);
    static Result<std::unique_ptr<FrameStore>> join(const FrameNames& names, const std::string& stamp_file);
    Status check_no_picture(const std::string& before, const std::string& stamp) const;
    Status write(const std::string& stamp) const;

    FrameNames names_;
    std::string stamp_file_;
    platform::LockFile locks_;
    bool new_ = false;     // the stamp is this run's, and it has drawn no picture yet
    bool shared_ = false;  // others may have drawn
};

}  // namespace nullscope::cli
