// A film of the scene's path, drawn by `nullscope capture` in a process of its own while the viewer goes on.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "base/result.h"
#include "scene/scene.h"
#include "studio/child_process.h"

namespace nullscope::viewer {

// How far a film is: "frame 30 of 150, 2 min left"; share: of the frames, 0 to 1.
std::string film_words(double share, int frames, std::optional<double> left_s);

class FilmExport {
public:
    ~FilmExport() { cancel(); }
    // Of a scene with a path, in its camera's size. output: NAME.mp4, which needs ffmpeg, or NAME%05d.png. Errors: the program nullscope is not
    // beside this one; a file that cannot be written.
    Status start(const Scene& scene, const std::string& output);
    bool runs() const { return process_.runs(); }
    double share() const { return share_; }  // that is done, 0 to 1
    std::string progress_words() const;      // film_words() of it
    // Reads what it says; true if there is something new. When it has ended, message() says how, once.
    bool poll();
    std::string take_message();
    void cancel();  // what is drawn of a film stays, and the same film goes on from there

private:
    void read_output();
    void remove_file();
    ChildProcess process_;
    std::filesystem::path file_;  // the scene's, this process's own; there while the film is drawn
    double share_ = 0.0;
    std::optional<double> left_s_;
    int frames_ = 0;
    std::string output_, said_, line_, message_;
};

}  // namespace nullscope::viewer
