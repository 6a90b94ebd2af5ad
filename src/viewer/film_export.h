// A film of the scene's path, drawn by `nullscope capture` in a process of its own while the viewer goes on.
#pragma once
#include <string>

#include "base/result.h"
#include "scene/scene.h"
#include "viewer/child_process.h"

namespace nullscope::viewer {

class FilmExport {
public:
    // Of a scene with a path, in its camera's size. output: NAME.mp4, which needs ffmpeg, or NAME%05d.png. Errors: the program nullscope is not
    // beside this one; a file that cannot be written.
    Status start(const Scene& scene, const std::string& output);
    bool runs() const { return process_.runs(); }
    double share() const { return share_; }  // that is done, 0 to 1
    // Reads what it says; true if there is something new. When it has ended, message() says how, once.
    bool poll();
    std::string take_message();
    void cancel() { process_.end(); }  // what is drawn of a film stays, and the same film goes on from there

private:
    void read_output();
    ChildProcess process_;
    double share_ = 0.0;
    std::string output_, said_, line_, message_;
};

}  // namespace nullscope::viewer
