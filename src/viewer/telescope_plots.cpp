#include "viewer/telescope_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "studio/palette.h"
#include "viewer/texture_id.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr ImU32 kTelescopeGround = IM_COL32(14, 15, 19, 255);  // in either theme
constexpr ImU32 kTelescopeCurve = IM_COL32(120, 200, 255, 255), kTelescopeGrid = IM_COL32(150, 165, 190, 60),
                kTelescopeTrack = IM_COL32(120, 200, 255, 190);
constexpr float kSmallText = 0.85f;

// The least of 1, 2 and 5 times a power of ten that divides a length into at most so many parts.
double step_of(double length, int most) {
    const double power = std::pow(10.0, std::floor(std::log10(length / most)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (length <= most * digit * power * (1 + 1e-9)) return digit * power;
    return 10 * power;
}

// A dark rectangle with lines and numbers: inside of it (x, y) from low to high.
class PlotFrame {
public:
    PlotFrame(ImVec2 size, double low_x, double high_x, double low_y, double high_y)
        : from_(ImGui::GetCursorScreenPos()),
          to_{from_.x + size.x, from_.y + size.y},
          low_x_(low_x),
          high_x_(high_x),
          low_y_(low_y),
          high_y_(high_y) {
        inner_from_ = {from_.x + 0.4f * em(), from_.y + 0.3f * em()};
        inner_to_ = {to_.x - 0.6f * em(), to_.y - 1.1f * em()};
        draw_.AddRectFilled(from_, to_, kTelescopeGround);
        ImGui::Dummy(size);
    }
    ImVec2 at(double x, double y) const {
        const auto part = [](double v, double low, double high) {
            return static_cast<float>((v - low) / (high - low));
        };
        return {inner_from_.x + part(x, low_x_, high_x_) * (inner_to_.x - inner_from_.x),
                inner_to_.y - part(y, low_y_, high_y_) * (inner_to_.y - inner_from_.y)};
    }
    void line_x(double x, const std::string& words) const {
        const float left = at(x, low_y_).x;
        draw_.AddLine({left, inner_from_.y}, {left, inner_to_.y}, kTelescopeGrid);
        const float half = 0.5f * text_width(words);
        text({std::clamp(left - half, from_.x + 2.0f, to_.x - 2.0f * half - 2.0f), inner_to_.y + 0.1f * em()}, words);
    }
    void line_y(double y) const {
        const float top = at(low_x_, y).y;
        draw_.AddLine({inner_from_.x, top}, {inner_to_.x, top}, kTelescopeGrid);
    }
    void text(ImVec2 place, const std::string& words) const {
        draw_.AddText(ImGui::GetFont(), kSmallText * em(), {std::round(place.x), std::round(place.y)},
                      packed(dark_palette().dim), words.c_str());
    }
    static float text_width(const std::string& words) { return kSmallText * ImGui::CalcTextSize(words.c_str()).x; }
    // Words in the right upper corner.
    void corner(const std::string& words) const { text({inner_to_.x - text_width(words), inner_from_.y}, words); }
    ImDrawList& draw() const { return draw_; }
    ImVec2 inner_from() const { return inner_from_; }
    ImVec2 inner_to() const { return inner_to_; }

private:
    ImDrawList& draw_ = *ImGui::GetWindowDrawList();
    ImVec2 from_, to_, inner_from_{}, inner_to_{};
    double low_x_, high_x_, low_y_, high_y_;
};

void lines_of_hours(const PlotFrame& frame, double end, const NumberStyle& style) {
    const double step = end == 24.0 ? 6.0 : step_of(end, 3);
    for (int i = 0; i * step <= end * (1 + 1e-9); ++i)
        frame.line_x(i * step, number_words(i * step, style, 3) + ((i + 1) * step > end * (1 + 1e-9) ? " h" : ""));
}

}  // namespace

Image<unsigned char> plane_picture(const Image<float>& plane) {
    constexpr double kBrightest = 190;  // of 255: tracks are seen over it
    const float most = *std::ranges::max_element(plane.data);
    Image<unsigned char> picture(plane.width, plane.height, 4);
    for (std::size_t i = 0; i < plane.data.size(); ++i) {
        const auto level = most > 0 ? static_cast<unsigned char>(kBrightest * std::sqrt(plane.data[i] / most)) : 0;
        for (std::size_t c = 0; c < 3; ++c) picture.data[4 * i + c] = static_cast<unsigned char>(level);
        picture.data[4 * i + 3] = 255;
    }
    return picture;
}

void draw_amplitudes(const LiveTelescope& telescope, const NumberStyle& style, ImVec2 size) {
    const LiveView& view = telescope.view();
    const double longest = telescope.wish().longest_glambda, whole = view.amplitudes.front();
    const PlotFrame frame(size, 0, longest, 0, 1.04 * whole);
    const double step = step_of(longest, 6);
    for (int i = 0; i * step <= longest * (1 + 1e-9); ++i) frame.line_x(i * step, number_words(i * step, style, 4));
    for (const double part : {0.0, 0.5, 1.0}) frame.line_y(part * whole);
    std::vector<ImVec2> line;
    for (std::size_t i = 0; i < view.amplitudes.size(); ++i)
        line.push_back(frame.at(longest * static_cast<double>(i) / static_cast<double>(view.amplitudes.size() - 1),
                                view.amplitudes[i]));
    frame.draw().AddPolyline(line.data(), static_cast<int>(line.size()), kTelescopeCurve, ImDrawFlags_None, 1.8f);
    if (view.minimum) {
        const double length = 1e-9 * std::hypot(view.minimum->baseline.u, view.minimum->baseline.v);
        const ImVec2 least = frame.at(length, view.minimum->amplitude);
        const ImU32 accent = packed(dark_palette().accent);
        frame.draw().AddLine({least.x, frame.inner_from().y}, {least.x, frame.inner_to().y}, accent);
        frame.draw().AddCircleFilled(least, 0.26f * em(), accent);
    }
    frame.corner(telescope.source().unit ? "|V| against G\xce\xbb; top: " + number_words(whole, style, 3) + " Jy"
                                         : "|V| against G\xce\xbb; top: all light");
}

void draw_tracks(const LiveTelescope& telescope, const gl::Texture& plane, float side) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 from = ImGui::GetCursorScreenPos(), to{from.x + side, from.y + side};
    draw.AddImage(id_of(plane), from, to);
    const double longest = 1e9 * telescope.wish().longest_glambda;
    const auto at = [&](double u, double v) {
        return ImVec2{from.x + 0.5f * side * static_cast<float>(1 - u / longest),
                      from.y + 0.5f * side * static_cast<float>(1 - v / longest)};
    };
    draw.AddLine({from.x, at(0, 0).y}, {to.x, at(0, 0).y}, kTelescopeGrid);
    draw.AddLine({at(0, 0).x, from.y}, {at(0, 0).x, to.y}, kTelescopeGrid);
    draw.PushClipRect(from, to, true);
    const Observation& day = telescope.day();
    const auto& triangles = telescope.triangles();
    const std::size_t index = telescope.wish().triangle;
    const auto of_triangle = [&](const StationPair& pair) {
        return index < triangles.size() && std::ranges::count(triangles[index], pair.first) > 0 &&
               std::ranges::count(triangles[index], pair.second) > 0;
    };
    const float radius = 0.075f * em();
    for (const bool chosen : {false, true})
        for (std::size_t i = 0; i < day.pairs.size(); ++i) {
            if (of_triangle(day.pairs[i]) != chosen) continue;
            const auto [u, v] = day.baselines[i];
            const ImU32 colour = chosen ? packed(dark_palette().accent) : kTelescopeTrack;
            for (const double sign : {1.0, -1.0}) {
                const ImVec2 dot = at(sign * u, sign * v);
                draw.AddRectFilled({dot.x - radius, dot.y - radius}, {dot.x + radius, dot.y + radius}, colour);
            }
        }
    draw.PopClipRect();
    const double angle = telescope.wish().angle_deg * M_PI / 180;
    draw.AddLine(at(0, 0), at(0.97 * longest * std::sin(angle), 0.97 * longest * std::cos(angle)),
                 IM_COL32(255, 255, 255, 120));
    const auto letter = [&](ImVec2 place, const char* words) {
        draw.AddText(ImGui::GetFont(), kSmallText * em(), place, packed(dark_palette().text), words);
    };
    letter({from.x + 0.2f * em(), at(0, 0).y - 1.0f * em()}, "E");
    letter({at(0, 0).x + 0.25f * em(), from.y + 0.05f * em()}, "N");
    ImGui::Dummy({side, side});
}

void draw_closure(const LiveTelescope& telescope, const NumberStyle& style, ImVec2 size) {
    const auto by_time = telescope.by_time();
    const bool moves = !by_time.empty();
    const double begun = moves ? by_time.front().hours : 0.0, end = moves ? by_time.back().hours - begun : 24.0;
    const PlotFrame frame(size, 0, end, -180, 180);
    lines_of_hours(frame, end, style);
    for (const double phase : {-180.0, -90.0, 0.0, 90.0, 180.0}) frame.line_y(phase);
    const float radius = 0.1f * em();
    const auto dot = [&](double hours, double phase) {
        const ImVec2 at = frame.at(hours, phase * 180 / M_PI);
        frame.draw().AddRectFilled({at.x - radius, at.y - radius}, {at.x + radius, at.y + radius},
                                   packed(dark_palette().accent));
    };
    if (moves)
        for (const TimedPhase& each : by_time) dot(each.hours - begun, each.phase);
    else
        for (const TrianglePhase& each : telescope.view().phases) dot(each.hour, each.phase);
    const float left = frame.inner_from().x + 0.2f * em();
    frame.text({left, frame.inner_from().y}, "180\xc2\xb0");
    frame.text({left, frame.inner_to().y - kSmallText * em()}, "-180\xc2\xb0");
}

void draw_beam(ImDrawList& draw, ImVec2 middle, const Beam& beam, double per_rad) {
    constexpr int kPoints = 48;
    std::vector<ImVec2> outline;
    const double s = std::sin(beam.angle), c = std::cos(beam.angle);
    for (int i = 0; i < kPoints; ++i) {
        const double turn = 2 * M_PI * i / kPoints;
        const double along = 0.5 * per_rad * beam.major * std::cos(turn),
                     across = 0.5 * per_rad * beam.minor * std::sin(turn);
        outline.push_back({middle.x - static_cast<float>(along * s + across * c),
                           middle.y - static_cast<float>(along * c - across * s)});
    }
    draw.AddConvexPolyFilled(outline.data(), kPoints, IM_COL32(235, 235, 235, 60));
    draw.AddPolyline(outline.data(), kPoints, IM_COL32(0, 0, 0, 160), ImDrawFlags_Closed, 3.0f);
    draw.AddPolyline(outline.data(), kPoints, IM_COL32(235, 235, 235, 255), ImDrawFlags_Closed, 1.4f);
}

}  // namespace nullscope::viewer
