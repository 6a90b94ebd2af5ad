// nullscope light-time: how long light takes past a mass, and how much of that is Shapiro's delay.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "cli/command.h"
#include "reference/light_time.h"
#include "reference/orbit.h"

namespace nullscope::cli {
namespace {

constexpr double kSun_m = 2953.250077, kLight_m_s = 299792458.0;  // r_s of the Sun; c

struct LightTimeOptions {
    double from = 500, to = 500, impact = 5;
    std::optional<double> mass_suns;
};

// Between two places at these radii, `angle` apart.
double chord(double a, double b, double angle) {
    return std::hypot(a - b, 2 * std::sqrt(a * b) * std::sin(0.5 * angle));
}

Result<int> run_light_time(const LightTimeOptions& options) {
    const double unit_m = options.mass_suns ? *options.mass_suns * kSun_m : 0;  // r_s in m
    const double scale = options.mass_suns ? 1000 / unit_m : 1;                 // of the lengths given, in r_s
    const double from = options.from * scale, to = options.to * scale, impact = options.impact * scale;
    constexpr double kCritical = 2.5980762113533159;  // 3 sqrt(3)/2
    if (!(impact > kCritical))
        return bad_input(fmt::format("--impact {}: light that close falls into the hole", options.impact),
                         fmt::format("above {:.6g}", kCritical / scale));
    TRY(made, reference::make_metric({"schwarzschild", {}}));
    const auto passage = reference::light_past(*(*made)->orbits(), from, to, impact);
    if (!passage)
        return bad_input(
            fmt::format("--from {} --to {} --impact {}: the closest approach is farther out than these distances",
                        options.from, options.to, options.impact),
            "smaller impact parameters");
    const auto [t, closest, angle] = *passage;
    constexpr double kMass = 0.5;  // in r_s: harmonic radius r - M
    const double by_r = t - chord(from, to, angle), harmonic = t - chord(from - kMass, to - kMass, angle);
    fmt::print("coordinate time      {:.15g} r_s/c, {:.15g} GM/c^3\n", t, 2 * t);
    fmt::print("closest approach     {:.15g} r_s\n", closest);
    fmt::print("delay over the chord {:.10g} r_s/c in Schwarzschild's r, {:.10g} in the harmonic r - GM/c^2\n", by_r,
               harmonic);
    if (!options.mass_suns) return 0;
    const double unit_us = 1e6 * unit_m / kLight_m_s;
    fmt::print("4 GM/c^3             {:.9g} us; delay to first order, 2 GM/c^3 ln(4 r1 r2/b^2): {:.9g} us\n",
               2 * unit_us, unit_us * std::log(4 * from * to / (impact * impact)));
    fmt::print("coordinate time      {:.15g} s\n", 1e-6 * t * unit_us);
    fmt::print("delay over the chord {:.8g} us in Schwarzschild's r, {:.8g} us in the harmonic one\n", by_r * unit_us,
               harmonic * unit_us);
    return 0;
}

}  // namespace

void add_light_time(Command& parent) {
    auto [command, options] = add_command<LightTimeOptions>(
        parent, "light-time",
        "Light-travel time past a mass, and its Shapiro delay over the straight chord; by the reference tracer",
        run_light_time);
    number_option(command, "--from", options.from, 1.6, 1e15,
                  "Distance of the source from the mass, r_s (km with --mass-suns)");
    number_option(command, "--to", options.to, 1.6, 1e15,
                  "Distance of the receiver from the mass, on the far side of the closest approach");
    number_option(command, "--impact", options.impact, 1e-3, 1e15, "Impact parameter");
    number_option(command, "--mass-suns", options.mass_suns, 1e-6, 1e12,
                  "Mass in solar masses: lengths are then in km, and times also in s");
}

}  // namespace nullscope::cli
