#include "viewer/potential_plot.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "observer/critical_light.h"
#include "studio/palette.h"
#include "viewer/critical_overlay.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr ImU32 kGround = IM_COL32(6, 8, 14, 255), kBehindWords = IM_COL32(6, 8, 14, 180),
                kCurve = IM_COL32(245, 171, 84, 255), kUnder = IM_COL32(245, 171, 84, 34),
                kRay = IM_COL32(120, 200, 255, 255), kAfter = IM_COL32(120, 200, 255, 120),
                kLevel = IM_COL32(120, 200, 255, 60), kGrid = IM_COL32(255, 255, 255, 22);
constexpr int kSamples = 200;
constexpr double kNearestPlotted = 0.75,
                 kBeyond = 1.5;                       // of the innermost place that is marked; of the camera's radius
constexpr double kLeastWide = 6.0, kMostWide = 60.0;  // r_s that are shown
constexpr double kHeadroom = 1.45;                    // above the peak

class PotentialAxes {
public:
    PotentialAxes(const PotentialRay& ray, const Spacetime& spacetime, const std::vector<LandmarkCircle>& circles,
                  float side)
        : ray_(ray),
          spacetime_(spacetime),
          circles_(circles),
          draw_(*ImGui::GetWindowDrawList()),
          corner_(ImGui::GetCursorScreenPos()),
          side_(side),
          sphere_(open_photon_sphere(spacetime)) {
        if (ray.straight) sphere_.reset();
        choose_width();
        top_ = sphere_ ? sphere_->q_crit * sphere_->q_crit : std::min(potential(low_), ray.level);
        top_ *= kHeadroom;
        if (!(top_ > 0.0 && std::isfinite(top_))) top_ = kHeadroom * potential(low_);
        from_ = {corner_.x + 0.6f * small_, corner_.y + side - 2.6f * small_};
        to_ = {corner_.x + side - 0.6f * small_, corner_.y + 1.7f * small_};
    }

    void draw() const {
        draw_.AddRectFilled(corner_, {corner_.x + side_, corner_.y + side_}, kGround);
        draw_.PushClipRect(corner_, {corner_.x + side_, corner_.y + side_}, true);
        grid();
        curve();
        marks();
        level();
        draw_.PopClipRect();
        ImGui::Dummy({side_, side_});
    }

private:
    double potential(double r) const {
        const double areal = spacetime_.areal_radius(r);
        return (ray_.straight ? 1.0 : spacetime_.lapse_squared(r)) / (areal * areal);
    }

    void choose_width() {
        const double camera = ray_.camera;
        if (spacetime_.by_proper_length()) {
            high_ = std::clamp(kBeyond * std::fabs(camera), kLeastWide, kMostWide), low_ = -high_;
            return;
        }
        low_ = ray_.straight ? 0.1 * camera : camera;
        for (const LandmarkCircle& circle : circles_) low_ = std::min(low_, circle.r);
        if (circles_.empty()) low_ = std::min(0.1 * camera, ray_.turn.value_or(camera));
        low_ *= kNearestPlotted;
        high_ = std::clamp(kBeyond * camera, kLeastWide, kMostWide);
        high_ = std::max(high_, 4.0 * low_);
    }

    float x_of(double r) const {
        const bool linear = spacetime_.by_proper_length();
        const double part =
            linear ? (r - low_) / (high_ - low_) : std::log(std::max(r, 1e-300) / low_) / std::log(high_ / low_);
        return from_.x + static_cast<float>(std::clamp(part, 0.0, 1.0)) * (to_.x - from_.x);
    }
    double r_at(double part) const {
        return spacetime_.by_proper_length() ? low_ + part * (high_ - low_) : low_ * std::pow(high_ / low_, part);
    }
    float y_of(double v) const {
        return from_.y - static_cast<float>(std::clamp(v / top_, -0.2, 1.0)) * (from_.y - to_.y);
    }

    void grid() const {
        const ImU32 ink = packed(dark_palette().dim);
        title();
        const bool linear = spacetime_.by_proper_length();
        text(to_.x, from_.y + 1.3f * small_, linear ? "l" : "r / r_s", 1.0f, ink);
        draw_.AddLine(from_, {to_.x, from_.y}, kGrid);
        float free_from = corner_.x;
        for (const double r : ticks()) {
            const std::string words = fmt::format("{:g}", r);
            const float x = x_of(r), half = 0.5f * wide(words);
            draw_.AddLine({x, from_.y}, {x, to_.y}, kGrid);
            if (x - half < free_from || x + half > corner_.x + side_) continue;
            text(x, from_.y + 0.2f * small_, words, 0.5f, ink);
            free_from = x + half + 0.5f * small_;
        }
    }
    void title() const {
        const float y = corner_.y + 0.3f * small_;
        const std::string peak = sphere_ ? fmt::format("1/b_c\u00b2 = {:.3g}", sphere_->q_crit * sphere_->q_crit) : "";
        text(to_.x, y, peak, 1.0f, kCriticalColour);
        const std::string name = "V = A/R\u00b2";
        const bool fits = from_.x + wide(name) + small_ < to_.x - wide(peak);
        text(from_.x, y, fits ? name : "V", 0.0f, kCurve);
    }
    std::vector<double> ticks() const {
        std::vector<double> found;
        if (spacetime_.by_proper_length()) {
            const double step = high_ > 20.0 ? 20.0 : high_ > 8.0 ? 5.0 : 2.0;
            for (double l = std::ceil(low_ / step) * step; l <= high_; l += step) found.push_back(l);
            return found;
        }
        for (double decade = 1e-3; decade <= 100.0; decade *= 10.0)
            for (const double digit : {1.0, 2.0, 5.0})
                if (digit * decade >= low_ && digit * decade <= high_) found.push_back(digit * decade);
        return found;
    }

    // Light cannot be below it.
    void curve() const {
        draw_.PushClipRect({from_.x, to_.y}, {to_.x, from_.y}, true);
        const ImDrawListFlags flags = std::exchange(draw_.Flags, draw_.Flags & ~ImDrawListFlags_AntiAliasedFill);
        ImVec2 last{};
        for (int i = 0; i <= kSamples; ++i) {
            const double r = r_at(static_cast<double>(i) / kSamples), v = potential(r);
            const ImVec2 at{x_of(r), y_of(std::isfinite(v) ? v : 0.0)};
            const bool seen = v <= top_ && r >= spacetime_.surface_radius().value_or(low_);
            if (i > 0 && seen) {
                draw_.AddQuadFilled(last, at, {at.x, from_.y}, {last.x, from_.y}, kUnder);
                draw_.AddLine(last, at, kCurve, 1.5f);
            }
            last = at;
        }
        draw_.Flags = flags;
        draw_.PopClipRect();
    }

    // Horizon, photon sphere with its level, and so on.
    void marks() const {
        for (const LandmarkCircle& circle : circles_) {
            const float x = x_of(circle.r);
            const ImU32 faint = (circle.colour & 0x00ffffffu) | 0x90000000u;
            if (circle.filled)
                draw_.AddRectFilled({from_.x, to_.y}, {x, from_.y}, (circle.colour & 0x00ffffffu) | 0x50000000u);
            draw_.AddLine({x, to_.y}, {x, from_.y}, faint, 1.0f);
        }
        if (!sphere_) return;
        const double peak = sphere_->q_crit * sphere_->q_crit;
        draw_.AddCircleFilled({x_of(sphere_->radius), y_of(peak)}, 0.22f * small_, kCriticalColour);
    }

    void level() const {
        if (std::isnan(ray_.level)) return;  // of no positive energy
        const float y = y_of(ray_.level);
        const bool above = !(ray_.level < top_);
        draw_.AddLine({from_.x, y}, {to_.x, y}, kLevel);
        const double end = ray_.end.value_or(ray_.turn.value_or(ray_.camera));
        const double far = ray_.turn.value_or(end);
        if (ray_.turn) draw_.AddLine({x_of(*ray_.turn), y + 2.0f}, {x_of(end), y + 2.0f}, kAfter, 1.0f);
        draw_.AddLine({x_of(ray_.camera), y}, {x_of(far), y}, kRay, 2.0f);
        arrow(x_of(end), y + (ray_.turn ? 2.0f : 0.0f), end > far || (!ray_.turn && end > ray_.camera));
        const ImU32 bright = packed(dark_palette().text);
        if (ray_.turn) draw_.AddCircle({x_of(*ray_.turn), y}, 3.5f, bright);
        if (ray_.camera >= low_ && ray_.camera <= high_) draw_.AddCircleFilled({x_of(ray_.camera), y}, 3.0f, bright);
        const std::string words = fmt::format("1/b\u00b2 = {:.3g}", ray_.level);
        const float top = y + (above ? 0.3f : -1.25f) * small_;
        draw_.AddRectFilled({to_.x - wide(words) - 0.2f * small_, top}, {to_.x, top + small_}, kBehindWords);
        text(to_.x, top, words, 1.0f, kRay);
    }
    void arrow(float x, float y, bool right) const {
        const float tip = std::clamp(x, from_.x, to_.x), size = 0.4f * small_, back = right ? -size : size;
        draw_.AddTriangleFilled({tip, y}, {tip + back, y - 0.6f * size}, {tip + back, y + 0.6f * size}, kRay);
    }

    float wide(const std::string& words) const { return ImGui::CalcTextSize(words.c_str()).x * small_ / em_; }
    void text(float x, float y, const std::string& words, float align, ImU32 colour) const {
        draw_.AddText(ImGui::GetFont(), small_, {x - align * wide(words), y}, colour, words.c_str());
    }

    const PotentialRay& ray_;
    const Spacetime& spacetime_;
    const std::vector<LandmarkCircle>& circles_;
    ImDrawList& draw_;
    ImVec2 corner_, from_{}, to_{};  // of the square; lower left and upper right corner of the axes
    float side_;
    std::optional<PhotonSphere> sphere_;
    double low_ = 0, high_ = 0, top_ = 0;
    const float em_ = ImGui::GetFontSize(), small_ = 0.8f * em_;
};

}  // namespace

void draw_potential(const PotentialRay& ray, const Spacetime& spacetime, const std::vector<LandmarkCircle>& circles,
                    float side) {
    PotentialAxes(ray, spacetime, circles, side).draw();
}

}  // namespace nullscope::viewer
