// The numbers that textbooks name: radii of the spacetime, clocks and angles of the camera.
#include <imgui.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "observer/landmarks.h"
#include "viewer/clock_overlay.h"
#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

void number(const char* name, const std::string& value, const char* help) {
    ImGui::BeginGroup();
    text_row(name);
    ImGui::TextUnformatted(value.c_str());
    ImGui::EndGroup();
    tooltip(help);
}

void style_rows(NumberStyle& wish, const Scene& scene, const Spacetime& spacetime) {
    const bool own = spacetime.by_proper_length();
    ImGui::BeginDisabled(own);
    row("Units",
        own ? "Lengths in wormholes have no unit."
            : "Of lengths and times in panels, probe and clocks: r_s = 2 GM/c\u00b2, M = GM/c\u00b2, or km and seconds "
              "for a mass. Files stay in r_s, and the scene editor shows r_s first.");
    for (std::size_t i = 0; i < std::size(kLengthUnitNames); ++i) {
        if (i > 0) ImGui::SameLine();
        if (ImGui::RadioButton(kLengthUnitNames[i], wish.unit == static_cast<LengthUnit>(i)))
            wish.unit = static_cast<LengthUnit>(i);
    }
    ImGui::EndDisabled();
    if (wish.unit == LengthUnit::kKilometre && !own) {
        double suns = scene.object.mass().value_or(wish.mass_suns);
        ImGui::BeginDisabled(scene.object.mass().has_value());
        if (type_number("Mass", suns, kLeastMass_suns, kMostMass_suns, "%.6g suns",
                        scene.object.mass() ? "Set by the scene's [object]." : "Mass of the hole for km and seconds."))
            wish.mass_suns = suns;
        ImGui::EndDisabled();
    }
    row("Decimals",
        "With a decimal point or a decimal comma here, in the probe and in the clocks; files keep the point.");
    for (const bool comma : {false, true}) {
        if (comma) ImGui::SameLine();
        if (ImGui::RadioButton(comma ? "comma" : "point", wish.decimal_comma == comma)) wish.decimal_comma = comma;
    }
    ImGui::Separator();
}

// On the sky, of the whole picture.
void polarisation_rows(const FrameFacts& facts, const NumberStyle& style) {
    if (!has_polarisation_numbers(facts.painting.job.scene)) return;
    ImGui::Separator();
    const PolarisationNumbers* found = facts.polarisation;
    const auto row_of = [&](const std::string& name, const auto& words, const char* help) {
        number(name.c_str(), found != nullptr ? words(*found) : "...", help);
    };
    const auto percent = [&](double part) { return fixed_words(100.0 * part, style, 2) + " %"; };
    row_of(
        "Net linear", [&](const PolarisationNumbers& n) { return percent(n.measures.net); },
        "|sum of Q + iU| over the sum of I, of the whole picture: what a telescope measures that does not resolve it. "
        "Measured at rest on at most 320 x 320 rays.");
    row_of(
        "Resolved", [&](const PolarisationNumbers& n) { return percent(n.measures.resolved); },
        "Sum of |Q + iU| over the sum of I: the mean over the picture where it is resolved.");
    row_of(
        "beta_2",
        [&](const PolarisationNumbers& n) {
            return fixed_words(std::abs(n.measures.beta_2), style, 3) + " at " +
                   fixed_words(180.0 / std::numbers::pi * std::arg(n.measures.beta_2), style, 1) + "\u00b0";
        },
        "How the electric vectors wind about the line of sight: sum of (Q + iU) exp(-2 i phi) over the sum of I. At 0 "
        "degrees they are radial, at 180 degrees they go round, at 90 and -90 degrees they are spirals.");
    if (has_polarised_medium(facts.painting.job.scene))
        row_of(
            "Net circular", [&](const PolarisationNumbers& n) { return percent(n.measures.circular); },
            "Sum of V over the sum of I.");
    if (found == nullptr) return;
    for (const RotationMeasure& rm : found->rotations)
        row_of(
            "RM",
            [&](const PolarisationNumbers&) {
                return number_words(rm.rad_m2, style, 4) + " rad/m\u00b2\n" + number_words(rm.low_GHz, style) + " to " +
                       number_words(rm.high_GHz, style) + " GHz";
            },
            "Rotation measure of the whole picture's light: how far its angle turns with the wavelength squared "
            "between "
            "the two frequencies, of all that the angles allow the smallest.");
}

}  // namespace

bool numbers_section(ViewState& view, const FrameFacts& facts) {
    const Scene& scene = view.scene;
    const auto spacetime = spacetime_of(scene);
    if (spacetime == nullptr) return false;
    style_rows(view.numbers, scene, *spacetime);
    const NumberStyle style = style_in(scene, *spacetime, view.numbers);
    const Landmarks marks = landmarks_of(*spacetime);
    const auto radius = [&](const char* name, const std::optional<double>& r, const char* help) {
        if (r) number(name, length_words(*r, style, 5), help);
    };
    if (marks.singular)
        radius("Singularity", marks.horizon, "A surface of no area and no horizon about it; light ends there.");
    else
        radius("Horizon", marks.horizon, "Nothing comes back from inside it. About a rotating hole: the outer one.");
    const char* other = spacetime->a() < 0.0 ? "prograde" : "retrograde";
    radius("Photon orbit", marks.photon_orbit, "Circular photon orbit; about a rotating hole towards growing azimuth.");
    radius(other, marks.retrograde_photon_orbit, "Circular photon orbit towards falling azimuth.");
    radius("ISCO", marks.isco,
           "Innermost stable circular orbit of matter; about a rotating hole towards growing azimuth.");
    radius(other, marks.retrograde_isco, "Innermost stable circular orbit of matter towards falling azimuth.");
    if (scene.light.lensing)
        radius(
            "Critical b", marks.critical_impact,
            "Impact parameter of the light that spirals to the photon sphere: the radius of the shadow, seen from far "
            "away.");
    if (!marks.horizon && !marks.photon_orbit && !marks.isco)
        paragraph("This spacetime has no horizon, photon orbit or ISCO.");
    ImGui::Separator();
    const CameraNumbers here = camera_numbers(*spacetime, scene.camera);
    if (here.shadow && scene.light.lensing)
        number("Shadow", fixed_words(*here.shadow * 180.0 / std::numbers::pi, style, 3) + "\u00b0",
               "Angular radius of the shadow, seen from here at rest.");
    if (const auto size = here.shadow_size; size && scene.light.lensing)
        number("Shadow",
               fixed_words((*size)[0] * 180.0 / std::numbers::pi, style, 3) + "\u00b0 wide\n" +
                   fixed_words((*size)[1] * 180.0 / std::numbers::pi, style, 3) + "\u00b0 high",
               "Angular diameters of the shadow in the direction of the rotation and across it, seen from here by a "
               "zero-angular-momentum observer.");
    for (const ClockRow& row : clock_rows(view, *spacetime)) number(row.short_name, row.value, row.help);
    if (here.orbit_speed)
        number("Orbit speed", fixed_words(*here.orbit_speed, style, 5) + " c",
               "Of a circular geodesic here, measured by observers at rest.");
    if (here.orbit_period)
        number("Orbit period", time_words(*here.orbit_period, style),
               "Of a circular geodesic here, in the time of a distant observer.");
    polarisation_rows(facts, style);
    return false;
}

}  // namespace nullscope::viewer
