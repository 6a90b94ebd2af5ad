// Scene, disc, sky, light and spacetime: what is there. The camera's sections are in camera_sections.cpp.
#include "viewer/sections.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "scenefile/scene_keys.h"
#include "spacetime/registry.h"
#include "viewer/critical_overlay.h"
#include "viewer/heat_rows.h"
#include "viewer/length_fields.h"
#include "viewer/panel_rows.h"
#include "viewer/potential_plot.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr double kLeastBrightness = 0.01, kMostBrightness = 100.0;

// Whether g changes what anything here looks like.
bool spectra_matter(Scene scene) {
    scene.light.shift = scene.light.beaming = scene.light.doppler = scene.light.gravity = true;
    const EffectSet effects = effect_set(required_effects(scene));
    return effects.contains(Effect::kShift) || effects.contains(Effect::kBeaming) ||
           effects.contains(Effect::kSkyShift) || effects.contains(Effect::kSpot);
}

bool moves(const CameraSpec& camera) {
    return length(camera.velocity) > 0.0 || camera.observer != ObserverKind::kStatic;
}

}  // namespace

bool spacetime_rows(SpacetimeSpec& spec, const char* label, const char* id, bool escape) {
    bool changed = false;
    const MetricEntry* entry = find_metric(spec.metric);
    row(label, entry != nullptr ? std::string(entry->help) : "");
    choice(id, spec.metric, escape, [&] {
        for (const MetricEntry& other : metric_registry()) {
            if (!choice_item(std::string(other.key), &other == entry, std::string(other.help)) || &other == entry)
                continue;
            spec = {std::string(other.key), {}};
            changed = true;
        }
    });
    if (entry == nullptr || changed) return changed;
    for (const MetricParameter& parameter : entry->parameters) {
        const std::string name(parameter.name);
        const auto set = spec.parameters.find(name);
        double value = set != spec.parameters.end() ? set->second : parameter.fallback;
        const bool wide = parameter.low > 0.0 && parameter.high > 100.0 * parameter.low;
        if (!slide(name.c_str(), value, parameter.low, parameter.high, "%.4g", std::string(parameter.help),
                   wide ? Scale::kLogarithmic : Scale::kLinear))
            continue;
        spec.parameters[name] = value;
        changed = true;
    }
    return changed;
}

void scene_section(ViewState& view, bool escape) {
    const float button = ImGui::CalcTextSize("Reload").x + 2.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
    const bool open = choice("##scene", view.scene.name, escape, [&] {
        for (const std::string& file : view.own)
            if (choice_item(file, file == view.source, "A file of your own.")) view.wanted = file;
        for (const SceneInfo& info : view.shipped)
            if (choice_item(info.name, info.name == view.source, info.description)) view.wanted = info.name;
    });
    if (!open) tooltip(view.scene.description);
    ImGui::SameLine();
    if (ImGui::Button("Reload")) view.wanted = view.source;
    tooltip("Reads the scene file again; changes made here are lost.");
    if (!view.error.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, packed(palette().refusal));
        ImGui::TextWrapped("%s", view.error.c_str());
        ImGui::PopStyleColor();
    }
}

bool disc_section(ViewState& view, bool escape) {
    bool on = view.scene.disc.has_value();
    bool changed = tick("Shown", on);
    if (changed) {
        if (view.scene.disc) view.hidden_disc = *view.scene.disc;
        view.scene.disc = on ? std::optional<DiscSpec>(view.hidden_disc) : std::nullopt;
    }
    if (!view.scene.disc) return changed;
    constexpr double kNarrow = 0.999;  // inner over outer at most
    DiscSpec& disc = *view.scene.disc;
    const auto spacetime = spacetime_of(view.scene);
    const NumberStyle style = spacetime ? style_in(view.scene, *spacetime, view.numbers) : NumberStyle();
    KeyRange inner = key_range("disc.inner"), outer = key_range("disc.outer");
    inner.high = kNarrow * disc.outer, outer.low = disc.inner / kNarrow, outer.open_low = false;
    changed |= drag_length("Inner", disc.inner, 0.02, inner, (1.0 - kNarrow) * disc.outer, inner.high, style,
                           "Inner radius. 3 r_s is the innermost stable circular orbit of a hole without spin.");
    changed |= drag_length("Outer", disc.outer, 0.05, outer, outer.low, outer.high, style, "Outer radius.");
    bool thermal = disc.emission == DiscEmission::kThermal;
    changed |= tick("Thermal", thermal, "Thermal emission, by accretion or what else heats it, times an image.");
    disc.emission = thermal ? DiscEmission::kThermal : DiscEmission::kImage;
    if (thermal) {
        const double horizon = spacetime ? spacetime->horizon_radius().value_or(0.0) : 0.0;
        changed |= heat_rows(disc, horizon, style, escape);
    }
    if (thermal && disc.accretion) {
        changed |= slide_key("disc.mass", "Mass", disc.accretion->mass_suns, 1.0, 1e10, "%.3g suns",
                             "Mass of the hole; together with the accretion rate it sets the temperature.",
                             Scale::kLogarithmic);
        changed |= slide_key("disc.accretion_rate", "Accretion", disc.accretion->rate_eddington, 1e-6, 100.0, "%.3g",
                             "Accretion rate over the Eddington rate at an efficiency of 0.1.", Scale::kLogarithmic);
    } else if (thermal)
        changed |= slide_key("disc.temperature", "Temperature", disc.temperature_K, 2000.0, 50000.0, "%.0f K",
                             "Temperature of the hottest ring, in its own frame.", Scale::kLogarithmic);
    changed |= slide_key("disc.opacity", "Opacity", disc.opacity, 0.01, 1.0, "%.2f",
                         "Below 1, what lies behind shines through.");
    changed |= slide_key("disc.edge", "Edge", disc.edge, 0.0, 0.5, "%.2f",
                         "Width of the soft edge at both rims, as a fraction of the disc's width.");
    changed |=
        drag_key_degrees("disc.rotation", "Rotation", disc.rotation, "Rotation of the disc's image about its axis.");
    changed |= slide_key_degrees("disc.tilt", "Tilt", disc.lean.tilt, 0.0, 180.0,
                                 "Angle between the disc's axis and the z axis.");
    changed |= drag_key_degrees("disc.node", "Node", disc.lean.node,
                                "Azimuth where the disc rises through the equatorial plane.");
    changed |= slide_key("disc.brightness", "Brightness", disc.brightness, kLeastBrightness, kMostBrightness, "%.2f",
                         "Multiplies the disc's light.", Scale::kLogarithmic);
    return changed;
}

bool sky_section(ViewState& view, bool escape) {
    SkySpec& sky = view.scene.sky;
    bool changed = false;
    row("Kind",
        "The sky at infinity: the built-in stars and Milky Way (as a picture, or the stars as points), the scene's "
        "image, nothing, a procedural nebula, or a pattern.");
    choice("##sky", kSkyKindNames[static_cast<std::size_t>(sky.kind)], escape, [&] {
        for (std::size_t i = 0; i < std::size(kSkyKindNames); ++i) {
            const auto kind = static_cast<SkyKind>(i);
            if (kind == SkyKind::kFormula && view.loaded.sky.material.formula.empty()) continue;
            if (kind == SkyKind::kImage && view.loaded.sky.image.empty()) {
                ImGui::TextDisabled("image");
                tooltip("This scene file names no image (key image in [sky]).");
            } else if (choice_item(kSkyKindNames[i], kind == sky.kind)) {
                sky.kind = kind;
                changed = true;
            }
        }
    });
    if (sky.kind == SkyKind::kBlack) return changed;
    changed |= slide_key("sky.brightness", "Brightness", sky.brightness, kLeastBrightness, kMostBrightness, "%.2f",
                         "Multiplies the sky's light. The sky is rebuilt when you release the slider.",
                         Scale::kLogarithmic, When::kOnRelease);
    changed |= slide_key_degrees("sky.yaw", "Yaw", sky.yaw, -180.0, 180.0,
                                 "Rotation of the sky about the polar axis, after tilt.", When::kOnRelease);
    changed |= slide_key_degrees("sky.tilt", "Tilt", sky.tilt, -180.0, 180.0,
                                 "Rotation of the sky about the world's x axis.", When::kOnRelease);
    return changed;
}

namespace {

void probe_row(ViewState& view) {
    bool shown = is_open(view, kProbePanel);
    if (tick("Probe", shown, "The ray of the pixel under the cursor: its path, its numbers, both parts of g (key P)."))
        set_open(view, kProbePanel, shown);
}

}  // namespace

// What light does on its way and before the display shows it: switches to teach with, and the picture's development.
bool light_section(ViewState& view, bool escape) {
    LightSpec& light = view.scene.light;
    PictureSpec& picture = view.scene.picture;
    const auto spacetime = spacetime_of(view.scene);
    const bool rotates = spacetime != nullptr && spacetime->rotates();
    bool changed = tick_if(!rotates, "Lensing", light.lensing,
                           "Light follows the geodesics of the metric. Off: it travels straight, past a black sphere "
                           "as large as the horizon; all else is unchanged.",
                           "Not for a rotating hole: compare it with another spacetime (X), or set its spin to 0.");
    const bool heat = spectra_matter(view.scene);
    constexpr const char* kNoHeat =
        "No effect: this scene has no thermal emission (disc.emission = thermal, hot spots, point stars, or a sky with "
        "a temperature).";
    changed |= tick_if(heat, "Shift", light.shift,
                       "Doppler and gravitational shift change the colour of thermal emission: a thermal disc, hot "
                       "spots, point stars.",
                       kNoHeat);
    changed |= tick_if(heat, "Beaming", light.beaming,
                       "Doppler and gravitational shift change the brightness of thermal emission.", kNoHeat);
    changed |= tick_if(heat, "Doppler", light.doppler,
                       "The redshift factor g includes the Doppler shift: the motion of matter and camera.", kNoHeat);
    changed |=
        tick_if(heat, "Gravity", light.gravity, "The redshift factor g includes the gravitational shift.", kNoHeat);
    changed |= tick_if(moves(view.scene.camera), "Aberration", light.aberration,
                       "The camera's motion changes the directions from which light arrives.",
                       "No effect: the camera is at rest.");
    changed |= tick_if(heat, "Bolometric", light.bolometric,
                       "Brightness is power at all wavelengths (bolometric) instead of visible light.", kNoHeat);
    constexpr std::array kTones = {"shoulder", "film", "neutral"};
    row("Tone", "Tone curve: how bright light is compressed.");
    choice("##tone", kTones[static_cast<std::size_t>(picture.tone)], escape, [&] {
        for (std::size_t i = 0; i < kTones.size(); ++i) {
            const auto tone = static_cast<ToneCurve>(i);
            if (choice_item(kTones[i], tone == picture.tone)) picture.tone = tone, changed = true;
        }
    });
    constexpr double kMostBloom = 0.5;
    changed |= slide_key("picture.bloom", "Bloom", picture.bloom, 0.0, kMostBloom, "%.2f",
                         "Fraction of the light that lens and eye scatter into a halo.");
    changed |= tick("Adapt", picture.auto_exposure, "Exposure adapts to the picture's mean luminance.");
    changed |=
        tick("Dither", picture.dither, "Adds noise of half an 8-bit step, so that dark gradients show no bands.");
    constexpr std::array kSamples = {"1", "2 x 2", "3 x 3", "4 x 4"};
    const auto samples = static_cast<std::size_t>(picture.samples);
    row("Rays a pixel", "More of them make edges and thin rings smooth, once the camera rests.");
    choice("##samples", samples <= kSamples.size() ? kSamples[samples - 1] : fmt::format("{0} x {0}", samples).c_str(),
           escape, [&] {
               for (std::size_t i = 0; i < kSamples.size(); ++i)
                   if (choice_item(kSamples[i], i + 1 == samples))
                       picture.samples = static_cast<int>(i) + 1, changed = true;
           });
    changed |= tick("Grid", view.show_grid, "Coordinate lines on the sky and the disc instead of their images.");
    probe_row(view);
    if (bool shown = shows(view, kCriticalOverlay); tick("Critical", shown, kCriticalOverlay.help))
        toggle(view, kCriticalOverlay);
    tick_if(is_open(view, kProbePanel), "Potential", view.show_potential, kPotentialHelp, "Only with the probe.");
    return changed;
}

bool spacetime_section(ViewState& view, bool escape) {
    Scene& scene = view.scene;
    bool changed = spacetime_rows(scene.spacetime, "Metric", "##metric", escape);
    bool split = scene.split.has_value();
    changed |= tick("Split screen", split, "The right half of the picture shows the same scene in another spacetime.");
    if (split != scene.split.has_value())
        scene.split = split ? std::optional(SpacetimeSpec{"minkowski", {}}) : std::nullopt;
    if (scene.split) {
        ImGui::PushID("split");  // its parameters may have the same names
        changed |= spacetime_rows(*scene.split, "Right half", "##split", escape);
        ImGui::PopID();
    }
    if (changed) scene.split_labels = {scene.split_labels.shown};  // what the file says may be true no more
    if (scene.split) changed |= tick("Labels", scene.split_labels.shown, "Each half says what differs.");
    if (changed) keep_outside_horizon(scene);
    return changed;
}

}  // namespace nullscope::viewer
