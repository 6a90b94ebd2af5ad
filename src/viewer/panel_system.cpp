#include "viewer/panel_system.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <cmath>

#include "annotate/lettering.h"

namespace nullscope::viewer {
namespace {

constexpr const char* kShaderVersion = "#version 330 core";
constexpr float kFontSize = 15.0f;  // units of ImGui's coordinates at a content scale of 1

void load_font(double pixels) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    const auto file = sans_font_file();
    if (file && fonts.AddFontFromFileTTF(file->c_str(), static_cast<float>(std::round(pixels))) != nullptr) return;
    constexpr float kBitmapFont = 13.0f;  // sharp only in whole multiples
    ImFontConfig config;
    config.SizePixels = kBitmapFont * std::fmax(1.0f, std::round(static_cast<float>(pixels) / kBitmapFont));
    fonts.AddFontDefault(&config);
}

void colour(ImGuiStyle& style) {
    const ImVec4 text{0.90f, 0.91f, 0.93f, 1.00f}, dim{0.58f, 0.61f, 0.66f, 1.00f},
        panel{0.045f, 0.050f, 0.065f, 0.82f};
    const ImVec4 field{0.16f, 0.18f, 0.22f, 0.75f}, over{0.24f, 0.27f, 0.33f, 0.85f}, held{0.31f, 0.34f, 0.41f, 0.95f};
    const ImVec4 accent{0.96f, 0.67f, 0.33f, 1.00f}, faint{1.00f, 1.00f, 1.00f, 0.07f};
    ImGui::StyleColorsDark(&style);
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = text;
    c[ImGuiCol_TextDisabled] = dim;
    c[ImGuiCol_WindowBg] = panel;
    c[ImGuiCol_MenuBarBg] = {panel.x, panel.y, panel.z, 0.97f};
    c[ImGuiCol_PopupBg] = {panel.x, panel.y, panel.z, 0.97f};
    c[ImGuiCol_Separator] = faint;
    c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = field;
    c[ImGuiCol_Border] = {1.00f, 1.00f, 1.00f, 0.16f};  // of boxes over a bright disc too
    c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = c[ImGuiCol_HeaderHovered] = over;
    c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = c[ImGuiCol_HeaderActive] = held;
    c[ImGuiCol_Header] = {0.13f, 0.145f, 0.18f, 0.60f};
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_Header];
    c[ImGuiCol_CheckMark] = accent;
    c[ImGuiCol_SliderGrab] = {accent.x, accent.y, accent.z, 0.60f};  // the number shows through
    c[ImGuiCol_SliderGrabActive] = {accent.x, accent.y, accent.z, 0.85f};
    c[ImGuiCol_TextSelectedBg] = {accent.x, accent.y, accent.z, 0.35f};
    c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
    c[ImGuiCol_ResizeGrip] = {0, 0, 0, 0};
}

// Sets style and fonts anew. content_scale: how much larger than usual, in framebuffer pixels; pixel_ratio: framebuffer
// pixels a unit of ImGui's coordinates. Only between frames.
void apply_theme(double content_scale, double pixel_ratio) {
    ImGuiStyle style;
    style.WindowRounding = 6.0f;
    style.FrameRounding = style.PopupRounding = style.GrabRounding = 3.0f;
    style.ScrollbarRounding = 6.0f;
    style.ScrollbarSize = 10.0f;
    style.GrabMinSize = 9.0f;
    style.WindowPadding = {10.0f, 8.0f};
    style.FramePadding = {6.0f, 3.0f};
    style.ItemSpacing = {7.0f, 4.0f};
    style.ItemInnerSpacing = {5.0f, 4.0f};
    style.WindowBorderSize = style.PopupBorderSize = style.FrameBorderSize = 1.0f;
    colour(style);
    style.ScaleAllSizes(static_cast<float>(content_scale / pixel_ratio));
    ImGui::GetStyle() = style;
    load_font(static_cast<double>(kFontSize) * content_scale);
    ImGui::GetIO().FontGlobalScale = static_cast<float>(1.0 / pixel_ratio);
}

}  // namespace

PanelSystem::PanelSystem(Window& window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // leaves no file behind
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init(kShaderVersion);
}

PanelSystem::~PanelSystem() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void PanelSystem::begin_frame(double text_scale) {
    const double scale = text_scale * window_.content_scale(), ratio = window_.pixel_ratio();
    if (scale != content_scale_ || ratio != pixel_ratio_) {
        content_scale_ = scale, pixel_ratio_ = ratio;
        ImGui_ImplOpenGL3_Shutdown();  // version 1.86 keeps the sizes of buffers that it destroys: so all of it anew
        apply_theme(scale, ratio);
        ImGui_ImplOpenGL3_Init(kShaderVersion);
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

}  // namespace nullscope::viewer
