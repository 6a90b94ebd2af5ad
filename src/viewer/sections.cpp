// Scene, disc, sky and spacetime: what is there. The camera's sections are in camera_sections.cpp.
#include "viewer/sections.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "spacetime/registry.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr double kLeastBrightness = 0.01, kMostBrightness = 100.0;

void parameters_of(const MetricEntry& entry, SpacetimeSpec& spec, bool& changed) {
    for (const MetricParameter& parameter : entry.parameters) {
        const std::string name(parameter.name), help(parameter.help);
        const auto set = spec.parameters.find(name);
        double value = set != spec.parameters.end() ? set->second : parameter.fallback;
        if (slide(name.c_str(), value, parameter.low, parameter.high,
                  parameter.low > 0.0 && parameter.high > 100.0 * parameter.low ? Scale::kLogarithmic : Scale::kLinear,
                  When::kNow, "%.4g", help.c_str())) {
            spec.parameters[name] = value;
            changed = true;
        }
    }
}

}  // namespace

bool scene_section(ViewState& view, bool escape) {
    bool changed = false;
    const float button = ImGui::CalcTextSize("Reload").x + 2.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
    const bool open = begin_choice("##scene", view.source, escape);
    if (!open) tooltip(view.scene.description.c_str());
    if (open) {
        for (const SceneInfo& info : view.shipped)
            if (choice_item(info.name, info.name == view.source, info.description))
                changed = static_cast<bool>(load_into(view, info.name));
        end_choice();
    }
    ImGui::SameLine();
    if (ImGui::Button("Reload")) changed = static_cast<bool>(load_into(view, view.source)) || changed;
    tooltip("Reads the scene's file again; changes made here are dropped.");
    if (!view.error.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, {1.0f, 0.52f, 0.45f, 1.0f});
        ImGui::TextWrapped("%s", view.error.c_str());
        ImGui::PopStyleColor();
    }
    return changed;
}

bool disc_section(ViewState& view) {
    bool on = view.scene.disc.has_value();
    bool changed = false;
    if (tick("Shown", on)) {
        if (view.scene.disc) view.hidden_disc = *view.scene.disc;
        view.scene.disc = on ? std::optional<DiscSpec>(view.hidden_disc) : std::nullopt;
        changed = true;
    }
    if (!view.scene.disc) return changed;
    constexpr double kNarrow = 0.999, kWidest = 1000.0;  // inner over outer at most; r_s
    DiscSpec& disc = *view.scene.disc;
    const auto any = [&changed](bool one) { changed = changed || one; };
    any(drag_number("Inner", disc.inner, 0.02, (1.0 - kNarrow) * disc.outer, kNarrow * disc.outer, "%.2f r_s",
                    "Inner radius. 3 r_s is the innermost stable circular orbit of a hole without spin."));
    any(drag_number("Outer", disc.outer, 0.05, disc.inner / kNarrow, std::max(kWidest, 2.0 * disc.inner), "%.2f r_s",
                    "Outer radius."));
    bool thermal = disc.emission == DiscEmission::kThermal;
    if (tick("Thermal", thermal,
             "It glows by the heat that matter gains on its way in; an image then gives emissivities.")) {
        disc.emission = thermal ? DiscEmission::kThermal : DiscEmission::kImage;
        changed = true;
    }
    if (thermal && disc.accretion) {
        any(slide("Mass", disc.accretion->mass_suns, 1.0, 1e10, Scale::kLogarithmic, When::kNow, "%.3g suns",
                  "Of the hole: with what falls in it gives the temperature."));
        any(slide("Accretion", disc.accretion->rate_eddington, 1e-6, 100.0, Scale::kLogarithmic, When::kNow, "%.3g",
                  "Rate over Eddington's at an efficiency of 0.1."));
    } else if (thermal)
        any(slide("Temperature", disc.temperature_K, 2000.0, 50000.0, Scale::kLogarithmic, When::kNow, "%.0f K",
                  "Of the hottest ring, in its own frame."));
    any(slide("Opacity", disc.opacity, 0.01, 1.0, Scale::kLinear, When::kNow, "%.2f",
              "Below 1, what lies behind shines through."));
    any(slide("Edge", disc.edge, 0.0, 0.5, Scale::kLinear, When::kNow, "%.2f",
              "Width of the fade at both rims, as a part of the disc's width."));
    any(drag_degrees("Rotation", disc.rotation, -360.0, 360.0, "Turn of the disc's image about its axis."));
    any(slide("Brightness", disc.brightness, kLeastBrightness, kMostBrightness, Scale::kLogarithmic, When::kNow, "%.2f",
              "Factor on the disc's light."));
    return changed;
}

bool sky_section(ViewState& view, bool escape) {
    SkySpec& sky = view.scene.sky;
    bool changed = false;
    row("Kind",
        "What is seen at infinity: the stars and Milky Way that ship (as a picture, or the stars as points), the "
        "scene's image, nothing, or a pattern.");
    if (begin_choice("##sky", kSkyKindNames[static_cast<int>(sky.kind)], escape)) {
        for (int i = 0; i < static_cast<int>(std::size(kSkyKindNames)); ++i) {
            const bool missing = i == static_cast<int>(SkyKind::kImage) && view.loaded.sky.image.empty();
            if (i == static_cast<int>(SkyKind::kFormula) && view.loaded.sky.look.formula.empty()) continue;
            if (missing) {
                ImGui::TextDisabled("image");
                tooltip("This scene's file names no image (key image in [sky]).");
            } else if (choice_item(kSkyKindNames[i], i == static_cast<int>(sky.kind))) {
                sky.kind = static_cast<SkyKind>(i);
                changed = true;
            }
        }
        end_choice();
    }
    if (sky.kind == SkyKind::kBlack) return changed;
    constexpr double kDegree = 0.017453292519943295;
    double yaw = sky.yaw / kDegree, tilt = sky.tilt / kDegree;
    if (slide("Brightness", sky.brightness, kLeastBrightness, kMostBrightness, Scale::kLogarithmic, When::kOnRelease,
              "%.2f", "Factor on the sky's light. The sky is made anew when you let go."))
        changed = true;
    if (slide("Yaw", yaw, -180.0, 180.0, Scale::kLinear, When::kOnRelease, "%.1f\xc2\xb0",
              "Turn of the sky about the polar axis, after tilt.")) {
        sky.yaw = yaw * kDegree;
        changed = true;
    }
    if (slide("Tilt", tilt, -180.0, 180.0, Scale::kLinear, When::kOnRelease, "%.1f\xc2\xb0",
              "Turn of the sky about the world's x axis.")) {
        sky.tilt = tilt * kDegree;
        changed = true;
    }
    return changed;
}

namespace {
bool spacetime_rows(SpacetimeSpec& spec, const char* label, const char* id, bool escape) {
    bool changed = false;
    const MetricEntry* entry = find_metric(spec.metric);
    row(label, entry != nullptr ? std::string(entry->help).c_str() : nullptr);
    if (begin_choice(id, spec.metric, escape)) {
        for (const MetricEntry& other : metric_registry()) {
            if (!choice_item(std::string(other.key), &other == entry, std::string(other.help)) || &other == entry)
                continue;
            spec = {std::string(other.key), {}};
            changed = true;
        }
        end_choice();
    }
    if (entry != nullptr && !changed) parameters_of(*entry, spec, changed);
    return changed;
}
}  // namespace

bool spacetime_section(ViewState& view, bool escape) {
    Scene& scene = view.scene;
    bool changed = spacetime_rows(scene.spacetime, "Metric", "##metric", escape);
    bool split = scene.beside.has_value();
    if (tick("Split screen", split, "The right half of the picture shows the same in another spacetime.")) {
        if (split)
            scene.beside = SpacetimeSpec{"minkowski", {}};
        else
            scene.beside.reset();
        changed = true;
    }
    if (scene.beside) {
        ImGui::PushID("beside");  // its parameters may have the same names
        changed = spacetime_rows(*scene.beside, "Beside it", "##beside", escape) || changed;
        ImGui::PopID();
    }
    if (changed) keep_outside_horizon(scene);
    return changed;
}

}  // namespace nullscope::viewer
