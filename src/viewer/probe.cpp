#include "viewer/probe.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "scene/bodies.h"
#include "viewer/view_state.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr int kPathPoints = 400;
constexpr double kFarthest = 16.0;  // r_s that the inset shows at most
constexpr float kLines = 11.0f;     // of words below it
constexpr double kWide = 1.25;      // of the camera's radius that it shows

std::string number(double value, const char* unit = "") {
    return std::isfinite(value) ? fmt::format("{:.6g}{}", value, unit) : "none";
}

std::string words_of(const ProbeFacts& facts, const Scene& scene) {
    if (facts.hit == kStarHit) return "the star's surface";
    if (facts.hit != 0) return object_name(scene, facts.hit);
    switch (facts.fate) {
        case Fate::kEscaped: return "sky";
        case Fate::kOtherSide: return "the far side's sky";
        case Fate::kCaptured: return "the horizon";
        default: return "nothing";
    }
}

// The ray's plane: hole, photon sphere, where the disc's plane is met, the ray and its turning point.
void draw_path(const ProbeFacts& facts, const Spacetime& spacetime, const Scene& scene, float side) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const double camera = 1 / facts.zeta0, shown = std::min(kFarthest, kWide * camera);
    const float scale = 0.5f * side / static_cast<float>(shown);
    const ImVec2 middle{corner.x + 0.5f * side, corner.y + 0.5f * side};
    const auto at = [&](double x, double y) {
        return ImVec2(middle.x + scale * static_cast<float>(x), middle.y - scale * static_cast<float>(y));
    };
    const ImU32 quiet = ImGui::GetColorU32(ImGuiCol_TextDisabled), bright = ImGui::GetColorU32(ImGuiCol_Text);
    draw.AddRectFilled(corner, {corner.x + side, corner.y + side}, IM_COL32(6, 8, 14, 255));
    draw.PushClipRect(corner, {corner.x + side, corner.y + side}, true);
    if (const auto sphere = spacetime.photon_sphere())
        draw.AddCircle(middle, scale * static_cast<float>(spacetime.areal_radius(sphere->radius)), quiet, 64, 1.0f);
    if (const auto horizon = spacetime.horizon_radius())
        draw.AddCircleFilled(middle, scale * static_cast<float>(*horizon), IM_COL32(90, 96, 110, 255), 48);
    if (scene.disc && facts.disc) {  // the disc's plane cuts this one along a line
        const double c = std::cos(*facts.disc), s = std::sin(*facts.disc), in = scene.disc->inner,
                     out = scene.disc->outer;
        for (const double way : {1.0, -1.0})
            draw.AddLine(at(way * in * c, way * in * s), at(way * out * c, way * out * s), IM_COL32(255, 176, 96, 200),
                         2.0f);
    }
    for (std::size_t i = 1; i < facts.path.size(); ++i)
        draw.AddLine(at(facts.path[i - 1][0], facts.path[i - 1][1]), at(facts.path[i][0], facts.path[i][1]),
                     IM_COL32(120, 200, 255, 255), 1.5f);
    if (!facts.path.empty() && std::isfinite(facts.turn_r)) {
        const auto nearest =
            std::ranges::min_element(facts.path, {}, [](const auto& place) { return std::hypot(place[0], place[1]); });
        draw.AddCircle(at((*nearest)[0], (*nearest)[1]), 3.5f, bright);
    }
    draw.AddCircleFilled(at(std::min(camera, shown), 0), 3.0f, bright);  // the camera, or the edge towards it
    draw.PopClipRect();
    ImGui::Dummy({side, side});
}

void line(const char* name, const std::string& value) {
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine(8.0f * ImGui::GetFontSize());
    ImGui::TextUnformatted(value.c_str());
}

}  // namespace

// A tracer follows the whole scene; how matter moves, the spacetime and the disc alone.
bool Probe::follow(const Scene& scene) {
    const bool other_matter = !spacetime_ || !(scene.spacetime == scene_.spacetime) || scene.disc != scene_.disc ||
                              !(scene.light == scene_.light);
    auto made = reference::FrameTracer::make(scene);
    const auto spacetime = spacetime_of(scene);
    if (!made || spacetime == nullptr) return false;
    tracer_.emplace(std::move(*made));
    spacetime_ = spacetime;
    if (other_matter) {
        matter_.reset();
        auto metric = reference::make_metric(scene.spacetime);
        if (!metric) return false;
        metric_ = std::move(*metric);
        DiscSpec dark;  // its heat is not asked for
        dark.outer = 0.0;
        if (scene.disc && scene.disc->emission == DiscEmission::kThermal) matter_.emplace(*metric_, dark, scene.light);
    }
    scene_ = scene;
    return true;
}

void Probe::look(const Scene& scene, double x, double y) {
    facts_.reset();
    if (x < 0 || y < 0 || x >= scene.camera.width || y >= scene.camera.height || !follow(scene)) return;
    facts_ = facts_of(*tracer_->ray(x, y));
}

void Probe::meet_disc(const reference::TracedRay& ray, const reference::DiscHit& hit, ProbeFacts& facts) const {
    facts.hit = kDiscHit;
    facts.hit_r = std::hypot(hit.x, hit.y);
    if (!matter_) return;
    const reference::Shift matter = matter_->shift({facts.hit_r, ray.l_z, hit.climb});
    facts.shift = reference::Shift{ray.shift.gravity * matter.gravity, ray.shift.doppler * matter.doppler};
}

ProbeFacts Probe::facts_of(const reference::TracedRay& ray) const {
    ProbeFacts facts;
    facts.fate = ray.fate();
    facts.zeta0 = 1 / spacetime_->areal_radius(scene_.camera.r);
    facts.shift = ray.shift;
    const reference::PlaneRay* plane = ray.in_plane();
    double end = ray.end();
    const auto hits = tracer_->disc_hits(ray, 1);
    const auto body = ray.first_hit();
    if (!hits.empty() && !(body && body->along < hits.front().along)) {
        meet_disc(ray, hits.front(), facts);
        if (scene_.disc->opacity == 1) end = hits.front().along;
    } else if (body) {
        facts.hit = body->number;
        facts.hit_r = length(body->place);
        end = body->along;
        if (plane) facts.shift->gravity *= plane->metric().lapse(facts.hit_r);  // it rests
    } else if (facts.fate == Fate::kHit) {
        facts.hit = kStarHit;
        facts.shift->gravity *= plane->metric().lapse(plane->radius_at(end * (1 - 1e-12)));
    } else if (facts.fate == Fate::kCaptured) {
        facts.shift.reset();
    } else {
        facts.delay = ray.delay();
    }
    if (!plane) return facts;  // no orbit, no q
    const reference::Orbit& orbit = plane->orbit();
    const auto radius = [&](double zeta) {
        return plane->metric().by_proper_length() ? spacetime_->areal_radius(zeta) : 1 / zeta;
    };
    facts.q = std::fabs(plane->photon().q);
    if (const auto sphere = spacetime_->photon_sphere())
        facts.critical = -std::log(std::fabs(1 - facts.q / sphere->q_crit));
    if (std::isfinite(orbit.turn())) facts.turn_r = radius(orbit.turn());
    if (!std::isfinite(end)) return facts;
    facts.windings = end / (2 * M_PI);
    for (int i = 0; i <= kPathPoints; ++i) {
        const double angle = end * i / kPathPoints, r = radius(orbit.zeta_at(std::min(angle, end * (1 - 1e-9))));
        if (std::isfinite(r)) facts.path.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    if (const double met = plane->plane().crossing(1); met <= end * (1 + 1e-9)) facts.disc = met;
    return facts;
}

void Probe::draw(float bottom) const {
    if (!facts_ || !spacetime_) return;
    const float em = ImGui::GetFontSize(), margin = 0.6f * em;
    overlay("##probe", ImGui::GetIO().DisplaySize.x - margin, bottom - margin, 1.0f, 1.0f, 0.92f, [&] {
        const ProbeFacts& f = *facts_;
        const float room = bottom - 2.0f * margin - kLines * ImGui::GetTextLineHeightWithSpacing() - em;
        draw_path(f, *spacetime_, scene_, std::clamp(room, 5.0f * em, 15.0f * em));
        line("Seen", words_of(f, scene_) + (std::isfinite(f.hit_r) ? fmt::format(" at {:.4g} r_s", f.hit_r) : ""));
        line("q", number(f.q));
        line("zeta_0", number(f.zeta0));
        line("Q", number(f.critical));
        line("Turning point", number(f.turn_r, " r_s"));
        line("Windings", number(f.windings));
        const reference::Shift g = f.shift.value_or(reference::Shift{kNotANumber, kNotANumber});
        line("g", number(g.gravity * g.doppler));
        line("  gravity", number(g.gravity));
        line("  Doppler", number(g.doppler));
        line("Delay", number(f.delay, " r_s/c"));
    });
}

}  // namespace nullscope::viewer
