// nullscope spectrum: the profile of a line that a disc emits, as an observer at infinity sees it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/spectrum_plot.h"
#include "cli/table_file.h"
#include "command/line_source.h"
#include "command/options.h"
#include "scene/disc_emissivity.h"
#include "spectrum/line_profile.h"

namespace nullscope::cli {
namespace {

struct SpectrumOptions : LineOptions {
    std::string output = "spectrum";
    std::optional<double> line_kev, from, to;
    int bins = 1000;
    GivenWords given;
};

std::string bin_words(const LineSource& source, const SpectrumOptions& options) {
    const std::string place = options.ring
                                  ? fmt::format("ring at {:.10g} r_s", source.inner)
                                  : fmt::format("disc from {:.10g} to {:.10g} r_s", source.inner, source.outer);
    return fmt::format("{}{}, inclination {:g} degrees, emissivity {}, limb {}", place,
                       source.sense == Sense::kWestward ? ", westward" : "", source.inclination_deg,
                       emissivity_words(source.emissivity), options.limb);
}

std::string spectrum_columns(const LineSource& source, const SpectrumOptions& options, const ConvergedProfile& found) {
    const std::string linear = found.profile.linear.empty()
                                   ? ""
                                   : "; stokes_q, stokes_u: of photons, angles from the picture's right towards up, "
                                     "where the axis is; fraction, angle_deg: "
                                     "linear polarisation in the bin";
    return fmt::format(
        "Line profile. {}\n{}; r_s = 2 GM/c^2\n"
        "g = observed over emitted frequency, from {:.9g} to {:.9g}; photons, energy: share of the line's photon "
        "flux (g^3) and energy flux (g^4) in the bin{}\n"
        "half of the resolution changes no bin by more than {:.2g} of the largest",
        source.name, bin_words(source, options), found.profile.least_g, found.profile.most_g, linear, found.change);
}

// Of a bin: Q, U, the fraction, and the angle, (-90, 90]; the last two empty where there is no light.
std::string linear_cells(const LineProfile& p, std::size_t bin) {
    const std::complex<double> linear = p.linear[bin];
    std::string cells = fmt::format(",{:.9g},{:.9g}", linear.real() / p.all_photons, linear.imag() / p.all_photons);
    if (!(p.photons[bin] > 0.0)) return cells + ",,";
    return cells +
           fmt::format(",{:.9g},{:.9g}", std::abs(linear) / p.photons[bin], 0.5 * std::arg(linear) / kOneDegree);
}

std::string spectrum_csv(const SpectrumOptions& options, const ConvergedProfile& found) {
    const LineProfile& p = found.profile;
    std::string text = fmt::format("g_from,g_to,g,{}photons,energy{}\n", options.line_kev ? "energy_kev," : "",
                                   p.linear.empty() ? "" : ",stokes_q,stokes_u,fraction,angle_deg");
    for (std::size_t i = 0; i < p.photons.size(); ++i) {
        const double low = p.edge(i), high = p.edge(i + 1), middle = 0.5 * (low + high);
        text += fmt::format("{:.9g},{:.9g},{:.9g},", low, high, middle);
        if (options.line_kev) text += fmt::format("{:.9g},", middle * *options.line_kev);
        text += fmt::format("{:.9g},{:.9g}", p.share(i), p.energy[i] / p.all_energy);
        text += (p.linear.empty() ? "" : linear_cells(p, i)) + "\n";
    }
    return text;
}

LineBins bins_of(const SpectrumOptions& options) {
    LineBins bins{options.bins, options.from, options.to};
    if (options.line_kev)
        for (std::optional<double>* end : {&bins.from, &bins.to})
            if (*end) **end /= *options.line_kev;
    return bins;
}

void print(const LineSource& source, const SpectrumOptions& options, const ConvergedProfile& found) {
    const LineProfile& p = found.profile;
    const auto peak = static_cast<std::size_t>(std::ranges::max_element(p.photons) - p.photons.begin());
    fmt::print("{}\n{}\n", source.name, bin_words(source, options));
    fmt::print("g from {:.8f} to {:.8f}, mean {:.6f}; brightest bin at {:.6f}\n", p.least_g, p.most_g,
               p.all_energy / p.all_photons, 0.5 * (p.edge(peak) + p.edge(peak + 1)));
    if (!p.linear.empty())
        fmt::print(
            "polarised {:.4g} % of all photons, electric vector at {:.2f} degrees from the picture's right towards "
            "up\n",
            100.0 * std::abs(p.all_linear) / p.all_photons, 0.5 * std::arg(p.all_linear) / kOneDegree);
    fmt::print("{0}.csv, {0}.svg: {1} bins of g from {2:g} to {3:g}", options.output, options.bins, p.from, p.to);
    if (options.line_kev) fmt::print(", {:g} to {:g} keV", p.from * *options.line_kev, p.to * *options.line_kev);
    fmt::print("\nhalf of the resolution changes no bin by more than {:.2g} % of the largest\n", 100.0 * found.change);
}

Result<int> run_spectrum(const SpectrumOptions& options) {
    TRY(source, line_source(options));
    TRY(light, DistantLight::make(source->spacetime, source->inclination));
    const ConvergedProfile found = converged_profile(*light, disc_line(*source, options), bins_of(options));
    const double unit = options.line_kev.value_or(1.0);
    if (!(found.profile.to > found.profile.from))
        return bad_input(fmt::format("bins from {:g} to {:g}: --to is not above --from", found.profile.from * unit,
                                     found.profile.to * unit));
    TRY(written,
        write_table(
            options.output + ".csv", spectrum_csv(options, found), options.output + ".svg",
            spectrum_plot(source->name, bin_words(*source, options), found.profile, options.line_kev),
            {source->scene, options.scene, options.given.words(), {}, spectrum_columns(*source, options, found)}));
    print(*source, options, found);
    return 0;
}

}  // namespace

void add_spectrum(Command& parent) {
    auto [command, options] = add_command<SpectrumOptions>(
        parent, "spectrum",
        "Profile of a line that a thin disc emits (the broad iron line), for a distant observer: FILE.csv and FILE.svg",
        run_spectrum);
    options.given.of(command);
    command.add_option(
        "scene,--scene", &options.scene,
        "Scene file, or the name of a built-in scene, whose spacetime, disc radii and camera inclination "
        "are taken (default: a Schwarzschild hole)");
    text_option(command, "-o,--output", options.output, "Name of the files to write, without .csv and .svg");
    number_option(command, "--spin", options.spin, -1, 1,
                  "Without a scene: a rotating hole, a/M; below 0 the disc is retrograde");
    number_option(command, "--inclination", options.inclination_deg, 0, 180,
                  "Between the line of sight and the axis, degrees (default: the scene's camera.theta, or 30)");
    command.add_option(
        "--inner", &options.inner,
        "Inner rim, r_s = 2 GM/c^2, or isco, the innermost stable orbit (default: the scene's, or isco); within "
        "isco matter falls");
    number_option(command, "--outer", options.outer, 0, kFarthestRim, "Outer rim, r_s (default: the scene's, or 200)");
    number_option(command, "--ring", options.ring, 0, kFarthestRim,
                  "One ring of this radius, r_s, instead of the disc: its profile and the extremes of its g");
    command.add_option(
        "--emissivity", &options.emissivity,
        "q of an emissivity r^-q; Q:R:Q or Q:R:Q:R:Q with breaks at R, r_s; thermal, the flux of an accreting disc "
        "(Page "
        "and Thorne); lamp:HEIGHT or lamp:HEIGHT:INDEX, a lamp post; FILE.csv, a table (default: the scene's "
        "disc.emissivity, or 3)");
    text_option(
        command, "--limb", options.limb,
        "Emission by the cosine mu to the disc's normal: isotropic (1), laor (1 + 2.06 mu), haardt (ln(1 + 1/mu))",
        {"isotropic", "laor", "haardt"});
    number_option(command, "--line", options.line_kev, 1e-9, 1e9,
                  "Rest energy of the line, keV (iron: 6.4); the axis then shows energies");
    number_option(command, "--bins", options.bins, 1, 100000, "Number of bins, of equal width");
    number_option(command, "--from", options.from, 0, 1e10,
                  "First bin's lower end, g = observed over emitted frequency, or keV with --line (default: where the "
                  "profile begins)");
    number_option(command, "--to", options.to, 0, 1e10, "Last bin's upper end (default: where the profile ends)");
}

}  // namespace nullscope::cli
