// The numbers that textbooks name: radii of the spacetime, clocks and angles of the camera.
#include <fmt/format.h>
#include <imgui.h>

#include <numbers>

#include "observer/landmarks.h"
#include "viewer/sections.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr double kRadiusOfSun_km = 2.95325;  // r_s of one solar mass, 2 G M/c^2

void number(const char* name, const std::string& value, const char* help) {
    ImGui::BeginGroup();
    text_row(name);
    ImGui::TextUnformatted(value.c_str());
    ImGui::EndGroup();
    tooltip(help);
}

// In r_s and in M = r_s/2, and in km where the scene says a mass; of wormholes in their own unit.
std::string radius_words(double r, const Spacetime& spacetime, const ObjectSpec& object) {
    if (spacetime.by_proper_length()) return fmt::format("{:.5g}", r);
    std::string words = fmt::format("{:.5g} r_s = {:.5g} M", r, 2.0 * r);
    if (object.mass_suns) words += fmt::format("\n{:.4g} km", r * kRadiusOfSun_km * *object.mass_suns);
    return words;
}

}  // namespace

bool numbers_section(ViewState& view) {
    const Scene& scene = view.scene;
    const auto spacetime = spacetime_of(scene);
    if (spacetime == nullptr) return false;
    const Landmarks marks = landmarks_of(*spacetime);
    const auto radius = [&](const char* name, const std::optional<double>& r, const char* help) {
        if (r) number(name, radius_words(*r, *spacetime, scene.object), help);
    };
    radius("Horizon", marks.horizon, "Nothing comes back from inside it. About a rotating hole: the outer one.");
    const bool rotates = spacetime->axial() != nullptr;
    radius("Photon orbit", marks.photon_orbit,
           rotates ? "Prograde: where light can run in a circle with the rotation of the hole, in the equatorial plane."
                   : "Where light can run in a circle.");
    radius("retrograde", marks.retrograde_photon_orbit, "Where light can run in a circle against the hole's rotation.");
    radius("ISCO", marks.isco,
           rotates ? "Prograde: innermost stable circular orbit of matter with the rotation of the hole."
                   : "Innermost stable circular orbit of matter.");
    radius("retrograde", marks.retrograde_isco,
           "Innermost stable circular orbit of matter against the hole's rotation.");
    if (scene.light.lensing)
        radius(
            "Critical b", marks.critical_impact,
            "Impact parameter of the light that spirals to the photon sphere: the radius of the shadow, seen from far "
            "away.");
    if (!marks.horizon && !marks.photon_orbit && !marks.isco)
        paragraph("This spacetime has no horizon and no orbits to name.");
    ImGui::Separator();
    const CameraNumbers here = camera_numbers(*spacetime, scene.camera);
    if (here.shadow && scene.light.lensing)
        number("Shadow", fmt::format("{:.3f}\xc2\xb0", *here.shadow * 180.0 / std::numbers::pi),
               "Angular radius of the shadow, seen from here at rest.");
    if (const auto size = here.shadow_size; size && scene.light.lensing)
        number("Shadow",
               fmt::format("{:.3f}\xc2\xb0 wide\n{:.3f}\xc2\xb0 high", (*size)[0] * 180.0 / std::numbers::pi,
                           (*size)[1] * 180.0 / std::numbers::pi),
               "Angular diameters of the shadow in the direction of the rotation and across it, seen from here by an "
               "observer without angular momentum.");
    if (here.clock_rate)
        number("Clock", fmt::format("{:.6f}", *here.clock_rate),
               "Proper time of the camera over time far away, dtau/dt.");
    else if (here.lapse)
        number("Clock", fmt::format("{:.6f} at rest", *here.lapse),
               "Proper time over time far away, of an observer at rest here.");
    if (here.lapse && *here.lapse > 0.0)
        number("Blueshift", fmt::format("{:.6g}", 1.0 / *here.lapse),
               "g of light from far away, seen from here at rest: frequency over that at its source.");
    if (here.orbit_speed)
        number("Orbit speed", fmt::format("{:.5f} c", *here.orbit_speed),
               "Of a circular geodesic here, measured by observers at rest.");
    if (here.orbit_period)
        number("Orbit period", fmt::format("{:.5g} r_s/c", *here.orbit_period),
               "Of a circular geodesic here, in time far away.");
    return false;
}

}  // namespace nullscope::viewer
