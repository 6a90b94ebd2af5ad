// nullscope study: a picture for every combination of values of a scene's keys.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/csv.h"
#include "base/progress.h"
#include "cli/capture_job.h"
#include "cli/capture_words.h"
#include "cli/command.h"
#include "cli/contact_sheet.h"
#include "cli/frame_store.h"
#include "cli/picture_file.h"
#include "cli/sweep.h"
#include "scene/stereo.h"

namespace nullscope::cli {
namespace {

namespace fs = std::filesystem;

struct StudyOptions {
    std::string scene, output = "study/%05d.png", range;
    Words set, tables;
    Words more;  // capture's options
    int chunk = 10;
    bool commands = false;
};

// What is drawn: cases of a scene, by capture's options.
struct Study {
    Cases cases;
    FrameNames names;
    CaptureOptions base;
    Frames range;  // of this run

    CaptureOptions options(int number) const {
        CaptureOptions options = base;
        const Words words = cases.words(number);
        options.set.insert(options.set.end(), words.begin(), words.end());
        options.output = names.of(number);
        return options;
    }
    fs::path beside(const char* name) const { return fs::path(names.pattern()).parent_path() / name; }
};

struct CaseRun {
    CaptureOptions options;
    CaptureJob job;
};

Result<CaseRun> case_run(const Study& study, int number) {
    TRY(run, capture_run(study.options(number)));
    TRY(job, capture_job(run->options, run->opened));
    return CaseRun{std::move(run->options), std::move(*job)};
}

Result<Cases> cases_of(const StudyOptions& options) {
    std::vector<Sweep> sweeps;
    for (const std::string& file : options.tables) {
        TRY(sweep, read_sweep(file));
        sweeps.push_back(std::move(*sweep));
    }
    for (const std::string& words : options.set) {
        TRY(sweep, parse_sweep(words));
        sweeps.push_back(std::move(*sweep));
    }
    if (sweeps.empty())
        return bad_input("no values to go through", "--set KEY=A,B,C or --set KEY=FROM:TO:COUNT, or --table FILE");
    return Cases::of(std::move(sweeps));
}

Result<Frames> range_of(const StudyOptions& options, const Cases& cases) {
    if (options.range.empty()) return Frames{0, cases.count()};
    const auto range = two_whole_numbers(options.range, ':', 0, kMostCases);
    if (!range || range->first >= range->second || range->second > cases.count())
        return bad_input(fmt::format("--cases {}: not a range of the {} cases", options.range, cases.count()),
                         fmt::format("A:B, with 0 <= A < B <= {}", cases.count()));
    return Frames{range->first, range->second};
}

Result<Study> study_of(const StudyOptions& options) {
    TRY(cases, cases_of(options));
    TRY(range, range_of(options, *cases));
    TRY(names, FrameNames::parse(options.output));
    Words words{"nullscope", "capture", options.scene, "-o", names->of(0)};
    words.insert(words.end(), options.more.begin(), options.more.end());
    TRY(base, capture_options_of(words));
    if (!base->to_one_picture() || base->format() == nullptr || base->output != names->of(0) || base->dump_shader)
        return bad_input(
            "a study draws one picture for each case",
            fmt::format("-o names that end in {}, and after -- no -o, --frames or --dump-shader", format_endings()));
    return Study{std::move(*cases), std::move(*names), std::move(*base), *range};
}

// Equal for runs whose pictures belong together: the first case, and all values.
Result<std::string> study_stamp(const Study& study) {
    TRY(first, case_run(study, 0));
    std::string stamp = stamp_of(first->job, first->options);
    for (const Sweep& sweep : study.cases.sweeps())
        for (std::size_t i = 0; i < sweep.values.size(); ++i)
            stamp += fmt::format("{} = {}: {}\n", fmt::join(sweep.keys, ", "), i, fmt::join(sweep.values[i], ", "));
    return stamp;
}

std::string csv_line(const Words& fields) {
    Words quoted;
    for (const std::string& field : fields) quoted.push_back(csv_field(field));
    return fmt::format("{}\n", fmt::join(quoted, ","));
}

Status write_index(const Study& study) {
    Words header{"case", "file"};
    for (const std::string& key : study.cases.keys()) header.push_back(key);
    std::string text = csv_line(header);
    for (int number = 0; number < study.cases.count(); ++number) {
        Words fields{fmt::format("{}", number), fs::path(study.names.of(number)).filename().string()};
        for (const std::string& value : study.cases.values(number)) fields.push_back(value);
        text += csv_line(fields);
    }
    return write_text_atomically(study.beside("index.csv"), text);
}

// "theta 30, spin 0.5": keys that do not change from case to case are left out.
std::string label_of(const Cases& cases, int number) {
    const Words keys = cases.keys(), values = cases.values(number);
    Words parts;
    std::size_t at = 0;
    for (const Sweep& sweep : cases.sweeps())
        for (std::size_t i = 0; i < sweep.keys.size(); ++i, ++at)
            if (sweep.values.size() > 1)
                parts.push_back(fmt::format("{} {}", keys[at].substr(keys[at].rfind('.') + 1), values[at]));
    return fmt::format("{}", fmt::join(parts, ", "));
}

// Of pictures that can be looked at, once all of them are there.
Status write_sheet(const Study& study, const FrameStore& store) {
    if (study.base.to_linear_light()) return Done{};
    std::vector<SheetTile> tiles;
    for (int number = 0; number < study.cases.count(); ++number) {
        if (!store.has(number)) return Done{};
        tiles.push_back({study.names.of(number), label_of(study.cases, number)});
    }
    const fs::path file = study.beside("contact.png");
    const Status written = write_contact_sheet(file, tiles, study.cases.columns());
    if (!written) fmt::print(stderr, "{}: not written: {}\n", file.string(), written.error().message());
    if (written) fmt::print("{}: {} pictures\n", file.string(), tiles.size());
    return Done{};
}

// Unless it is there. False: another run is drawing it; wait: until that run has.
Result<bool> draw_case(const Study& study, std::optional<Session>& session, FrameStore& store, int number, bool wait,
                       std::string& line) {
    if (store.has(number)) return true;
    TRY(reserved, store.reserve(number, wait));
    if (!*reserved) return false;
    if (!store.has(number)) {  // another run may have drawn it until now
        TRY(run, case_run(study, number));
        if (!session) {
            TRY(opened, capture_session(run->job, run->options));
            session = std::move(*opened);
        }
        if (session) tell_renderer(*session, run->job);
        const int frame = run->job.frames.first;  // 0 but for a scene that is a film's picture
        const Exposure shown = exposure_in(run->job, run->options.time_step, frame);
        TRY(made_by, draw_into(run->job, session ? &*session : nullptr, shown, run->options, run->options.output,
                               run->options.one_frame ? std::optional(frame) : std::nullopt));
        const auto [width, height] = stereo_size(run->job.scene.camera);
        line = fmt::format("{}: {}x{}, {}, {}\n", run->options.output, width, height,
                           fmt::join(study.cases.words(number), " "), *made_by);
        store.drew_one();
    }
    store.release(number);
    return true;
}

// What other runs are drawing comes last: it is drawn here if they end before.
Status draw_cases(const Study& study, FrameStore& store) {
    std::optional<Session> session;
    Progress progress("pictures", study.range.end - study.range.first);
    std::vector<int> numbers, left;
    for (int number = study.range.first; number < study.range.end; ++number) numbers.push_back(number);
    for (const bool wait : {false, true}) {
        for (const int number : numbers) {
            std::string line;
            TRY(there, draw_case(study, session, store, number, wait, line));
            if (!*there) {
                left.push_back(number);
                continue;
            }
            if (!line.empty()) progress.clear();
            fmt::print("{}", line);
            progress.advance();
        }
        numbers = std::exchange(left, {});
    }
    return Done{};
}

Status print_commands(const StudyOptions& options, const Study& study) {
    for (int first = study.range.first; first < study.range.end; first += options.chunk) {
        Words words{"nullscope",
                    "study",
                    options.scene,
                    "-o",
                    options.output,
                    "--cases",
                    fmt::format("{}:{}", first, std::min(first + options.chunk, study.range.end))};
        for (const std::string& file : options.tables) words.insert(words.end(), {"--table", file});
        for (const std::string& set : options.set) words.insert(words.end(), {"--set", set});
        if (!options.more.empty()) words.emplace_back("--");
        words.insert(words.end(), options.more.begin(), options.more.end());
        TRY(line, shell_line(words));
        fmt::print("{}\n", *line);
    }
    return Done{};
}

// What is wrong is said before any is drawn.
Status check_cases(const Study& study) {
    Progress progress("cases", study.range.end - study.range.first);
    for (int number = study.range.first; number < study.range.end; ++number) {
        TRY(good, case_run(study, number));
        progress.advance();
    }
    return Done{};
}

Status run_study(const StudyOptions& options) {
    TRY(study, study_of(options));
    const fs::path folder = study->beside("index.csv").parent_path();
    std::error_code error;
    const bool made = !folder.empty() && fs::create_directories(folder, error);
    if (error) return failed(fmt::format("-o {}: {}", options.output, error.message()));
    if (Status good = check_cases(*study); !good) {
        if (made) fs::remove(folder, error);
        return good;
    }
    if (options.commands) return print_commands(options, *study);
    TRY(stamp, study_stamp(*study));
    TRY(store, FrameStore::open_sequence(study->names, *stamp, true));
    TRY(written, write_index(*study));
    TRY(drawn, draw_cases(*study, **store));
    return write_sheet(*study, **store);
}

}  // namespace

void add_study(Command& parent) {
    auto [command, options] = add_command<StudyOptions>(
        parent, "study",
        "Draw a scene for every combination of values of its keys: pictures, index.csv and a contact sheet", run_study);
    required_option(command, "scene", options.scene,
                    "Scene file, or the name of a built-in scene (see: nullscope scenes)");
    command.add_option("options", &options.more, "After --: options of capture, as in -- --size 640x360 --samples 2");
    command
        .add_option("--set", &options.set,
                    "KEY=A,B,C or KEY=FROM:TO:COUNT (both ends included), as in --set camera.theta=10:80:8 --set "
                    "spacetime.spin=0,0.5,0.9; several: all combinations, the last changes fastest")
        .repeated();
    command
        .add_option("--table", &options.tables,
                    "Table (CSV) of cases: its header has keys, as camera.theta, and each line their values")
        .repeated();
    text_option(command, "-o,--output", options.output,
                "Files to write, with one placeholder for the case's number (%05d, %d or #####); pictures of the same "
                "study that "
                "are there stay. index.csv and contact.png are beside them");
    command.add_option("--cases", &options.range, "A:B, only cases A to B-1 (default: all)");
    command.add_flag("--commands", &options.commands,
                     "Print a shell command for each chunk of cases; all may run at once (docs/farm.md)");
    number_option(command, "--chunk", options.chunk, 1, kMostCases, "Cases of a chunk").needs("--commands");
}

}  // namespace nullscope::cli
