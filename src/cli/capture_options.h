// The options of nullscope capture.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/command.h"
#include "cli/film.h"
#include "command/draw_options.h"

namespace nullscope::cli {

// What nullscope capture was asked for.
struct CaptureOptions : DrawOptions {
    std::string scene, split, output = "frame.png", size, context = "auto", renderer = "gl", method = "auto", frames;
    std::optional<double> time;
    double time_step = 0;
    std::optional<int> time_frame;  // that has the scene's time
    std::optional<double> max_error;
    std::optional<int> quality;  // of a JPEG
    int workers = 1;
    std::vector<std::string> ffmpeg;  // options for the film
    std::string tiles = "auto";
    bool half = false, dump_shader = false, resume = false, plain = false, quiet = false;
    std::vector<std::string> given;  // names of the options that were given
    bool split_is_recorded = false;  // split is the picture that the scene is of
    bool one_frame = false;          // frames is one that a picture recorded, drawn into a file of its own

    bool to_exr() const { return output.ends_with(".exr"); }
    bool to_fits() const { return output.ends_with(".fits"); }
    bool to_linear_light() const { return to_exr() || to_fits(); }
    bool to_jpeg() const { return output.ends_with(".jpg") || output.ends_with(".jpeg"); }
    bool to_film() const { return is_film(output); }
    bool to_one_picture() const;  // neither a film nor numbered frames
    // What drawing needs to know of the file.
    DrawOptions drawing() const {
        DrawOptions options = *this;
        options.linear = to_linear_light(), options.in_bands = to_fits();
        return options;
    }
};

// The command's options into their target, and the command with the function that it runs.
void add_capture_options(Command& command, CaptureOptions& options);
void add_capture_to(Command& parent, const std::function<Status(const CaptureOptions&)>& run_it);

// Files of an unknown kind, and options that would change nothing. Errors: bad input, or no such folder.
Status check_options(const CaptureOptions& options);

}  // namespace nullscope::cli
