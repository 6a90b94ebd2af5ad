// The manual of a program, from its commands and options: man pages and the completion of a shell. Nothing is said here that help does
// not say.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/command_line.h"
#include "base/result.h"

namespace nullscope {

struct ManualPage {
    std::string name;  // "nullscope-bench-frames"
    std::string text;  // roff with the macros of man(7)
};

// Of the program and of each of its commands, section 1. What is said below the program's options is in its description.
std::vector<ManualPage> manual_pages(const Command& program);

// For bash (no other package is needed): commands, options, words that are allowed; else files. scene_names: a command that prints the
// names that an option or word "scene" takes beside files, one a line; empty: none.
std::string bash_completion(const Command& program, const std::string& scene_names);

// Both, as files of a folder that is made: man1/NAME.1, and PROGRAM.bash. Errors: the folder cannot be made or written.
Status write_manual(const Command& program, const std::string& scene_names, const std::filesystem::path& folder);

}  // namespace nullscope
