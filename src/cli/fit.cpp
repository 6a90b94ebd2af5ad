// nullscope fit: the numbers of a scene that describe data best, with their errors.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "command/json.h"
#include "command/options.h"
#include "fit/data_sources.h"
#include "fit/nuisance.h"
#include "fit/report.h"
#include "fit/solver.h"
#include "fit/subject.h"
#include "scenefile/scene_writer.h"

namespace nullscope::cli {
namespace {

struct FitCommandOptions {
    std::vector<std::string> set;  // scenefile/scene_override.h
    std::string data, scene, free, sigma, mask, nuisance, loss = "huber", output;
    ContextChoice context;
    std::optional<int> samples, seed;
    int starts = 4;
    bool json = false;
};

Status write_best(const std::string& file, const fit::SceneFamily& family, const std::vector<double>& values) {
    if (file.empty()) return Done{};
    TRY(scene, family.at(values));
    const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
    return write_text_atomically(file, scene_file_text(*scene, folder));
}

Result<int> run_fit_command(const FitCommandOptions& options) {
    if (!fit::can_solve())
        return failed("this program was built without Ceres Solver (NULLSCOPE_FIT), which fits need");
    TRY(fixed, fit::SceneFamily::open(options.scene, options.set, {}));
    TRY(free, fit::free_scene(*fixed, options.free, options.nuisance));
    fit::DataSources sources{options.data, {}, {}, options.sigma, options.mask, free->flux, options.samples};
    TRY(subject, fit::open_subject(free->family, fit::own_session(options.context), sources));
    fit::FitOptions fitting;
    fitting.free_flux = free->flux;
    fitting.loss = static_cast<fit::Loss>(std::ranges::find(fit::kLossNames, options.loss) - fit::kLossNames);
    fitting.search.starts = options.starts;
    if (options.seed) fitting.search.seed = static_cast<std::uint64_t>(*options.seed);
    TRY(fitted, fit::fit_subject(*subject, free->family.free(), fitting));
    const fit::Reported reported{*fitted, free->family.free(), subject->data.what,
                                 subject->samples ? std::optional(subject->samples()) : std::nullopt, free->flux};
    TRY(written, write_best(options.output, free->family, fitted->best.values));
    fmt::print("{}", options.json ? json_text(fit::fit_json(reported)) : fit::fit_table(reported));
    if (const std::string bad = fit::bad_words(fitted->goodness); !bad.empty()) return failed(bad);
    return 0;
}

}  // namespace

void add_fit(Command& parent) {
    auto [command, options] =
        add_command<FitCommandOptions>(parent, "fit",
                                       "The numbers of a scene that describe a picture, visibilities, a light curve or "
                                       "a line's profile best, with their "
                                       "errors",
                                       run_fit_command);
    required_option(command, "data", options.data,
                    "Picture (EXR, FITS, PNG and others) of linear light, or a table (.csv) as visibility, lightcurve "
                    "or spectrum write it");
    required_option(command, "scene", options.scene,
                    "Scene file, or the name of a built-in scene (see: nullscope scenes), that is to describe it");
    required_option(command, "--free", options.free,
                    "KEY=LOW:HIGH,... numbers of the scene and their ranges: spin=0:0.99,camera.theta=10:80");
    set_option(command, options.set);
    command.add_option("--sigma", &options.sigma,
                       "Standard deviation: a number, a number and % of the brightest, or a picture; of tables without "
                       "a column noise");
    command.add_option("--mask", &options.mask, "Picture whose bright pixels (above one half) count (default: all)");
    command.add_option("--nuisance", &options.nuisance,
                       "What else is free, of centre,roll,flux: the picture's place within 5 %, its turn, its scale");
    text_option(command, "--loss", options.loss,
                "What residuals beyond 3 standard deviations count: their squares, magnitudes, or less",
                {"none", "huber", "cauchy"});
    number_option(command, "--starts", options.starts, 1, 1000, "Number of starts that are refined");
    number_option(command, "--seed", options.seed, 0, 2147483647,
                  "Starts are random places in the ranges; the number chooses which (default: the best of 96 places)");
    number_option(command, "--samples", options.samples, 1, 16,
                  "N x N rays per pixel (default: as many as the data need)");
    command.add_option("-o,--output", &options.output, "Scene file to write, with the best values");
    command.add_flag("--json", &options.json, "Print one JSON object instead of the table");
    context_option(command, options.context);
}

}  // namespace nullscope::cli
