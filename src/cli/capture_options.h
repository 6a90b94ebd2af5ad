// The options of nullscope capture.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "cli/command.h"
#include "cli/film.h"
#include "command/draw_options.h"
#include "image/picture_formats.h"

namespace nullscope::cli {

// What nullscope capture was asked for.
struct CaptureOptions : DrawOptions {
    std::string scene, split, output = "frame.png", size, renderer = "gl", method = "auto", frames;
    ContextChoice context;
    std::optional<double> time;
    double time_step = 0;
    std::optional<int> time_frame;  // that has the scene's time
    std::optional<double> max_error;
    std::optional<int> quality;  // of a JPEG
    std::string bits;  // of a colour of a displayed picture: "8", "10" (films), "16"; empty: as its format has it
    std::string colour = "rec709";  // of an EXR
    std::string derivatives;        // keys, with commas between, of the ray data
    int workers = 1;
    std::vector<std::string> set;     // scenefile/scene_override.h
    std::vector<std::string> ffmpeg;  // options for the film
    std::string tiles = "auto", stage = "fragment";
    bool half = false, dump_shader = false, resume = false, plain = false, quiet = false;
    std::vector<std::string> given;  // names of the options that were given
    bool split_is_recorded = false;  // split is the picture that the scene is of
    bool one_frame = false;          // frames is one that a picture recorded, drawn into a file of its own

    const PictureFormat* format() const { return format_named(output); }  // nullptr: a film, or unknown
    bool format_has(std::string_view option) const;                       // PictureFormat::options; a film has --bits
    bool to_exr() const { return format() == &kExrFormat; }
    bool to_displayed_light() const { return to_exr() && colour == "display"; }
    bool to_linear_light() const {  // not to what is displayed, whatever its encoding
        return format() != nullptr && format()->sample == Sample::kLight && !to_displayed_light();
    }
    bool to_film() const { return is_film(output); }
    bool words_asked() const { return (bits == "16" || bits == "10") && format_has("--bits"); }
    bool to_one_picture() const;  // neither a film nor numbered frames
    // What drawing needs to know of the file.
    DrawOptions drawing() const {
        DrawOptions options = *this;
        options.sample = format() != nullptr ? format()->sample : Sample::kByte;
        if (words_asked() || to_displayed_light()) options.sample = Sample::kWord;
        options.in_bands = !to_exr();  // its bands go straight into the file
        options.stokes = !half && !to_film() && (to_linear_light() || to_one_picture());
        options.bands = !half && to_linear_light();
        return options;
    }
};

// The command's options into their target, and the command with the function that it runs.
void add_capture_options(Command& command, CaptureOptions& options);
void add_capture_to(Command& parent, const std::function<Status(const CaptureOptions&)>& run_it);

// Errors: a file of an unknown kind, no such folder.
Status check_output(const CaptureOptions& options);

}  // namespace nullscope::cli
