// A table (CSV) and the diagram beside it (SVG).
//
// The table begins with its header, as every reader of such files expects. What both were made from, and what the columns mean, is in the
// diagram's <metadata>: a <text keyword="nullscope.scene_text"> for each keyword that pictures have (scenefile/picture_scene.h), and nullscope.columns.
#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/command_line.h"
#include "base/result.h"
#include "scene/scene.h"

namespace nullscope::cli {

// The options of a command that were given.
class GivenWords {
public:
    void of(Command& command) {
        command_ = &command;
        command.note_given(&names_);
    }
    bool has(std::string_view names) const { return std::ranges::find(names_, names) != names_.end(); }
    // As words of the command line, but for the scene, the files to write and the context: "--steps 24 --renderer reference".
    std::string words() const;

private:
    const Command* command_ = nullptr;
    std::vector<std::string> names_;
};

struct TableOrigin {
    Scene scene;             // with the size and the time that were drawn
    std::string scene_name;  // its file or name, "" for none
    std::string options, renderer{};
    std::string columns{};        // what they mean, lines for people
    std::vector<double> times{};  // PictureOrigin::times
    bool of_scene = true;         // else of a file that the options name
};

// svg: of a whole document. Errors: a file of the scene cannot be read, one cannot be written.
Status write_table(const std::string& csv_file, const std::string& csv, const std::string& svg_file, std::string svg,
                   const TableOrigin& origin);

}  // namespace nullscope::cli
