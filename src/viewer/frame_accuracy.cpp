#include "viewer/frame_accuracy.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "compare/heat_map.h"
#include "scene/effects.h"
#include "scene/moving.h"
#include "scene/named_surface.h"

namespace nullscope::viewer {
namespace {

constexpr double kRest = 0.2;  // s without a change before a frame is measured

// All of a camera that rays depend on.
auto lens_and_place(const CameraSpec& c) {
    return std::tie(c.r, c.theta, c.phi, c.yaw, c.pitch, c.roll, c.velocity.x, c.velocity.y, c.velocity.z, c.observer,
                    c.fall_from, c.energy, c.plane_width, c.focal_distance, c.width, c.height);
}

// The numbers of the solid bodies' forms.
std::vector<double> solids(const Scene& scene) {
    std::vector<double> numbers;
    const auto add = [&](std::initializer_list<double> row) {
        for (const double value : row) numbers.push_back(value);
    };
    if (const auto& s = scene.sphere) add({s->radius, s->swing, s->period});
    if (const auto& c = scene.cylinder) add({c->inner, c->outer, c->height});
    if (const auto& b = scene.ball)
        add({b->position.x, b->position.y, b->position.z, b->radius, static_cast<double>(b->motion), b->velocity.x,
             b->velocity.y, b->velocity.z});
    if (const auto& f = scene.surface) add({f->bound, static_cast<double>(f->steps)});
    return numbers;
}

// Colours and brightness apart.
bool same_rays(const Scene& a, const Scene& b) {
    if (lens_and_place(a.camera) != lens_and_place(b.camera) || a.spacetime != b.spacetime) return false;
    if (effect_set(required_effects(a)) != effect_set(required_effects(b)) || solids(a) != solids(b)) return false;
    if (a.light.aberration != b.light.aberration || a.light.doppler != b.light.doppler ||
        a.light.gravity != b.light.gravity)
        return false;
    if (a.surface && surface_shape(*a.surface) != surface_shape(*b.surface)) return false;
    if (!moving_parts(a).empty() && (a.time != b.time || a.light.delay != b.light.delay)) return false;
    if (a.disc.has_value() != b.disc.has_value()) return false;
    return !a.disc || (a.disc->inner == b.disc->inner && a.disc->outer == b.disc->outer &&
                       (a.disc->opacity < 1.0) == (b.disc->opacity < 1.0));
}

ImU32 heat(double value) {
    const auto colour = heat_colour(value, kPixelHeat);
    return IM_COL32(colour[0], colour[1], colour[2], 255);
}

// The colour bar with a tick and a power of ten at each decade; takes its place in the window.
void colour_bar(float width, float height) {
    constexpr int kSlices = 96;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const double low = std::log10(kPixelHeat.low), high = std::log10(kPixelHeat.high);
    for (int i = 0; i < kSlices; ++i) {
        const double value = std::pow(10.0, low + (high - low) * (i + 0.5) / kSlices);
        draw.AddRectFilled({at.x + width * static_cast<float>(i) / kSlices, at.y},
                           {at.x + width * static_cast<float>(i + 1) / kSlices, at.y + height}, heat(value));
    }
    draw.AddRect(at, {at.x + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.6f));
    const float tick = 0.3f * ImGui::GetFontSize();
    for (int decade = static_cast<int>(std::lround(low)); decade <= static_cast<int>(std::lround(high)); ++decade) {
        const float x = at.x + width * static_cast<float>((decade - low) / (high - low));
        draw.AddLine({x, at.y + height}, {x, at.y + height + tick}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
        const std::string label = decade == 0 ? "1" : fmt::format("1e{}", decade);
        const float length = ImGui::CalcTextSize(label.c_str()).x;
        const float left = std::clamp(x - 0.5f * length, at.x, at.x + width - length);
        draw.AddText({left, at.y + height + tick}, ImGui::GetColorU32(ImGuiCol_Text), label.c_str());
    }
    ImGui::Dummy({width, height + tick + ImGui::GetFontSize()});
}

std::string state_words(const AccuracyFacts& facts) {
    if (!facts.error.empty()) return facts.error;
    if (!facts.of_this_frame) return "measured when the picture rests";
    if (facts.errors.complete()) return "every pixel measured";
    return fmt::format("measuring: {:.0f} % of the pixels", std::floor(facts.errors.percent()));
}

}  // namespace

FrameAccuracy::FrameAccuracy()
    : watch_([this] {
          news_ = true;
          glfwPostEmptyEvent();
      }) {}

void FrameAccuracy::frame_is(const Scene& scene, const Method& method) {
    if (same_rays(scene, scene_) && method == method_) return;
    scene_ = scene;
    method_ = method;
    watch_.cancel();
    begun_ = asks_ = false;
    changed_at_ = seconds();
}

bool FrameAccuracy::update(bool wanted, bool moving) {
    wanted_ = wanted;
    if (!wanted && begun_ && watch_.measuring()) {
        watch_.cancel();
        begun_ = false;
    }
    asks_ = wanted && !begun_ && !moving && seconds() - changed_at_ >= kRest;
    if (!news_.exchange(false) || !begun_) return false;
    errors_ = watch_.summary();
    return wanted;
}

void FrameAccuracy::take_rays(const Scene& scene, RayFrame rays) {
    if (!asks_ || !same_rays(scene, scene_)) return;
    asks_ = false;
    begun_ = true;
    const Status started = watch_.start(scene_, std::move(rays));
    error_ = started ? std::string() : started.error().message;
    if (started) errors_ = watch_.summary();
}

double FrameAccuracy::wait() const {
    if (!wanted_ || begun_ || asks_) return std::numeric_limits<double>::infinity();
    return std::max(changed_at_ + kRest - seconds(), 0.001);
}

bool FrameAccuracy::at_work() const { return asks_ || watch_.measuring() || news_ || std::isfinite(wait()); }

void FrameAccuracy::draw_overlay() {
    if (!begun_ || !error_.empty()) return;
    if (watch_.take_heat(heat_)) overlay_ = gl::make_rgba8_texture(heat_.width, heat_.height, heat_.data.data());
    if (!overlay_) return;
    const auto texture =
        (ImTextureID)(static_cast<std::intptr_t>(overlay_.id()));  // NOLINT: pointer or integer by version
    ImGui::GetBackgroundDrawList()->AddImage(texture, {0.0f, 0.0f}, ImGui::GetIO().DisplaySize);
}

AccuracyFacts FrameAccuracy::facts() const { return {errors_, begun_, begun_ && !errors_.complete(), error_}; }

void draw_error_legend(const AccuracyFacts& facts, float bottom) {
    const float em = ImGui::GetFontSize(), margin = 0.6f * em;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x - margin, bottom - margin}, ImGuiCond_Always, {1.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.92f);
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoInputs;
    if (ImGui::Begin("##legend", nullptr, kFlags)) {
        const float width = std::min(17.0f * em, std::max(screen.x - 4.0f * margin, 4.0f * em)), swatch = 0.75f * em;
        ImGui::TextUnformatted("Screen error, px");
        const char* fate = "wrong fate";
        const float right = ImGui::CalcTextSize(fate).x + swatch + 0.4f * em;
        ImGui::SameLine(ImGui::GetCursorPosX() + width - right);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float top = at.y + 0.5f * (ImGui::GetTextLineHeight() - swatch);
        ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + swatch, top + swatch},
                                                  heat(std::numeric_limits<double>::infinity()), 0.15f * em);
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + swatch + 0.4f * em);
        ImGui::TextUnformatted(fate);
        colour_bar(width, 0.8f * em);
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        ImGui::TextUnformatted(state_words(facts).c_str());
        ImGui::PopStyleColor();
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
}

}  // namespace nullscope::viewer
