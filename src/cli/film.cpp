#include "cli/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "base/atomic_file.h"
#include "base/text.h"
#include "platform/process.h"

namespace nullscope::cli {
namespace {

using FilmWords = std::vector<std::string>;

// What a name's ending stands for, as options of ffmpeg.
struct FilmKind {
    const char *ending, *options, *ten_bits;
    bool is_rgb = false;
    std::string_view
        sphere_in{};  // what has boxes for the sphere, MP4 or QuickTime; a film of another kind is copied from there
};
constexpr const char* kAnyKeyword = "-movflags +use_metadata_tags";  // so that MP4 says what it was made from
constexpr std::array kKinds{
    FilmKind{".mp4", "-c:v libx264 -crf 16 -pix_fmt yuv420p -movflags +faststart",  // plays everywhere
             "-c:v libx265 -crf 16 -pix_fmt yuv420p10le -tag:v hvc1 -x265-params log-level=error -movflags +faststart",
             false, ".mp4"},
    FilmKind{".mov", "-c:v prores_ks -profile:v hq -vendor apl0 -pix_fmt yuv422p10le",  // ProRes 422 HQ, to be edited
             "-c:v prores_ks -profile:v hq -vendor apl0 -pix_fmt yuv422p10le", false, ".mov"},
    FilmKind{".mkv", "-c:v ffv1 -level 3 -slicecrc 1 -pix_fmt bgr0",  // without loss
             "-c:v ffv1 -level 3 -slicecrc 1 -pix_fmt gbrp10le", true, ".mov"},
    FilmKind{".webm", "-c:v libvpx-vp9 -crf 18 -b:v 0 -row-mt 1 -pix_fmt yuv420p",
             "-c:v libvpx-vp9 -crf 18 -b:v 0 -row-mt 1 -profile:v 2 -pix_fmt yuv420p10le", false, ".mp4"},
};
constexpr const char* kEvenSides = "crop=trunc(iw/2)*2:trunc(ih/2)*2";  // 4:2:0 halves them
// Pictures are sRGB, and the film says so; where it does not, players guess by its size.
constexpr const char* kYuv =
    ",scale=out_color_matrix=bt709,"
    "setparams=colorspace=bt709:color_primaries=bt709:color_trc=iec61966-2-1:range=tv";
constexpr const char* kRgb =
    ",setparams=colorspace=gbr:color_primaries=bt709:color_trc=iec61966-2-1:range=pc";  // without a matrix

const FilmKind* kind_of(const std::string& name) {
    const auto* const kind = std::ranges::find_if(kKinds, [&](const FilmKind& k) { return name.ends_with(k.ending); });
    return kind == kKinds.end() ? nullptr : kind;
}

// For names that ffmpeg reads as a pattern.
std::string percent_doubled(const std::string& name) {
    std::string doubled;
    for (const char c : name) doubled += c == '%' ? "%%" : std::string(1, c);
    return doubled;
}

void add_words(FilmWords& words, const std::string& blanks_between) {
    for (std::string& word : split(blanks_between, ' ')) words.push_back(std::move(word));
}

// Texts as ffmpeg reads them: of any length, which words of a command line may not be.
std::string ffmetadata(const std::map<std::string, std::string>& texts) {
    std::string text = ";FFMETADATA1\n";
    const auto add = [&](const std::string& word) {
        for (const char c : word)
            text += (std::string_view("=;#\\\n").find(c) == std::string_view::npos ? "" : "\\") + std::string(1, c);
    };
    for (const auto& [keyword, value] : texts) add(keyword), text += '=', add(value), text += '\n';
    return text;
}

bool names_codec(const std::string& option) {
    constexpr std::array kNames{"-c", "-codec", "-vcodec", "-c:v", "-codec:v", "-c:v:0", "-codec:v:0"};
    return std::ranges::find(kNames, option) != kNames.end();
}

bool names_filter(const std::string& option) {
    return option == "-vf" || option == "-lavfi" || option.starts_with("-filter");
}

// Of one that makes this film.
Status run_ffmpeg(const Film& film, FilmWords words) {
    // -xerror: without it the status is 0 also where the film's end could not be written.
    FilmWords all;
    add_words(all, "ffmpeg -y -xerror -loglevel error");
    all.insert(all.end(), words.begin(), words.end());
    const platform::Ran ended = platform::run_program(std::move(all));
    if (ended.how.empty()) return Done{};
    const std::string said = without_controls(ended.said);
    const std::string why = said.empty() ? ended.how : fmt::format("{}: {}", ended.how, said);
    return failed((ended.found ? fmt::format("ffmpeg could not write {} ({})", film.output, why)
                               : std::string("ffmpeg is not installed")) +
                  "; the pictures are in " + film.folder);
}

// Into a file `part`, whose ending says what holds the film.
Status encode_into(const Film& film, const std::string& texts, const std::filesystem::path& part) {
    FilmWords words;
    add_words(words, fmt::format("-framerate {} -start_number {} -i", film.rate, film.first));
    words.push_back(percent_doubled(film.folder) + "/%05d.png");
    const FilmKind& kind = *kind_of(film.output);
    words.insert(words.end(), {"-f", "ffmetadata", "-i", texts, "-map_metadata", "1"});
    add_words(words, fmt::format("-frames:v {} -vf {}{}", film.count, kEvenSides, kind.is_rgb ? kRgb : kYuv));
    if (std::ranges::none_of(film.options, names_codec)) add_words(words, film.ten_bits ? kind.ten_bits : kind.options);
    if (kind.sphere_in == kind.ending) add_words(words, kAnyKeyword);
    words.insert(words.end(), film.options.begin(), film.options.end());
    words.push_back(part.string());
    return run_ffmpeg(film, std::move(words));
}

Status mark_sphere(const Film& film, const std::filesystem::path& plain, const std::filesystem::path& marked) {
    return write_stream_atomically(marked, [&](std::ostream& output) -> Status {
        std::ifstream input(plain, std::ios::binary);
        Status copied = copy_with_sphere(input, *film.sphere, output);
        if (copied) return copied;
        return failed(fmt::format("{} could not be marked as a film of the sphere ({}); the pictures are in {}",
                                  film.output, copied.error().what, film.folder));
    });
}

// The same pictures and what is said of the sphere, which ffmpeg then writes as this kind of film does, and the texts.
Status copy_marked(const Film& film, const std::string& texts, const std::filesystem::path& marked) {
    return write_atomically(film.output, [&](const std::filesystem::path& part) {
        FilmWords words{"-i", marked.string(), "-f", "ffmetadata", "-i", texts};
        add_words(words, "-map 0:v -map_metadata 1 -c copy");
        if (kind_of(film.output)->is_rgb) add_words(words, "-color_range pc");  // QuickTime has no word for it
        words.push_back(part.string());
        return run_ffmpeg(film, std::move(words));
    });
}

// ffmpeg has no option for what a film shows of the sphere: it is put into a copy.
Status encode_sphere(const Film& film, const std::string& texts) {
    const FilmKind& kind = *kind_of(film.output);
    const std::string holder(kind.sphere_in);
    const std::filesystem::path plain = film.folder + "/film" + holder, marked = film.folder + "/marked" + holder;
    Status made =
        write_atomically(plain, [&](const std::filesystem::path& part) { return encode_into(film, texts, part); });
    if (!made) return made;
    const bool is_there = holder == kind.ending;
    made = mark_sphere(film, plain, is_there ? std::filesystem::path(film.output) : marked);
    if (made && !is_there) made = copy_marked(film, texts, marked);
    std::error_code ignored;
    std::filesystem::remove(plain, ignored), std::filesystem::remove(marked, ignored);
    return made;
}

// Options for a kind of film are not those of what it is copied from.
bool is_marked(const Film& film) {
    const FilmKind& kind = *kind_of(film.output);
    if (!film.sphere || kind.sphere_in.empty() || std::ranges::any_of(film.options, names_filter)) return false;
    return kind.sphere_in == kind.ending || film.options.empty();
}

}  // namespace

bool is_film(const std::string& name) { return kind_of(name) != nullptr; }

std::string film_endings() {
    std::string text;
    for (const FilmKind& kind : kKinds) text += (text.empty() ? "" : ", ") + std::string(kind.ending);
    return text;
}

bool have_ffmpeg() { return platform::run_program({"ffmpeg", "-loglevel", "quiet", "-version"}).how.empty(); }

Status encode_film(const Film& film) {
    const std::string texts = film.folder + "/texts";
    TRY(said, write_text_atomically(texts, ffmetadata(film.texts)));
    if (is_marked(film)) return encode_sphere(film, texts);
    return write_atomically(film.output,
                            [&](const std::filesystem::path& part) { return encode_into(film, texts, part); });
}

}  // namespace nullscope::cli
