#include "viewer/embedding_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "studio/embedding.h"
#include "studio/palette.h"
#include "studio/view_state.h"
#include "viewer/landmark_circles.h"
#include "viewer/widgets.h"

namespace nullscope::viewer {
namespace {

constexpr double kFarthestShown = 16.0, kWideEmbedding = 1.25,
                 kAboutCircles = 2.5;  // r_s shown at most; of the camera's radius; of the outermost circle's
constexpr double kElevation = 0.45;    // rad, of the eye above the plane
constexpr float kEmbeddingWidth = 17.0f, kLeastEmbeddingWidth = 9.0f;  // em
constexpr int kRings = 10, kMeridians = 24, kRingPoints = 72;
constexpr ImU32 kEmbeddingGround = IM_COL32(6, 8, 14, 255), kEmbeddingGrid = IM_COL32(150, 165, 190, 80),
                kEmbeddingRay = IM_COL32(120, 200, 255, 255);

class Diagram {
public:
    Diagram(const std::vector<EmbeddedCircle>& surface, float width)
        : surface_(surface), corner_(ImGui::GetCursorScreenPos()) {
        double radius = 0.0, low = 0.0, high = 0.0;
        for (const EmbeddedCircle& circle : surface) {
            const double end = circle.areal * std::sin(kElevation), middle = circle.z * std::cos(kElevation);
            radius = std::max(radius, circle.areal), low = std::min(low, middle - end),
            high = std::max(high, middle + end);
        }
        const double margin = 0.5 * em(), room = width - 2.0 * margin;
        scale_ = room / std::max(2.0 * radius, high - low);
        size_ = {width, static_cast<float>(scale_ * (high - low) + 2.0 * margin)};
        middle_x_ = corner_.x + 0.5 * width;
        ground_y_ = corner_.y + margin + scale_ * high;
    }
    ImVec2 size() const { return size_; }

    // x to the right, y away from the eye, z up.
    ImVec2 at(double x, double y, double z) const {
        return {static_cast<float>(middle_x_ + scale_ * x),
                static_cast<float>(ground_y_ - scale_ * (y * std::sin(kElevation) + z * std::cos(kElevation)))};
    }

    void ground() const {
        draw_.AddRectFilled(corner_, {corner_.x + size_.x, corner_.y + size_.y}, kEmbeddingGround);
        for (int i = 0; i < kMeridians; ++i) {
            const double phi = 2.0 * M_PI * i / kMeridians;
            std::vector<ImVec2> line;
            for (const EmbeddedCircle& circle : surface_)
                line.push_back(at(circle.areal * std::cos(phi), circle.areal * std::sin(phi), circle.z));
            draw_.AddPolyline(line.data(), static_cast<int>(line.size()), kEmbeddingGrid, ImDrawFlags_None, 1.0f);
        }
        for (std::size_t i = 0; i <= kRings; ++i) {
            const EmbeddedCircle& circle = surface_[i * (surface_.size() - 1) / kRings];
            ring(circle.areal, circle.z, kEmbeddingGrid, 1.0f);
        }
    }
    void ring(double areal, double z, ImU32 colour, float width) const {
        std::vector<ImVec2> line;
        for (int i = 0; i < kRingPoints; ++i) {
            const double phi = 2.0 * M_PI * i / kRingPoints;
            line.push_back(at(areal * std::cos(phi), areal * std::sin(phi), z));
        }
        draw_.AddPolyline(line.data(), kRingPoints, colour, ImDrawFlags_Closed, width);
    }
    void ray(const ProbeFacts& facts) const {
        std::vector<ImVec2> line;
        for (const PathPoint& point : facts.path)
            if (const auto z = height_at(surface_, point.r)) line.push_back(at(point.x, point.y, *z));
        draw_.AddPolyline(line.data(), static_cast<int>(line.size()), kEmbeddingRay, ImDrawFlags_None, 1.8f);
    }
    void camera(double r, const Spacetime& spacetime) const {
        // Beyond the rim it is on the rim; inside the innermost circle of a surface with one side it is nowhere.
        const double shown =
            std::min(spacetime.by_proper_length() ? std::max(r, surface_.front().r) : r, surface_.back().r);
        if (const auto z = height_at(surface_, shown))
            draw_.AddCircleFilled(at(spacetime.areal_radius(shown), 0.0, *z), 0.25f * em(),
                                  packed(dark_palette().text));
    }

private:
    const std::vector<EmbeddedCircle>& surface_;
    ImDrawList& draw_ = *ImGui::GetWindowDrawList();
    ImVec2 corner_, size_{};
    double scale_ = 1.0, middle_x_ = 0.0, ground_y_ = 0.0;
};

std::string no_embedding(const ViewState& view) {
    const auto spacetime = spacetime_of(view.scene);
    if (spacetime == nullptr || spacetime->spherical() != nullptr) return {};
    return "Not for a rotating hole: only spherical metrics are embedded here.";
}

void draw_embedding(OverlayPlace& place) {
    const Scene& scene = place.scene;
    const ProbeFacts* ray = place.probe.facts_in(scene.spacetime);
    const float margin = 0.6f * em(), padding = ImGui::GetStyle().WindowPadding.x;
    const float width = std::min(kEmbeddingWidth * em(), place.right - place.left - 2.0f * (margin + padding));
    const auto spacetime = spacetime_of(scene);
    if (spacetime == nullptr || spacetime->spherical() == nullptr || width < kLeastEmbeddingWidth * em()) return;
    const auto circles = landmark_circles(*spacetime);
    const double camera = std::fabs(scene.camera.r);
    double high = std::min(kFarthestShown, kWideEmbedding * camera);
    if (!circles.empty()) high = std::max(high, kAboutCircles * circles.back().r);
    const auto surface = embedding(*spacetime->spherical(), high);
    if (surface.size() < 2) return;
    float top = place.bottom;
    overlay("##embedding", place.left + margin, place.bottom - margin, 0.0f, 1.0f, 0.92f, [&] {
        const Diagram diagram(surface, width);
        diagram.ground();
        for (const LandmarkCircle& circle : circles)
            if (const auto z = height_at(surface, circle.r)) diagram.ring(circle.areal, *z, circle.colour, 1.8f);
        if (ray != nullptr) diagram.ray(*ray);
        diagram.camera(scene.camera.r, *spacetime);
        ImGui::Dummy(diagram.size());
        draw_legend(circles, width);
        ImGui::TextDisabled("Embedding diagram");
        top = ImGui::GetWindowPos().y;
    });
    place.bottom = top;
}

}  // namespace

const Overlay kEmbeddingOverlay = {
    "Embedding diagram",
    "",
    0,
    "",
    "Embedding diagram: the equatorial plane as a curved surface, with the camera, the photon sphere, the ISCO and the "
    "probe's ray.",
    no_embedding,
    Overlay::Where::kBottomLeft,
    draw_embedding};

}  // namespace nullscope::viewer
