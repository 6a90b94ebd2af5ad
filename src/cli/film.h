// Films: numbered pictures made into one file by the ffmpeg program.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "image/sphere_film.h"

namespace nullscope::cli {

// Whether the name ends as a film's does.
bool is_film(const std::string& name);
// ".mp4, .mov, .mkv, .webm"
std::string film_endings();

bool have_ffmpeg();

// Pictures folder/00000.png ..., `count` from number `first` on.
struct Film {
    std::string folder;
    int first = 0, count = 0;
    double rate = 0;  // pictures a second
    std::string output;
    // Options of ffmpeg for the output, after those that go with its name; where one of them names a codec, those are
    // left out.
    std::vector<std::string> options{};
    bool ten_bits = false;                       // a colour; the pictures have 16
    std::map<std::string, std::string> texts{};  // what it says of itself, by keyword
    // What it shows of the sphere: said in .mp4 and .mov, unless an option of ffmpeg filters the pictures, and in .mkv and .webm without options.
    std::optional<FilmSphere> sphere{};
};
// Under its name only when complete. Errors: ffmpeg is missing or fails; one line, with the first that it said; those of copy_with_sphere.
Status encode_film(const Film& film);

}  // namespace nullscope::cli
